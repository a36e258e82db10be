// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <istream>
#include <string>
#include <vector>

namespace microslip::tools {

/// How far a number may be from its reference r: relative |r| + of_largest max |r in the column|
/// + absolute.
struct Tolerance {
  double relative = 0;
  double of_largest = 0;
  double absolute = 0;
};

/// Tolerances by table and column.
class Tolerances {
 public:
  /// Lines of: pattern of study/table, pattern of the column (both as of file names), the three
  /// numbers of Tolerance; or `none` instead of the column and the numbers, for a table without a
  /// reference. # starts a comment, and of lines that match the last one counts.
  /// \throws std::invalid_argument with the line that is none
  explicit Tolerances(std::istream& in);

  /// \param table  "study/table", here and below
  bool has_reference(const std::string& table) const;

  /// \throws std::invalid_argument if no line matches
  Tolerance of(const std::string& table, const std::string& column) const;

 private:
  struct Line {
    std::string table;
    std::string column;
    Tolerance tolerance;
  };

  const Line* last(const std::string& table, const std::string& column) const;

  std::vector<Line> lines_;
};

}  // namespace microslip::tools
