// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <stdexcept>

#include "microslip/support/nearest.hpp"
#include "microslip/support/shown.hpp"
#include "number.hpp"

namespace microslip {

namespace {

using Cells = std::vector<std::string_view>;

constexpr std::string_view blanks = " \t\v\f\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// Where a cell ends, which begins at `begin`.
std::size_t end_of_cell(std::string_view line, char separator, std::size_t begin) {
  const std::size_t end =
      separator == ' ' ? line.find_first_of(blanks, begin) : line.find(separator, begin);
  return std::min(end, line.size());
}

/// The place of the quote that ends a cell in quotes. Without one, and if more than blanks follows
/// in the cell, the first quote is a character like any other: npos.
std::size_t closing_quote(std::string_view line, char separator, std::size_t begin) {
  std::size_t at = line.find('"', begin + 1);
  while (at != std::string_view::npos && line.substr(at).starts_with("\"\"")) {
    at = line.find('"', at + 2);
  }
  if (at == std::string_view::npos) return at;
  const std::size_t end = end_of_cell(line, separator, at + 1);
  return trimmed(line.substr(at + 1, end - at - 1)).empty() ? at : std::string_view::npos;
}

/// Number of cells up to the last one that is not empty.
std::size_t filled(const Cells& cells) {
  const auto last =
      std::find_if(cells.rbegin(), cells.rend(), [](const auto& cell) { return !cell.empty(); });
  return static_cast<std::size_t>(cells.rend() - last);
}

/// A line without what stands between quotes.
std::string without_quoted(std::string_view line) {
  std::string kept;
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    if (!is_quoted) kept += c;
  }
  return is_quoted ? std::string(line) : kept;
}

/// Blanks of typography become plain ones.
std::string with_plain_blanks(std::string_view line) {
  std::string plain(line);
  for (const char* blank : {"\u00a0", "\u2009", "\u202f"}) {
    boost::algorithm::replace_all(plain, blank, " ");
  }
  return plain;
}

/// The separator of a line "sep=;"; 0 for other lines.
char named_separator(std::string_view line) {
  constexpr std::string_view name = "sep=";
  if (!line.starts_with(name) || line.size() == name.size()) return '\0';
  const bool is_whole = trimmed(line.substr(name.size() + 1)).empty();
  return is_whole && line[name.size()] != '\r' ? line[name.size()] : '\0';
}

}  // namespace

Cells split_cells(std::string_view line, char separator) {
  Cells cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    while (begin < line.size() && line[begin] != separator &&
           blanks.find(line[begin]) != std::string_view::npos) {
      ++begin;
    }
    if (separator == ' ') begin = std::min(line.size(), line.find_first_not_of(blanks, begin));
    if (separator == ' ' && begin == line.size()) break;
    const bool opens = begin < line.size() && line[begin] == '"';
    const std::size_t quote =
        opens ? closing_quote(line, separator, begin) : std::string_view::npos;
    const bool is_quoted = quote != std::string_view::npos;
    const std::size_t end = end_of_cell(line, separator, is_quoted ? quote + 1 : begin);
    cells.push_back(trimmed(is_quoted ? line.substr(begin + 1, quote - begin - 1)
                                      : line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return cells;
}

std::string_view TableLines::next() {
  while (!text_.empty()) {
    const std::size_t end = std::min(text_.size(), text_.find('\n'));
    const std::string_view line = text_.substr(0, end);
    text_.remove_prefix(std::min(text_.size(), end + 1));
    ++number_;
    if (!line.starts_with('#') && !trimmed(line).empty()) return line;
  }
  return {};
}

TableText::TableText(std::string_view text) : lines_(text) {
  std::string_view names = lines_.next();
  const char named = named_separator(names);
  if (named != '\0') names = lines_.next();
  if (names.empty()) throw std::invalid_argument("expected a line of column names, found none");
  header_ = with_plain_blanks(names);
  TableLines behind = lines_;
  const std::string_view row = behind.next();
  separator_ = named == '\0' ? separator_by(row) : named;
  const auto has_blank = [](std::string_view name) {
    return name.find_first_of(blanks) != std::string_view::npos;
  };
  takes_blanks_ = separator_ == '\t' && std::ranges::none_of(split_cells(header_, '\t'), has_blank);
}

bool TableText::fits(char separator, std::string_view row) const {
  const std::size_t names = filled(split_cells(header_, separator));
  const Cells cells = split_cells(row, separator);
  return cells.size() >= names && filled(cells) <= names;
}

/// A separator that the names have, and by which the first row has as many cells: of several the
/// one that makes most cells.
char TableText::separator_by(std::string_view row) const {
  std::vector<char> found;
  const std::string bare = without_quoted(header_);
  for (const char separator : {',', ';', '\t'}) {
    if (bare.find(separator) != std::string::npos) found.push_back(separator);
  }
  const auto cells = [&](char separator) {
    return fits(separator, row) ? filled(split_cells(header_, separator)) : 0;
  };
  if (found.empty()) return ' ';
  const char best = *std::ranges::max_element(found, {}, cells);
  const bool has_only_tabs = found.front() == '\t';
  return has_only_tabs && !row.empty() && !fits('\t', row) ? ' ' : best;
}

std::vector<std::string> TableText::header() const {
  const Cells cells = split_cells(header_, separator_);
  std::vector<std::string> names;
  for (const std::string_view cell : cells) names.push_back(joined(split_cells(cell, ' '), " "));
  names.resize(filled(cells));
  return names;
}

void TableText::require_as_many(std::size_t columns, Cells& cells) const {
  const std::size_t values = filled(cells);
  if (cells.size() >= columns && values <= columns) return cells.resize(columns);
  const std::size_t named = split_cells(header_, separator_).size();
  throw std::invalid_argument(
      values > columns && values <= named && !is_separated_by_blanks()
          ? fmt::format("line {}: expected a name for column {}, which has the value '{}'", line(),
                        columns + 1, shown(cells[columns]))
          : fmt::format("line {}: expected {} values, found {}", line(), columns,
                        std::max(values, std::min(columns, cells.size()))));
}

bool TableText::read_row(std::size_t columns, Cells& cells) {
  do {
    const std::string_view row = lines_.next();
    if (row.empty()) return false;
    cells = split_cells(row, separator_);
    if (takes_blanks_ && cells.size() < columns) {
      const Cells by_blanks = split_cells(row, ' ');
      if (by_blanks.size() == columns) cells = by_blanks;
    }
  } while (filled(cells) == 0);
  require_as_many(columns, cells);
  return true;
}

std::optional<std::string> with_decimal_point(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos || comma + 1 == text.size()) return std::nullopt;
  if (text.find('.') != std::string_view::npos) return std::nullopt;
  std::string with_point(text);
  with_point[comma] = '.';
  return finite_number(with_point) ? std::optional(with_point) : std::nullopt;
}

namespace {

/// Whether the comma of a number may separate thousands: three digits follow, and one to three
/// precede it, of which the first is not 0.
bool may_separate_thousands(std::string_view number) {
  if (number.starts_with('+') || number.starts_with('-')) number.remove_prefix(1);
  const std::size_t comma = number.find(',');
  return comma >= 1 && comma <= 3 && number.front() != '0' && number.size() == comma + 4 &&
         number.find_first_not_of("0123456789", comma + 1) == std::string_view::npos;
}

}  // namespace

std::optional<double> DecimalMarks::number(std::string_view cell, int line,
                                           std::string_view column) {
  const auto note = [&](std::optional<Cell>& found) {
    if (!found) found = {std::string(cell), std::string(column), line};
  };
  if (const auto value = finite_number(cell)) {
    if (!point_ && cell.find('.') != std::string_view::npos) note(point_);
    return value;
  }
  const auto with_point = with_decimal_point(cell);
  if (!with_point) return std::nullopt;
  note(comma_);
  is_clear_ = is_clear_ || !may_separate_thousands(cell);
  return finite_number(*with_point);
}

void DecimalMarks::require_one() const {
  if (!comma_) return;
  const auto fail = [&](const std::string& why) {
    throw std::invalid_argument(fmt::format("line {}: column '{}': '{}' {}", comma_->line,
                                            shown(comma_->column), shown(comma_->text), why));
  };
  if (point_) {
    fail(
        fmt::format("has a comma, and '{}' in line {} a point: expected the same decimal mark in "
                    "all numbers, and none between thousands",
                    shown(point_->text), point_->line));
  }
  if (!is_clear_) {
    std::string thousands = comma_->text;
    thousands.erase(thousands.find(','), 1);
    fail(
        fmt::format("may be {} or {}: expected a decimal point, or commas of which one can only "
                    "be a decimal one",
                    *with_decimal_point(comma_->text), thousands));
  }
}

}  // namespace microslip
