// SPDX-License-Identifier: GPL-3.0-or-later
#include "columns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <stdexcept>

#include "cells.hpp"
#include "microslip/scene/units.hpp"
#include "microslip/support/nearest.hpp"
#include "microslip/support/shown.hpp"
#include "number.hpp"

namespace microslip {

namespace {

/// The first name that occurs twice among those that are not empty; empty if none does.
std::string repeated(std::vector<std::string> names) {
  std::erase(names, "");
  std::sort(names.begin(), names.end());
  const auto found = std::adjacent_find(names.begin(), names.end());
  return found == names.end() ? "" : *found;
}

/// Whether a text is a unit in brackets, or in parentheses: other words in these are no units.
bool is_unit_in_brackets(const std::string& text) {
  if (text.starts_with('[')) return text.ends_with(']');
  return text.size() > 2 && text.ends_with(')') &&
         (text == "(-)" || is_unit(text.substr(1, text.size() - 2)));
}

/// Puts the words of a unit behind their name: "I", "[N", "s^2]" is "I [N s^2]".
std::vector<std::string> cells_with_units(const std::vector<std::string>& words) {
  constexpr std::size_t most_words = 8;  // of a unit
  std::vector<std::string> cells;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool is_behind = !cells.empty() && (words[i][0] == '[' || words[i][0] == '(');
    const std::size_t begin = is_behind ? 0 : words[i].find_first_of("[(", 1);
    std::string unit = begin == std::string::npos ? "" : words[i].substr(begin);
    std::size_t last = i;
    while (!unit.empty() && !is_unit_in_brackets(unit) && last + 1 < words.size() &&
           last < i + most_words) {
      unit += ' ' + words[++last];
    }
    if (!is_unit_in_brackets(unit)) {
      cells.push_back(words[i]);
      continue;
    }
    if (!is_behind) cells.push_back(words[i].substr(0, begin));
    cells.back() += ' ' + unit;
    i = last;
  }
  return cells;
}

/// Names and units of columns.
struct Header {
  std::vector<std::string> names;
  std::vector<std::string> units;
};

Header header_of(const TableText& table) {
  const std::vector<std::string> cells =
      table.is_separated_by_blanks() ? cells_with_units(table.header()) : table.header();
  Header header;
  for (const std::string& cell : cells) {
    const auto [name, unit] = name_with_unit(cell);
    header.names.push_back(name);
    header.units.push_back(unit);
  }
  return header;
}

[[noreturn]] void fail_in(int line, const std::string& what) {
  throw std::invalid_argument(fmt::format("line {}: {}", line, what));
}

void require_names_once(const Header& header, int line) {
  const std::string name = repeated(header.names);
  if (name.empty()) return;
  fail_in(line, fmt::format("expected one column '{}', found more of that name", shown(name)));
}

/// The name of a column in a file.
const std::string& name_in_file(const FileColumn& column) {
  return column.in_file.empty() ? column.name : column.in_file;
}

/// In small letters, with _ between words.
std::string plain_name(std::string name) {
  boost::algorithm::to_lower(name);
  std::ranges::replace(name, ' ', '_');
  std::ranges::replace(name, '-', '_');
  return name;
}

/// The wanted column that a name is meant for: in other letters, or with a third of them at most
/// changed. Names of one letter are too many words.
std::string meant_column(const std::string& name, const std::vector<FileColumn>& wanted) {
  const std::string small = plain_name(name);
  for (const FileColumn& column : wanted) {
    if (column.name.size() == 1) continue;
    const std::size_t most = std::min<std::size_t>(3, column.name.size() / 3);
    if (small == column.name || !nearest(small, {column.name}, most).empty()) return column.name;
  }
  return "";
}

/// Where columns may be missing, a misspelt one would be: the names that are not wanted.
/// \throws std::invalid_argument for a name that is nearly a wanted one
std::vector<std::string> unused_of(const Header& header, const std::vector<FileColumn>& wanted,
                                   int line) {
  std::vector<std::string> unused;
  if (std::ranges::all_of(wanted, &FileColumn::needed)) return unused;
  for (const std::string& name : header.names) {
    const bool is_wanted = std::ranges::find(wanted, name, name_in_file) != wanted.end();
    if (is_wanted || name.empty() || name.starts_with('_')) continue;
    const bool is_replaced = std::ranges::find(wanted, name, &FileColumn::name) != wanted.end();
    const std::string meant = is_replaced ? "" : meant_column(name, wanted);
    if (!meant.empty()) {
      fail_in(line, fmt::format("unknown column '{}'{}; one that is not to be read has a name that "
                                "begins with _",
                                shown(name), suggestion(meant)));
    }
    unused.push_back(name);
  }
  return unused;
}

/// A wanted column in a file.
struct Found {
  std::size_t place;
  double factor;  ///< conversion from the unit in the file
  std::vector<double> values = {};
};

[[noreturn]] void fail_without(const FileColumn& column, const Header& header, int line) {
  const std::string& name = name_in_file(column);
  const auto alike = std::ranges::find(header.names, plain_name(name), plain_name);
  const std::string near =
      alike != header.names.end() ? *alike : nearest(name, header.names, name.size() / 3);
  fail_in(line,
          fmt::format("expected a column '{}' among the names in the first line, which are: {}{}",
                      shown(name), shown(joined(header.names, " ")), suggestion(near)));
}

std::optional<Found> find_in(const Header& header, const FileColumn& column, int line) {
  const auto named_so = std::ranges::find(header.names, name_in_file(column));
  if (named_so == header.names.end()) {
    if (!column.needed && column.in_file.empty()) return std::nullopt;
    fail_without(column, header, line);
  }
  const auto place = static_cast<std::size_t>(named_so - header.names.begin());
  const std::string& given = column.unit_without;
  const std::string& unit = header.units[place].empty() ? given : header.units[place];
  if (!given.empty() && unit != given) {
    fail_in(line, fmt::format("column '{}': unit '{}' in the file, '{}' in the scene",
                              shown(name_in_file(column)), shown(unit), shown(given)));
  }
  const auto factor = quantity(unit.empty() ? "1" : "1 " + unit, column.unit);
  if (factor) return Found{place, *factor};
  fail_in(line, fmt::format("column '{}': unit '{}': expected {}{}", shown(name_in_file(column)),
                            shown(unit), accepted_units(column.unit),
                            advice_on_width("1 " + unit, column.unit)));
}

/// Says why a cell may be no number.
std::string advice_on_cell(std::string_view cell) {
  if (is_unit(cell)) return "; a unit stands behind its name, as in t [s]";
  std::string digits(cell);
  for (const char* mark : {",", ".", "'", " ", "\u00a0", "\u2009", "\u202f", "\u2019"}) {
    boost::algorithm::erase_all(digits, mark);
  }
  return digits != cell && finite_number(digits) ? " without separators of thousands"
                                                 : advice(std::string(cell));
}

}  // namespace

ReadColumns read_columns(std::string_view text, const std::vector<FileColumn>& wanted) {
  TableText table(text);
  const Header header = header_of(table);
  std::vector<std::optional<Found>> found;
  for (const FileColumn& column : wanted) found.push_back(find_in(header, column, table.line()));
  require_names_once(header, table.line());
  ReadColumns read{.wanted = {}, .unused = unused_of(header, wanted, table.line())};
  DecimalMarks numbers;
  std::size_t rows = 0;
  for (std::vector<std::string_view> row; table.read_row(header.names.size(), row); ++rows) {
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (!found[k]) continue;
      const std::string_view cell = row[found[k]->place];
      const std::string& name = name_in_file(wanted[k]);
      const auto value = numbers.number(cell, table.line(), name);
      if (!value) {
        fail_in(table.line(), fmt::format("column '{}': '{}' is not a finite number{}", shown(name),
                                          shown(cell), advice_on_cell(cell)));
      }
      found[k]->values.push_back(found[k]->factor * *value);
    }
  }
  if (rows == 0) fail_in(table.line(), "expected at least one row below the names");
  numbers.require_one();
  for (const std::optional<Found>& column : found) {
    read.wanted.emplace_back();
    if (!column) continue;
    read.wanted.back() = Eigen::Map<const Eigen::VectorXd>(
        column->values.data(), static_cast<Eigen::Index>(column->values.size()));
  }
  return read;
}

NamedUnit name_with_unit(const std::string& text) {
  const auto split_at = [&](std::size_t begin, char end) {
    const std::string unit = text.substr(begin + 1, text.find(end, begin) - begin - 1);
    const std::string name = text.substr(0, text.find_last_not_of(' ', begin - 1) + 1);
    return NamedUnit{name, unit == "-" ? "1" : unit};
  };
  const std::size_t bracket = text.find('[');
  if (bracket != std::string::npos && bracket > 0) return split_at(bracket, ']');
  const std::size_t parenthesis = text.rfind('(');
  if (!text.ends_with(')') || parenthesis == std::string::npos || parenthesis == 0) return {text};
  const NamedUnit found = split_at(parenthesis, ')');
  return is_unit(found.unit) ? found : NamedUnit{text};
}

std::vector<std::string> column_names(std::string_view text) {
  return header_of(TableText(text)).names;
}

std::vector<TextColumn> read_text_columns(std::string_view text) {
  TableText table(text);
  const Header header = header_of(table);
  require_names_once(header, table.line());
  std::vector<TextColumn> columns;
  for (std::size_t k = 0; k < header.names.size(); ++k) {
    columns.push_back({header.names[k], header.units[k], {}});
  }
  DecimalMarks numbers;
  for (std::vector<std::string_view> row; table.read_row(columns.size(), row);) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const std::string_view cell = row[k];
      if (cell.empty()) {
        fail_in(table.line(), fmt::format("column '{}': expected a value", shown(columns[k].name)));
      }
      numbers.number(cell, table.line(), columns[k].name);
      columns[k].cells.push_back(
          with_decimal_point(cell).value_or(joined(split_cells(cell, ' '), " ")));
    }
  }
  if (columns.front().cells.empty()) {
    fail_in(table.line(), "expected at least one row below the names");
  }
  numbers.require_one();
  return columns;
}

}  // namespace microslip
