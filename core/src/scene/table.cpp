// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/table.hpp"

#include <algorithm>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "microslip/support/format.hpp"

namespace microslip {

namespace {

std::string text_of(const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return format_full(*number);
  return std::get<std::string>(cell);
}

}  // namespace

Table::Table(std::string name, std::string description, std::vector<Column> columns)
    : name_(std::move(name)), description_(std::move(description)), columns_(std::move(columns)) {}

void Table::add(std::vector<Cell> row) {
  if (row.size() != columns_.size()) {
    throw std::logic_error("table " + name_ + ": a row has " + std::to_string(row.size()) +
                           " cells, not " + std::to_string(columns_.size()));
  }
  rows_.push_back(std::move(row));
}

const Cell& Table::at(std::size_t row, const std::string& column) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].name == column) return rows_.at(row)[i];
  }
  throw std::out_of_range("table " + name_ + " has no column " + column);
}

double Table::number(std::size_t row, const std::string& column) const {
  return std::get<double>(at(row, column));
}

double Table::latest(const std::vector<std::pair<std::string, Cell>>& cells,
                     const std::string& column) const {
  for (std::size_t row = rows_.size(); row-- > 0;) {
    const auto has = [&](const auto& cell) { return at(row, cell.first) == cell.second; };
    if (std::all_of(cells.begin(), cells.end(), has)) return number(row, column);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

void Table::write(std::ostream& out, const std::string& program,
                  const Parameters& parameters) const {
  out << "# " << program << ": " << description_ << "\n# parameters\n";
  for (const auto& [key, value] : parameters) out << "#   " << key << " = " << value << '\n';
  out << "# columns\n";
  for (const Column& column : columns_) {
    out << "#   " << column.name << " [" << column.unit << "]: " << column.meaning << '\n';
  }
  const char* separator = "";
  for (const Column& column : columns_) {
    out << separator << column.name;
    separator = "\t";
  }
  out << '\n';
  for (const auto& row : rows_) {
    separator = "";
    for (const Cell& cell : row) {
      out << separator << text_of(cell);
      separator = "\t";
    }
    out << '\n';
  }
}

namespace {

/// A text, line by line and then part by part; what is not as expected throws.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  bool at_end() const { return text_.empty(); }
  bool starts_with(std::string_view begin) const { return text_.starts_with(begin); }

  /// All up to a mark, which is taken, too.
  std::string up_to(std::string_view mark) {
    const std::size_t at = text_.find(mark);
    if (at == std::string_view::npos || text_.substr(0, at).find('\n') != std::string_view::npos) {
      throw std::invalid_argument("expected a whole table of this program");
    }
    const std::string part(text_.substr(0, at));
    text_.remove_prefix(at + mark.size());
    return part;
  }

  std::vector<Cell> cells() {
    std::string line = up_to("\n") + '\t';
    std::vector<Cell> row;
    for (Lines rest(line); !rest.at_end();) row.emplace_back(rest.up_to("\t"));
    return row;
  }

 private:
  std::string_view text_;
};

}  // namespace

WrittenTable read_table(const std::string& name, const std::string& text) {
  Lines lines(text);
  lines.up_to("# ");
  const std::string program = lines.up_to(": ");
  const std::string description = lines.up_to("\n");
  lines.up_to("# parameters\n");
  Parameters parameters;
  while (lines.starts_with("#   ")) {
    lines.up_to("#   ");
    const std::string key = lines.up_to(" = ");
    parameters.emplace_back(key, lines.up_to("\n"));
  }
  lines.up_to("# columns\n");
  std::vector<Column> columns;
  while (lines.starts_with("#   ")) {
    lines.up_to("#   ");
    const std::string column = lines.up_to(" [");
    const std::string unit = lines.up_to("]: ");
    columns.push_back({column, unit, lines.up_to("\n")});
  }
  Table table(name, description, columns);
  lines.up_to("\n");
  while (!lines.at_end()) {
    const std::vector<Cell> row = lines.cells();
    if (row.size() != columns.size())
      throw std::invalid_argument("expected as many cells as names");
    table.add(row);
  }
  std::ostringstream again;
  table.write(again, program, parameters);
  if (again.str() != text)
    throw std::invalid_argument("expected a table as this program writes it");
  return {table, parameters};
}

}  // namespace microslip
