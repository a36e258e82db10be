// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/table.hpp"

#include <algorithm>
#include <limits>
#include <ostream>
#include <stdexcept>

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

}  // namespace microslip
