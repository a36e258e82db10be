// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// Splits a line at a separator. A cell has no blanks and no quotes around it; a separator between
/// quotes belongs to the cell. A blank as separator stands for any number of blanks and tabs.
std::vector<std::string_view> split_cells(std::string_view line, char separator);

/// Lines of a table. Comments, which begin with #, and lines without text are left out.
class TableLines {
 public:
  explicit TableLines(std::string_view text) : text_(text) {}

  /// The next line; empty at the end.
  std::string_view next();

  /// Number of the line that next() returned.
  int number() const { return number_; }

 private:
  std::string_view text_;
  int number_ = 0;
};

/// The cells of a table below a line of names. The names and the first row say what separates the
/// cells: a comma, a semicolon or a tab, otherwise blanks. A first line "sep=;", as spreadsheets
/// write it, says so, too. Rows without a value are left out.
class TableText {
 public:
  /// \throws std::invalid_argument in one line if there is no line of names
  explicit TableText(std::string_view text);

  /// The cells of the line of names, up to the last one that is not empty. If blanks separate
  /// cells, a name and its unit are two of them.
  std::vector<std::string> header() const;

  bool is_separated_by_blanks() const { return separator_ == ' '; }

  /// Number of the line that was read last.
  int line() const { return lines_.number(); }

  /// Reads the next row. The cells refer to the text.
  /// \param columns  of the table
  /// \return whether there is a row
  /// \throws std::invalid_argument for a row with more or fewer cells than columns
  bool read_row(std::size_t columns, std::vector<std::string_view>& cells);

 private:
  bool fits(char separator, std::string_view row) const;
  char separator_by(std::string_view row) const;
  void require_as_many(std::size_t columns, std::vector<std::string_view>& cells) const;

  TableLines lines_;
  std::string header_;
  char separator_ = ' ';
  bool takes_blanks_ = false;  ///< whether rows may have blanks where the names have tabs
};

/// Numbers of a table with a decimal point, or with a decimal comma: all of them have the same.
class DecimalMarks {
 public:
  /// \param line, column  place of the cell, for messages
  /// \return none if the cell is no finite number
  std::optional<double> number(std::string_view cell, int line, std::string_view column);

  /// \throws std::invalid_argument if numbers have both marks, or if all commas may separate
  ///         thousands, as in 1,234
  void require_one() const;

 private:
  struct Cell {
    std::string text;
    std::string column;
    int line;
  };

  std::optional<Cell> point_, comma_;
  bool is_clear_ = false;  ///< whether a comma can only be a decimal one
};

/// A number with one comma, with a point in its place; none for other texts.
std::optional<std::string> with_decimal_point(std::string_view text);

}  // namespace microslip
