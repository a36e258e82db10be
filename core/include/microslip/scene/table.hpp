// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/scene/scene.hpp"

namespace microslip {

using Cell = std::variant<double, std::string>;

/// A column of a table.
struct Column {
  std::string name;
  std::string unit;  ///< "1" if it has none
  std::string meaning;
};

/// A named result: what a program writes as NAME.tsv.
class Table {
 public:
  Table(std::string name, std::string description, std::vector<Column> columns);

  const std::string& name() const { return name_; }
  const std::vector<Column>& columns() const { return columns_; }
  std::size_t rows() const { return rows_.size(); }

  /// \throws std::logic_error if the number of cells is not that of the columns
  void add(std::vector<Cell> row);

  /// \throws std::out_of_range if there is no such row or column
  const Cell& at(std::size_t row, const std::string& column) const;
  double number(std::size_t row, const std::string& column) const;

  /// The number in the last row that has these cells, as pairs of column and cell; nan if none has.
  double latest(const std::vector<std::pair<std::string, Cell>>& cells,
                const std::string& column) const;

  /// Comment block (program, parameters, columns), one header line, rows; tab-separated, %.17g.
  void write(std::ostream& out, const std::string& program, const Parameters& parameters) const;

 private:
  std::string name_;
  std::string description_;
  std::vector<Column> columns_;
  std::vector<std::vector<Cell>> rows_;
};

/// A table as it was written; all cells are text.
struct WrittenTable {
  Table table;
  Parameters parameters;
};

/// Reads what Table::write wrote; written again, it is the same bytes.
/// \throws std::invalid_argument if the text is something else, or only the beginning of it
WrittenTable read_table(const std::string& name, const std::string& text);

}  // namespace microslip
