// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace microslip::table_test {

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

// Columns say up to where their numbers are rounding, and so do single rows; both are read back.
TEST(WrittenTable, SaysWhichNumbersAreNothingButRounding) {
  Table table("t", "a table",
              {{"name", "1", "of a row"}, {"value", "1", "v"}, {"residual", "1", "r", 1e-9}});
  table.add({"a = b: c", 1e-16, 2e-16}, {"value", 1e-12});
  table.add({"another", 2.5, 0.5});
  std::ostringstream text;
  table.write(text, "program", {});
  EXPECT_NE(text.str().find("# nothing but rounding\n#   residual up to 1e-09\n"
                            "#   value up to 1e-12 where name = a = b: c\nname\tvalue"),
            std::string::npos)
      << text.str();
  const Table read = read_table("t", text.str()).table;
  EXPECT_EQ(read.rounding(0, "value"), 1e-12);
  EXPECT_EQ(read.rounding(0, "residual"), 1e-9);
  EXPECT_EQ(read.rounding(1, "value"), 0);
  EXPECT_EQ(read.rounding(1, "name"), 0);
  EXPECT_THROW(table.add({"c", 1.0, 1.0}, {"no column", 1e-12}), std::out_of_range);
  EXPECT_EQ(table.rows(), 2U);
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

}  // namespace microslip::table_test
