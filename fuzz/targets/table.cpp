// SPDX-License-Identifier: GPL-3.0-or-later
// A table that was written before: what is read is written again as the same bytes.
#include "microslip/scene/table.hpp"

#include <sstream>

#include "reader.hpp"

MICROSLIP_READER(table) {
  using namespace microslip;
  const std::string text = fuzz::text_of(data, size);
  fuzz::accepts_or_rejects([&] {
    const WrittenTable read = read_table("table", text);
    std::ostringstream again;
    read.table.write(again, text.substr(2, text.find(": ") - 2), read.parameters);
    fuzz::require_that(again.str() == text, "the same bytes", again.str());
  });
  return 0;
}
