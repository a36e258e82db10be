// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/text.hpp"

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <stdexcept>
#include <string_view>

namespace microslip {

std::string plain_text(std::string bytes) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    throw std::invalid_argument("line 1: expected text in UTF-8, not UTF-16");
  }
  if (const std::size_t at = bytes.find('\0'); at != std::string::npos) {
    const auto line =
        std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    throw std::invalid_argument("line " + std::to_string(line + 1) +
                                ": expected text in UTF-8, not a NUL byte");
  }
  if (bytes.starts_with(mark)) bytes.erase(0, mark.size());
  boost::algorithm::replace_all(bytes, "\r\n", "\n");
  return bytes;
}

}  // namespace microslip
