// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "microslip/support/format.hpp"
#include "number.hpp"

namespace microslip {

namespace {

constexpr const char* rounding_mark = "# nothing but rounding\n";

std::string text_of(const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return format_full(*number);
  return std::get<std::string>(cell);
}

}  // namespace

Table::Table(std::string name, std::string description, std::vector<Column> columns)
    : name_(std::move(name)), description_(std::move(description)), columns_(std::move(columns)) {}

bool Table::has(const std::string& column) const {
  return std::ranges::find(columns_, column, &Column::name) != columns_.end();
}

void Table::add(std::vector<Cell> row) {
  if (row.size() != columns_.size()) {
    throw std::logic_error(
        fmt::format("table {}: a row has {} cells, not {}", name_, row.size(), columns_.size()));
  }
  rows_.push_back(std::move(row));
}

void Table::add(std::vector<Cell> row, const Rounding& rounding) {
  index_of(rounding.column);  // throws if there is no such column
  add(std::move(row));
  rounding_.emplace(rows_.size() - 1, rounding);
}

std::size_t Table::index_of(const std::string& column) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].name == column) return i;
  }
  throw std::out_of_range(fmt::format("table {} has no column {}", name_, column));
}

const Cell& Table::at(std::size_t row, const std::string& column) const {
  return rows_.at(row)[index_of(column)];
}

void Table::put(std::size_t row, const std::string& column, Cell cell) {
  rows_.at(row)[index_of(column)] = std::move(cell);
}

double Table::rounding(std::size_t row, const std::string& column) const {
  const double of_column = columns_[index_of(column)].rounding;
  const auto of_row = rounding_.find(row);
  const bool has = of_row != rounding_.end() && of_row->second.column == column;
  return has ? std::max(of_column, of_row->second.bound) : of_column;
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

void Table::write_rounding(std::ostream& out) const {
  const auto any = [](const Column& column) { return column.rounding > 0; };
  if (rounding_.empty() && std::none_of(columns_.begin(), columns_.end(), any)) return;
  out << rounding_mark;
  for (const Column& column : columns_) {
    if (!any(column)) continue;
    out << "#   " << column.name << " up to " << format_short(column.rounding) << '\n';
  }
  for (const auto& [row, rounding] : rounding_) {
    out << "#   " << rounding.column << " up to " << format_short(rounding.bound) << " where "
        << columns_.front().name << " = " << text_of(rows_[row].front()) << '\n';
  }
}

void Table::write(std::ostream& out, const std::string& program,
                  const Parameters& parameters) const {
  out << "# " << program << ": " << description_ << "\n# parameters\n";
  for (const auto& [key, value] : parameters) out << "#   " << key << " = " << value << '\n';
  out << "# columns\n";
  for (const Column& column : columns_) {
    out << "#   " << column.name << " [" << column.unit << "]: " << column.meaning << '\n';
  }
  write_rounding(out);
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

/// Reads a text line by line, and each line piece by piece. Unexpected text throws.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  bool at_end() const { return text_.empty(); }
  bool starts_with(std::string_view begin) const { return text_.starts_with(begin); }

  /// The text up to a mark; the mark is skipped.
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

/// Reads the output of Table::write_rounding. Bounds of columns are stored in `columns`; bounds of
/// rows are returned by the first cell of the row.
std::multimap<std::string, Rounding> read_rounding(Lines& lines, std::vector<Column>& columns) {
  std::multimap<std::string, Rounding> of_rows;
  if (!lines.starts_with(rounding_mark)) return of_rows;
  lines.up_to(rounding_mark);
  while (lines.starts_with("#   ")) {
    lines.up_to("#   ");
    const std::string name = lines.up_to(" up to ");
    const std::string line = lines.up_to("\n") + '\n';
    Lines rest(line);
    const auto column = std::ranges::find(columns, name, &Column::name);
    if (column == columns.end()) throw std::invalid_argument("expected the name of a column");
    const bool of_row = line.find(' ') != std::string::npos;
    const auto bound = finite_number(rest.up_to(of_row ? " where " : "\n"));
    if (!bound) throw std::invalid_argument("expected a bound of rounding");
    if (of_row) {
      rest.up_to(" = ");
      of_rows.emplace(rest.up_to("\n"), Rounding{name, *bound});
    } else {
      column->rounding = *bound;
    }
  }
  return of_rows;
}

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
  std::multimap<std::string, Rounding> of_rows = read_rounding(lines, columns);
  Table table(name, description, columns);
  lines.up_to("\n");
  while (!lines.at_end()) {
    const std::vector<Cell> row = lines.cells();
    if (row.size() != columns.size())
      throw std::invalid_argument("expected as many cells as names");
    const auto rounding = of_rows.extract(std::get<std::string>(row.front()));
    if (rounding) {
      table.add(row, rounding.mapped());
    } else {
      table.add(row);
    }
  }
  std::ostringstream again;
  table.write(again, program, parameters);
  if (again.str() != text)
    throw std::invalid_argument("expected a table as this program writes it");
  return {table, parameters};
}

}  // namespace microslip
