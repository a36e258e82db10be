// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace microslip {
namespace {

TEST(WrittenTable, IsReadBackAndWrittenAgainAsTheSameBytes) {
  Table table("t", "a table: of two rows", {{"x", "mm", "a [1]: b"}, {"word", "1", "text"}});
  table.add({0.1, "a = b"});
  table.add({std::nan(""), "c d"});
  std::ostringstream text;
  table.write(text, "program", {{"key", "1 = 2"}, {"empty", ""}});
  const WrittenTable read = read_table("t", text.str());
  EXPECT_EQ(read.parameters, (Parameters{{"key", "1 = 2"}, {"empty", ""}}));
  EXPECT_EQ(std::get<std::string>(read.table.at(1, "word")), "c d");
  std::ostringstream again;
  read.table.write(again, "program", read.parameters);
  EXPECT_EQ(again.str(), text.str());
}

TEST(WrittenTable, APartOfOneIsRejectedUnlessItEndsWithALine) {
  Table table("t", "description", {{"x", "mm", "position"}, {"y", "mm", "position"}});
  table.add({0.1, 0.2});
  std::ostringstream out;
  table.write(out, "program", {{"key", "value"}});
  const std::string text = out.str();
  for (std::size_t length = 0; length < text.size(); ++length) {
    const bool without_row = text.substr(0, length).ends_with("x\ty\n");
    SCOPED_TRACE(length);
    if (without_row) {
      EXPECT_EQ(read_table("t", text.substr(0, length)).table.rows(), 0U);
    } else {
      EXPECT_THROW(read_table("t", text.substr(0, length)), std::invalid_argument);
    }
  }
}

}  // namespace
}  // namespace microslip
