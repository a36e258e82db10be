// SPDX-License-Identifier: GPL-3.0-or-later
#include "columns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "microslip/scene/units.hpp"
#include "microslip/support/nearest.hpp"
#include "microslip/support/shown.hpp"
#include "number.hpp"

namespace microslip {

namespace {

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// The next line that is neither empty nor a comment; empty at the end.
std::string next_line(std::istream& in, int& line_number) {
  for (std::string line; std::getline(in, line);) {
    ++line_number;
    if (!line.starts_with('#') && line.find_first_not_of(" \t\v\f\r") != std::string::npos) {
      return line;
    }
  }
  return "";
}

/// Returns what separates the cells of a table, by its line of names: a comma or a semicolon if
/// there is one, as in CSV; otherwise blanks and tabs.
char separator_of(const std::string& names) {
  for (const char separator : {',', ';'}) {
    if (names.find(separator) != std::string::npos) return separator;
  }
  return ' ';
}

/// Splits a line at a separator, and leaves one blank between the words of a cell, without the
/// quotes around it. A cell without words is empty.
std::vector<std::string> cells_between(const std::string& line, char separator) {
  std::vector<std::string> cells;
  std::istringstream stream(line + separator);
  for (std::string cell; std::getline(stream, cell, separator);) {
    cells.push_back(joined(words_of(cell), " "));
    std::string& last = cells.back();
    if (last.size() > 1 && last.starts_with('"') && last.ends_with('"')) {
      last = joined(words_of(last.substr(1, last.size() - 2)), " ");
    }
  }
  return cells;
}

std::vector<std::string> cells_of(const std::string& line, char separator) {
  return separator == ' ' ? words_of(line) : cells_between(line, separator);
}

/// The first name that occurs twice; empty if none does.
std::string repeated(std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  const auto found = std::adjacent_find(names.begin(), names.end());
  return found == names.end() ? "" : *found;
}

/// Names and units of columns; a unit is empty if there is none.
struct Header {
  std::vector<std::string> names;
  std::vector<std::string> units;
};

/// \param words  "q[mm]", or "q" and "[mm]", or "I", "[N" and "s^2]"
Header header_of(const std::vector<std::string>& words) {
  Header header;
  bool in_unit = false;
  for (std::string word : words) {
    if (!in_unit && (word.front() != '[' || header.names.empty())) {
      const std::size_t bracket = word.find('[', 1);
      header.names.push_back(word.substr(0, bracket));
      header.units.emplace_back();
      if (bracket == std::string::npos) continue;
      word = word.substr(bracket);
    }
    const bool ends = word.ends_with(']');
    const std::size_t begin = in_unit ? 0 : 1;
    std::string& unit = header.units.back();
    if (!unit.empty()) unit += ' ';
    unit += word.substr(begin, word.size() - begin - (ends ? 1 : 0));
    in_unit = !ends;
  }
  return header;
}

/// \param line  of names
Header header_of(const std::string& line, char separator) {
  if (separator == ' ') return header_of(words_of(line));
  Header header;
  for (const std::string& cell : cells_between(line, separator)) {
    const std::size_t bracket = std::min(cell.size(), cell.find('['));
    header.names.push_back(joined(words_of(cell.substr(0, bracket)), " "));
    const std::string rest = cell.substr(bracket);
    header.units.push_back(rest.substr(rest.empty() ? 0 : 1, rest.find(']') - 1));
  }
  return header;
}

void require_as_many(std::size_t found, std::size_t expected, int line) {
  if (found == expected) return;
  throw std::invalid_argument(
      fmt::format("line {}: expected {} values, found {}", line, expected, found));
}

/// The wanted column that a name is meant for: in other letters, or with a third of them at most
/// changed. Names of one letter are too many words.
std::string meant_column(const std::string& name, const std::vector<FileColumn>& wanted) {
  const std::string small = boost::algorithm::to_lower_copy(name);
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
    const bool is_wanted = std::ranges::find(wanted, name, &FileColumn::name) != wanted.end();
    if (is_wanted || name.empty() || name.starts_with('_')) continue;
    const std::string meant = meant_column(name, wanted);
    if (!meant.empty()) {
      throw std::invalid_argument(
          fmt::format("line {}: unknown column '{}'{}; one that is not to be read has a name that "
                      "begins with _",
                      line, shown(name), suggestion(meant)));
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

}  // namespace

ReadColumns read_columns(std::istream& in, const std::vector<FileColumn>& wanted) {
  int line = 0;
  const auto fail = [&](const std::string& what) {
    throw std::invalid_argument(fmt::format("line {}: {}", line, what));
  };
  const std::string names = next_line(in, line);
  if (names.empty()) throw std::invalid_argument("expected a line of column names, found none");
  const char separator = separator_of(names);
  const Header header = header_of(names, separator);
  const auto find = [&](const FileColumn& column) -> std::optional<Found> {
    const auto name = std::find(header.names.begin(), header.names.end(), column.name);
    if (name == header.names.end()) {
      if (column.needed) {
        fail(fmt::format("expected a column '{}' among the names in the first line, which are: {}",
                         column.name, shown(joined(header.names, " "))));
      }
      return std::nullopt;
    }
    const auto place = static_cast<std::size_t>(name - header.names.begin());
    const std::string& unit = header.units[place];
    const auto factor = quantity(unit.empty() ? "1" : "1 " + unit, column.unit);
    if (!factor) {
      fail(fmt::format("column '{}': unit '{}': expected {}", column.name, shown(unit),
                       accepted_units(column.unit)));
    }
    return Found{place, *factor};
  };
  std::vector<std::optional<Found>> found;
  for (const FileColumn& column : wanted) found.push_back(find(column));
  if (const std::string name = repeated(header.names); !name.empty()) {
    fail(fmt::format("expected one column '{}', found more of that name", shown(name)));
  }
  ReadColumns read{.wanted = {}, .unused = unused_of(header, wanted, line)};
  std::size_t rows = 0;
  for (auto text = next_line(in, line); !text.empty(); text = next_line(in, line), ++rows) {
    const std::vector<std::string> row = cells_of(text, separator);
    require_as_many(row.size(), header.names.size(), line);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (!found[k]) continue;
      const std::string& word = row[found[k]->place];
      const auto value = finite_number(word);
      if (!value) {
        fail(fmt::format("column '{}': '{}' is not a finite number{}", wanted[k].name, shown(word),
                         advice(word)));
      }
      found[k]->values.push_back(found[k]->factor * *value);
    }
  }
  if (rows == 0) fail("expected at least one row below the names");
  for (const std::optional<Found>& column : found) {
    read.wanted.emplace_back();
    if (!column) continue;
    read.wanted.back() = Eigen::Map<const Eigen::VectorXd>(
        column->values.data(), static_cast<Eigen::Index>(column->values.size()));
  }
  return read;
}

std::vector<TextColumn> read_text_columns(std::istream& in) {
  int line = 0;
  const auto fail = [&](const std::string& what) {
    throw std::invalid_argument(fmt::format("line {}: {}", line, what));
  };
  const std::string names = next_line(in, line);
  if (names.empty()) throw std::invalid_argument("expected a line of column names, found none");
  const char of_names = separator_of(names);
  const char separator = of_names == ' ' && names.find('\t') != std::string::npos ? '\t' : of_names;
  const Header header = header_of(names, of_names);
  if (const std::string name = repeated(header.names); !name.empty()) {
    fail(fmt::format("expected one column '{}', found more of that name", shown(name)));
  }
  std::vector<TextColumn> columns;
  for (std::size_t k = 0; k < header.names.size(); ++k) {
    columns.push_back({header.names[k], header.units[k], {}});
  }
  for (std::string row = next_line(in, line); !row.empty(); row = next_line(in, line)) {
    const std::vector<std::string> cells = cells_of(row, separator);
    require_as_many(cells.size(), columns.size(), line);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (cells[k].empty()) fail(fmt::format("column '{}': expected a value", columns[k].name));
      columns[k].cells.push_back(cells[k]);
    }
  }
  if (columns.front().cells.empty()) fail("expected at least one row below the names");
  return columns;
}

}  // namespace microslip
