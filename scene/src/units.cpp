// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "number.hpp"

namespace microslip {

namespace {

/// The unit factor * 10^ten of mm, N, s and rad, raised to these powers. An angle counts as a
/// dimension: 1/min of a wheel is one revolution a minute for some and one radian for others.
struct Unit {
  double factor = 1;
  int ten = 0;
  std::array<int, 4> powers = {};
};

const std::map<std::string, Unit, std::less<>> symbols{
    {"1", {}},
    {"%", {1, -2, {}}},
    {"\u2030", {1, -3, {}}},
    {"um", {1, -3, {1, 0, 0}}},
    {"mm", {1, 0, {1, 0, 0}}},
    {"cm", {1, 1, {1, 0, 0}}},
    {"m", {1, 3, {1, 0, 0}}},
    {"km", {1, 6, {1, 0, 0}}},
    {"in", {25.4, 0, {1, 0, 0}}},
    {"N", {1, 0, {0, 1, 0}}},
    {"kN", {1, 3, {0, 1, 0}}},
    {"MN", {1, 6, {0, 1, 0}}},
    {"Pa", {1, -6, {-2, 1, 0}}},
    {"kPa", {1, -3, {-2, 1, 0}}},
    {"MPa", {1, 0, {-2, 1, 0}}},
    {"GPa", {1, 3, {-2, 1, 0}}},
    {"g", {1, -6, {-1, 1, 2}}},
    {"kg", {1, -3, {-1, 1, 2}}},
    {"t", {1, 0, {-1, 1, 2}}},
    {"ms", {1, -3, {0, 0, 1}}},
    {"s", {1, 0, {0, 0, 1}}},
    {"min", {60, 0, {0, 0, 1}}},
    {"h", {3.6, 3, {0, 0, 1}}},
    {"rad", {1, 0, {0, 0, 0, 1}}},
    {"deg", {std::numbers::pi / 180, 0, {0, 0, 0, 1}}},
    {"rev", {2 * std::numbers::pi, 0, {0, 0, 0, 1}}},
    {"rpm", {2 * std::numbers::pi / 60, 0, {0, 0, -1, 1}}},
};

/// Units for messages, besides the unit of the key.
const std::map<std::string, std::string> others{{"mm", "um, cm, m, in"},
                                                {"N/mm^2", "Pa, kPa, MPa, GPa"},
                                                {"N/mm", "N/m, kN/m"},
                                                {"N", "kN, MN"},
                                                {"N mm", "N m, kN m"},
                                                {"1/mm", "1/m, rad/m, deg/m"},
                                                {"mm^3/N", "mm/MPa, um/MPa"},
                                                {"mm/s", "cm/s, m/s, km/h"},
                                                {"N s^2/mm^2", "kg/mm, kg/m, t/m"},
                                                {"N s^2", "kg m, kg m^2/m"},
                                                {"s", "ms"},
                                                {"rad", "deg"},
                                                {"rad/s", "rad/min, deg/s, rev/s, rev/min, rpm"}};

/// The unit of a symbol with an optional power: "mm^2", "mm2", "mm".
/// \param any_letters  whether capital and small letters are the same: "KN"
std::optional<Unit> power_of_symbol(std::string_view text, bool any_letters) {
  const std::size_t end = text.find_last_not_of("0123456789");
  int power = 1;
  if (end != std::string_view::npos && end + 1 < text.size()) {
    const auto value = converted<int>(text.substr(end + 1));
    if (!value || *value < 1 || *value > 9) return std::nullopt;
    power = *value;
    text = text.substr(0, text[end] == '^' ? end : end + 1);
  }
  auto found = symbols.find(text);
  if (found == symbols.end() && any_letters) {
    found = std::ranges::find_if(
        symbols, [&](const auto& symbol) { return boost::algorithm::iequals(symbol.first, text); });
  }
  if (found == symbols.end()) return std::nullopt;
  Unit unit = found->second;
  unit.factor = std::pow(unit.factor, power);
  unit.ten *= power;
  for (int& exponent : unit.powers) exponent *= power;
  return unit;
}

void multiply(Unit& by, const Unit& unit, int sign) {
  by.factor *= sign > 0 ? unit.factor : 1 / unit.factor;
  by.ten += sign * unit.ten;
  for (std::size_t i = 0; i < by.powers.size(); ++i) by.powers[i] += sign * unit.powers[i];
}

std::optional<Unit> unit_of(std::string_view text, bool any_letters = false) {
  namespace algorithm = boost::algorithm;
  std::string plain(text);
  const std::array<std::array<const char*, 2>, 7> written{{{"\u00b2", "^2"},
                                                           {"\u00b3", "^3"},
                                                           {"\u00b7", " "},
                                                           {"*", " "},
                                                           {"\u00b5", "u"},
                                                           {"\u03bc", "u"},
                                                           {"\u00b0", "deg"}}};
  for (const auto& [from, to] : written) algorithm::replace_all(plain, from, to);
  std::vector<std::string> sides;
  algorithm::split(sides, plain, algorithm::is_any_of("/"));
  if (sides.size() > 2) return std::nullopt;
  Unit unit;
  int sign = 1;
  for (std::string& side : sides) {
    algorithm::trim_if(side, algorithm::is_any_of(" \t"));
    if (side.empty() && sign > 0 && sides.size() > 1) {  // "/m" behind a number
      sign = -1;
      continue;
    }
    std::vector<std::string> factors;
    algorithm::split(factors, side, algorithm::is_any_of(" \t"), algorithm::token_compress_on);
    for (const std::string& factor : factors) {
      const auto next = power_of_symbol(factor, any_letters);
      if (!next) return std::nullopt;
      multiply(unit, *next, sign);
    }
    sign = -1;
  }
  return unit;
}

/// Splits a text into the number at its beginning and the rest, without the blanks between them.
std::pair<std::string_view, std::string_view> split_number(std::string_view text) {
  const std::string_view digits = without_plus(text);
  double value = 0;
  const char* stop = std::from_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  const auto length = static_cast<std::size_t>(stop - text.data());
  std::string_view rest = text.substr(length);
  rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(" \t")));
  return {text.substr(0, length), rest};
}

/// Whether a unit is one of the kind of another. A spin is an angle a length, and its unit 1/mm: rad/m
/// and deg/m are of its kind, too.
bool is_of_kind(const Unit& unit, const Unit& kind) {
  constexpr std::array<int, 4> per_length{-1, 0, 0, 0}, angle_per_length{-1, 0, 0, 1};
  return unit.powers == kind.powers ||
         (kind.powers == per_length && unit.powers == angle_per_length);
}

double scaled(double value, int ten) {
  return ten < 0 ? value / std::pow(10.0, -ten) : value * std::pow(10.0, ten);
}

}  // namespace

std::string_view unit_behind(std::string_view item) {
  const std::size_t colon = item.rfind(':');
  return split_number(colon == std::string_view::npos ? item : item.substr(colon + 1)).second;
}

std::optional<double> quantity(std::string_view text, std::string_view unit) {
  const auto [number, rest] = split_number(text);
  const auto value = finite_number(number);
  if (!value) return std::nullopt;
  if (rest.empty()) return number.size() == text.size() ? value : std::nullopt;
  const auto from = unit_of(rest);
  const auto to = unit_of(unit);
  if (!from || !to || !is_of_kind(*from, *to)) return std::nullopt;
  const double result = scaled(*value * (from->factor / to->factor), from->ten - to->ten);
  return std::isfinite(result) ? std::optional(result) : std::nullopt;
}

std::optional<std::vector<std::string>> list_items(std::string_view text) {
  std::vector<std::string> items;  // each one a number with its unit
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) {
    // "1/m" behind a number is its unit; "0/m 1/m" are two numbers, and "0 1/m 2/m" is neither.
    const bool is_inverse = word.starts_with("1/") && is_unit(word) && !items.empty() &&
                            unit_behind(items.back()).empty();
    if (items.empty() || (!split_number(word).first.empty() && !is_inverse)) {
      items.push_back(word);
    } else {
      items.back() += ' ' + word;
    }
  }
  const auto has_unit_like = [&](std::string_view begin) {
    return std::ranges::any_of(
        items, [&](const auto& item) { return unit_behind(item).starts_with(begin); });
  };
  if (has_unit_like("1/") && has_unit_like("/")) return std::nullopt;
  const auto has_none = [](const std::string& item) { return unit_behind(item).empty(); };
  const auto without = static_cast<std::size_t>(std::ranges::count_if(items, has_none));
  if (without == 0 || without == items.size()) return items;
  if (without + 1 < items.size() || has_none(items.back())) return std::nullopt;
  const std::string of_all(unit_behind(items.back()));
  for (std::size_t i = 0; i + 1 < items.size(); ++i) items[i] += ' ' + of_all;
  return items;
}

std::optional<std::vector<double>> quantities(std::string_view text, std::string_view unit) {
  const auto items = list_items(text);
  if (!items) return std::nullopt;
  std::vector<double> values;
  for (const std::string& item : *items) {
    const auto value = quantity(item, unit);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

bool is_unit(std::string_view text) { return unit_of(text).has_value(); }

bool has_unit(std::string_view text) {
  const auto [number, rest] = split_number(text);
  if (!finite_number(number) || rest.empty()) return false;
  const bool apart = number.size() + rest.size() < text.size();
  const bool is_word =
      std::string_view("+-.0123456789").find(rest.front()) == std::string_view::npos;
  // Other ways to write a number, as 0x10 and 1.5d3, have one letter.
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const bool is_long = rest.size() > 1 && is_letter(rest[0]) && is_letter(rest[1]);
  return unit_of(rest, true).has_value() || (apart && is_word) || is_long;
}

std::string advice_on_width(std::string_view text, std::string_view unit) {
  constexpr std::string_view per_width[] = {"N/mm", "N s^2/mm^2", "N s^2"};
  const auto from = unit_of(unit_behind(text));
  if (!from || std::ranges::find(per_width, unit) == std::end(per_width)) return "";
  Unit per_mm = *from;
  multiply(per_mm, symbols.find("mm")->second, -1);
  if (per_mm.powers != unit_of(unit)->powers) return "";
  return ", per mm of width: divide by the width";
}

std::string accepted_units(const std::string& unit) {
  if (unit == "1") return "no unit, or in % or \u2030";
  const auto found = others.find(unit);
  return found == others.end() ? "no unit"
                               : fmt::format("{} or another of its kind ({})", unit, found->second);
}

}  // namespace microslip
