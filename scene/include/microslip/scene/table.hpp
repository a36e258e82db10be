// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <iosfwd>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/scene/scene.hpp"

namespace microslip {

/// A number or a text of a table. Whole numbers are converted.
struct Cell : std::variant<double, std::string> {
  using variant::variant;
  template <std::integral Whole>
  requires(!std::same_as<Whole, bool>) Cell(Whole number) : variant(static_cast<double>(number)) {}
};

/// A column of a table.
struct Column {
  std::string name;
  std::string unit;  ///< "1" for a pure number or text
  std::string meaning;
  /// Numbers of at most this absolute value are rounding errors: they depend on processor and
  /// compiler, and have no reference value. 0 if the column has no such numbers.
  double rounding = 0;
};

/// The limit of rounding errors for one number in a row, for a column with quantities of several
/// kinds.
struct Rounding {
  std::string column;
  double bound;  ///< as Column::rounding
};

/// A named result, which a program writes as NAME.tsv.
class Table {
 public:
  Table(std::string name, std::string description, std::vector<Column> columns);

  const std::string& name() const { return name_; }
  const std::vector<Column>& columns() const { return columns_; }
  bool has(const std::string& column) const;
  std::size_t rows() const { return rows_.size(); }

  /// \throws std::logic_error if the numbers of cells and columns differ
  void add(std::vector<Cell> row);

  /// Adds a row in which one number has its own limit of rounding errors.
  void add(std::vector<Cell> row, const Rounding& rounding);

  /// Replaces a cell.
  /// \throws std::out_of_range if there is no such row or column
  void put(std::size_t row, const std::string& column, Cell cell);

  /// The absolute value up to which the number in that cell is a rounding error; 0 if it never is.
  /// \throws std::out_of_range if there is no such column
  double rounding(std::size_t row, const std::string& column) const;

  /// \throws std::out_of_range if there is no such row or column
  const Cell& at(std::size_t row, const std::string& column) const;
  double number(std::size_t row, const std::string& column) const;

  /// The number in the last row with the given cells, as pairs of column and cell; nan without such
  /// a row.
  double latest(const std::vector<std::pair<std::string, Cell>>& cells,
                const std::string& column) const;

  /// Comment block (program, parameters, columns, bounds of rounding), one header line, rows;
  /// tab-separated, %.17g.
  void write(std::ostream& out, const std::string& program, const Parameters& parameters) const;

 private:
  std::string name_;
  std::string description_;
  std::vector<Column> columns_;
  std::vector<std::vector<Cell>> rows_;
  std::map<std::size_t, Rounding> rounding_;  ///< by row

  std::size_t index_of(const std::string& column) const;
  void write_rounding(std::ostream& out) const;
};

/// A table that was read from a file; all cells are text.
struct WrittenTable {
  Table table;
  Parameters parameters;
};

/// Reads the output of Table::write. Writing the table again gives the same bytes.
/// \throws std::invalid_argument if the text is not a table, or only the beginning of one
WrittenTable read_table(const std::string& name, const std::string& text);

}  // namespace microslip
