// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "microslip/support/format.hpp"

namespace microslip::tools {

namespace {

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

const std::string& text_at(const Table& table, std::size_t row, const std::string& column) {
  return std::get<std::string>(table.at(row, column));
}

constexpr const char* rounding_word = "rounding";

/// The text of a cell; of a number that is nothing but rounding only this.
std::string without_rounding(const Table& table, std::size_t row, const std::string& column) {
  const std::string& text = text_at(table, row, column);
  const double bound = table.rounding(row, column);
  const auto number = number_in(text);
  return bound > 0 && number && std::abs(*number) <= bound ? rounding_word : text;
}

double largest_in(const Table& table, const std::string& column) {
  double largest = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double value = number_in(text_at(table, row, column)).value_or(0);
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The difference of two words over what is allowed; infinite if they are not both numbers.
double excess_of_word(const std::string& word, const std::string& reference,
                      const Tolerance& tolerance, double largest) {
  if (word == reference) return 0;
  const auto value = number_in(word);
  const auto expected = number_in(reference);
  if (!value || !expected || !std::isfinite(*value) || !std::isfinite(*expected)) return infinite;
  const double allowed = tolerance.relative * std::abs(*expected) + tolerance.of_largest * largest +
                         tolerance.absolute;
  return allowed > 0 ? std::abs(*value - *expected) / allowed : infinite;
}

/// The same of cells, which may be sentences with numbers in them.
double excess(const std::string& cell, const std::string& reference, const Tolerance& tolerance,
              double largest) {
  double worst = 0;
  std::istringstream words(cell);
  std::istringstream references(reference);
  for (std::string word, expected; words >> word;) {
    if (!(references >> expected)) return infinite;
    worst = std::max(worst, excess_of_word(word, expected, tolerance, largest));
  }
  return (references >> std::ws).eof() ? worst : infinite;
}

/// The first of the bounds of rounding that differ, in tables of one form; empty if none does.
std::string difference_of_rounding(const Table& table, const Table& reference) {
  for (const Column& column : reference.columns()) {
    for (std::size_t row = 0; row < reference.rows(); ++row) {
      const double bound = table.rounding(row, column.name);
      const double expected = reference.rounding(row, column.name);
      if (bound == expected) continue;
      return fmt::format("{} in row {} is rounding up to {}, reference {}", column.name, row + 1,
                         format_short(bound), format_short(expected));
    }
  }
  return "";
}

/// Describes what differs besides cells; empty if nothing does.
std::string difference_of_heads(const WrittenTable& table, const WrittenTable& reference) {
  if (table.parameters != reference.parameters) {
    const auto [here, there] =
        std::mismatch(table.parameters.begin(), table.parameters.end(),
                      reference.parameters.begin(), reference.parameters.end());
    const auto text = [](const auto& at, const Parameters& all) {
      return at == all.end() ? "none" : fmt::format("'{} = {}'", at->first, at->second);
    };
    return fmt::format("parameter {}, reference {}", text(here, table.parameters),
                       text(there, reference.parameters));
  }
  const auto names = [](const Table& of) {
    std::string all;
    for (const Column& column : of.columns()) {
      all += fmt::format(" {} [{}]", column.name, column.unit);
    }
    return all;
  };
  if (names(table.table) != names(reference.table)) {
    return fmt::format("columns{}, reference{}", names(table.table), names(reference.table));
  }
  if (table.table.rows() != reference.table.rows()) {
    return fmt::format("{} rows, reference {}", table.table.rows(), reference.table.rows());
  }
  return difference_of_rounding(table.table, reference.table);
}

}  // namespace

WrittenTable thinned(const WrittenTable& whole, std::size_t kept) {
  const Table& table = whole.table;
  if (table.rows() <= kept) return whole;
  const std::string rows = fmt::format("{} of {}", kept, table.rows());
  WrittenTable part{Table(table.name(), "rows of a larger table", table.columns()),
                    {{"rows", rows}}};
  part.parameters.insert(part.parameters.end(), whole.parameters.begin(), whole.parameters.end());
  for (std::size_t i = 0; i < kept; ++i) {
    std::vector<Cell> row;
    for (const Column& column : table.columns()) {
      row.push_back(table.at(i * (table.rows() - 1) / (kept - 1), column.name));
    }
    part.table.add(row);
  }
  return part;
}

WrittenTable without_rounding(const WrittenTable& whole) {
  WrittenTable kept = whole;
  for (std::size_t row = 0; row < kept.table.rows(); ++row) {
    for (const Column& column : kept.table.columns()) {
      kept.table.put(row, column.name, without_rounding(whole.table, row, column.name));
    }
  }
  return kept;
}

Comparison compare(const std::string& name, const WrittenTable& table,
                   const WrittenTable& reference, const Tolerances& tolerances) {
  const std::string heads = difference_of_heads(table, reference);
  if (!heads.empty()) return {Verdict::differs, heads};
  std::size_t different = 0;
  std::size_t beyond = 0;
  double worst = 0;
  std::string where;
  for (const auto& [column, unit, meaning, rounding] : reference.table.columns()) {
    const Tolerance tolerance = tolerances.of(name, column);
    const double largest = largest_in(reference.table, column);
    for (std::size_t row = 0; row < reference.table.rows(); ++row) {
      const std::string& expected = text_at(reference.table, row, column);
      const std::string text = expected == rounding_word
                                   ? without_rounding(table.table, row, column)
                                   : text_at(table.table, row, column);
      if (text != expected) ++different;
      Tolerance with_rounding = tolerance;
      with_rounding.absolute += reference.table.rounding(row, column);
      const double size = excess(text, expected, with_rounding, largest);
      if (size > 1) ++beyond;
      if (size <= worst) continue;
      worst = size;
      where = fmt::format("{} in row {}: {}, reference {}", column, row + 1, text, expected);
    }
  }
  if (different == 0) return {Verdict::identical, ""};
  return {
      beyond > 0 ? Verdict::differs : Verdict::agrees,
      fmt::format("{} cells {} the tolerance; the largest difference is {:.2g} of it, in {}",
                  beyond > 0 ? beyond : different, beyond > 0 ? "beyond" : "within", worst, where)};
}

}  // namespace microslip::tools
