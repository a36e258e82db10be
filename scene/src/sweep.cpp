// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/sweep.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "columns.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/units.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/nearest.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/shown.hpp"
#include "number.hpp"

namespace microslip {

namespace {

constexpr int digits = 15;

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text + separator);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// With single blanks, so that a value stays in its line.
std::string in_one_line(const std::string& text) { return joined(words_of(text), " "); }

/// To 15 digits of `largest`, so that 3 * 0.1 is 0.3, and -0.3 + 3 * 0.1 is 0.
std::string rounded(double value, double largest) {
  const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(largest))));
  if (decimals < 0 || decimals > 300) return format_short(value);
  std::array<char, 400> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, decimals);
  return format_short(*finite_number({text.data(), end.ptr}) + 0.0);  // + 0.0: no negative zero
}

std::optional<std::vector<std::string>> linear_range(double first, double step, double last) {
  const double steps = (last - first) / step;
  if (!(steps >= 0)) return std::nullopt;
  if (steps >= static_cast<double>(Sweep::max_cases)) return std::nullopt;
  const auto count = static_cast<int>(std::floor(steps * (1 + 1e-12) + 1e-12));
  const double largest = std::max({std::abs(first), std::abs(last), std::abs(step)});
  std::vector<std::string> values;
  for (int i = 0; i <= count; ++i) values.push_back(rounded(first + i * step, largest));
  return values;
}

std::optional<std::vector<std::string>> logarithmic_range(double first, int count, double last) {
  const double ratio = last / first;
  if (count < 2 || static_cast<std::size_t>(count) > Sweep::max_cases) return std::nullopt;
  if (!(ratio > 0) || !std::isfinite(ratio)) return std::nullopt;
  std::vector<std::string> values{format_short(first)};
  for (int i = 1; i < count - 1; ++i) {
    const double value = first * std::pow(ratio, static_cast<double>(i) / (count - 1));
    values.push_back(rounded(value, value));
  }
  values.push_back(format_short(last));
  return values;
}

/// Nothing if it is none, or none that is accepted.
std::optional<std::vector<std::string>> range(const std::vector<std::string>& parts) {
  if (parts.size() != 3) return std::nullopt;
  const auto first = finite_number(parts[0]);
  const auto last = finite_number(parts[2]);
  if (!first || !last) return std::nullopt;
  if (parts[1].starts_with("log")) {
    const auto count = converted<int>(parts[1].substr(3));
    return count ? logarithmic_range(*first, *count, *last) : std::nullopt;
  }
  const auto step = finite_number(parts[1]);
  return step ? linear_range(*first, *step, *last) : std::nullopt;
}

/// Whether values of the key are numbers.
bool is_of_numbers(const std::string& name) {
  const Key* key = find_key(name);
  using enum Key::Type;
  return key != nullptr && key->type != word && key->type != file && key->type != Key::Type::text;
}

/// In the unit of the key, so that columns of swept values are numbers, or lists of them.
std::string without_unit(const std::string& value, const std::string& unit) {
  const auto is_number = [](const std::string& word) { return finite_number(word).has_value(); };
  if (std::ranges::all_of(words_of(value), is_number)) return value;
  const auto numbers = quantities(value, unit);
  return numbers ? joined_numbers(*numbers) : value;
}

/// The section of keys that take their values together; empty of a key that does so alone.
std::string group_of(const std::string& key) {
  const std::string first = key.substr(0, key.find('.'));
  return first.starts_with("together") && first.size() < key.size() ? first : "";
}

/// Values between |, each with its own unit: one behind the last alone might be meant for all.
std::vector<std::string> items_between_bars(const std::string& name, const std::string& text,
                                            bool of_numbers) {
  std::vector<std::string> items;
  for (const std::string& part : split(text, '|')) {
    items.push_back(in_one_line(part));
    if (items.back().empty()) reject(name, text, "a value on both sides of |");
  }
  const auto are_numbers = std::all_of(items.begin(), items.end() - 1, [](const auto& item) {
    return finite_number(item).has_value();
  });
  const auto last = list_items(items.back());
  const std::size_t unit = unit_behind(items.back()).size();
  const bool is_single = last && last->size() == 1 && unit > 0 && unit < items.back().size();
  if (of_numbers && items.size() > 1 && are_numbers && is_single) {
    reject(name, text, "a unit behind each value, or behind none");
  }
  return items;
}

/// Values and ranges in a text, each with its unit.
std::vector<std::string> swept_items(const std::string& name, const std::string& text,
                                     bool of_numbers) {
  if (text.find('|') != std::string::npos) return items_between_bars(name, text, of_numbers);
  if (!of_numbers) return words_of(text);
  const auto items = list_items(text);
  if (!items) reject(name, text, "a unit behind each value, or one behind the last for all");
  return *items;
}

constexpr const char* table_key = "table";
constexpr const char* table_name = "sweep.table";

std::vector<std::string> values_of(const TextColumn& column, const std::string& unit) {
  if (!column.unit.empty() && !quantity("1 " + column.unit, unit)) {
    throw std::invalid_argument(fmt::format("column '{}': unit '{}': expected {}", column.name,
                                            shown(column.unit), accepted_units(unit)));
  }
  std::vector<std::string> values;
  for (const std::string& cell : column.cells) {
    values.push_back(without_unit(column.unit.empty() ? cell : cell + " " + column.unit, unit));
  }
  return values;
}

/// The columns of the table that the section names, except for the numbers of cases that a plan
/// has, and for keys that are fixed.
std::vector<SweptKey> columns_of(Scene scene) {
  return scene.with_file(table_name, [&] {
    const std::string table = scene.file(table_name);
    std::vector<SweptKey> columns;
    const std::vector<TextColumn> read = read_text_columns(table);
    const bool in_patch =
        scene.has_patch() || std::ranges::any_of(read, is_patch_key, &TextColumn::name);
    for (const TextColumn& column : read) {
      if (column.name == "case") continue;
      if (scene.known(column.name) == nullptr) {
        throw std::invalid_argument(fmt::format("column '{}': expected the name of a key{}",
                                                shown(column.name),
                                                suggestion(likely_key(column.name))));
      }
      const bool is_fixed = scene.has(column.name) && scene.place_of(column.name).empty();
      const std::string unit = unit_of_key(column.name, in_patch);
      if (!is_fixed) columns.push_back({column.name, values_of(column, unit), unit});
    }
    return columns;
  });
}

}  // namespace

std::optional<std::string> swept_key(const std::string& key) {
  constexpr std::string_view section = "sweep.";
  if (!key.starts_with(section)) return std::nullopt;
  const std::string below = key.substr(section.size());
  const std::string group = group_of(below);
  return group.empty() ? below : below.substr(group.size() + 1);
}

std::vector<std::string> swept_values(const std::string& name, const std::string& text,
                                      const std::optional<std::string>& of_key) {
  const std::string key = swept_key(name).value_or(name);
  const std::string unit_of_values = of_key.value_or(unit_of_key(key));
  const auto reject_list = [&](const std::string& list, const std::string& accepted) {
    reject(name, list, accepted);
  };
  const bool of_numbers = is_of_numbers(key);
  std::vector<std::string> values;
  for (const std::string& value : swept_items(name, text, of_numbers)) {
    if (values.size() > Sweep::max_cases) {
      reject_list(text, fmt::format("at most {} values", Sweep::max_cases));
    }
    const std::string unit(of_numbers ? unit_behind(value) : "");
    const std::vector<std::string> parts =
        split(in_one_line(value.substr(0, value.size() - unit.size())), ':');
    if (parts.size() == 1 || !finite_number(parts[0])) {
      values.push_back(without_unit(value, unit_of_values));
      continue;
    }
    const auto expanded = range(parts);
    if (!expanded) {
      reject_list(value, fmt::format("first:step:last with a step towards last, or "
                                     "first:logN:last with N >= 2 and both of one sign, and at "
                                     "most {} values",
                                     Sweep::max_cases));
    }
    for (const std::string& number : *expanded) {
      values.push_back(without_unit(unit.empty() ? number : number + ' ' + unit, unit_of_values));
    }
  }
  if (values.empty()) reject_list(text, "at least one value");
  return values;
}

/// Adds a key to the group that is open.
void Sweep::add(const std::string& name, const std::string& key, std::vector<std::string> values) {
  const auto same = [&](const SweptKey& other) { return other.key == key; };
  if (std::ranges::any_of(keys_, same)) {
    throw BadParameter(
        name,
        fmt::format("{}: expected one list of values of {}, found more of them", name, shown(key)));
  }
  const std::size_t begin = groups_.empty() ? 0 : groups_.back();
  if (keys_.size() > begin && values.size() != keys_[begin].values.size()) {
    reject(name, joined(values, " "),
           fmt::format("as many values as {} has, which are {}", keys_[begin].key,
                       keys_[begin].values.size()));
  }
  keys_.push_back({key, std::move(values), unit_of_key(key, in_patch_)});
}

/// \param name  for messages
void Sweep::close_group(const std::string& name) {
  const std::size_t begin = groups_.empty() ? 0 : groups_.back();
  if (begin == keys_.size()) return;
  groups_.push_back(keys_.size());
  size_ *= keys_[begin].values.size();
  if (size_ > max_cases) {
    throw BadParameter(name, fmt::format("sweep: expected at most {} cases, not {} with {}",
                                         max_cases, size_, shown(name)));
  }
}

/// \param name  "together" or another one
void Sweep::add_group(const std::string& name) {
  const Scene group = section_.take_section(name);
  for (const std::string& key : group.keys()) {
    const std::string full = fmt::format("sweep.{}.{}", name, key);
    add(full, key, swept_values(full, group.text(key), unit_of_key(key, in_patch_)));
  }
  section_.overlay(group);
  close_group("sweep." + name);
}

void Sweep::add_columns(const std::vector<SweptKey>& columns) {
  for (const SweptKey& column : columns) {
    add(table_name, column.key, column.values);
    section_.set(column.key + "=" + column.values.front());
  }
  close_group(table_name);
  section_.set(std::string(table_key) + "=");
}

Sweep::Sweep(Scene scene) : common_(std::move(scene)) {
  const std::vector<SweptKey> columns =
      common_.has(table_name) ? columns_of(common_) : std::vector<SweptKey>{};
  in_patch_ = common_.has_patch() || std::ranges::any_of(columns, is_patch_key, &SweptKey::key);
  section_ = common_.take_section("sweep");
  for (const std::string& key : section_.keys()) {
    const std::string group = group_of(key);
    if (!section_.has(key)) continue;  // with the first one of its group
    if (!group.empty()) {
      add_group(group);
    } else if (key == table_key) {
      add_columns(columns);
    } else {
      add("sweep." + key, key,
          swept_values("sweep." + key, section_.text(key), unit_of_key(key, in_patch_)));
      close_group("sweep." + key);
    }
  }
  if (keys_.empty()) {
    throw std::invalid_argument("missing section 'sweep' with lists of values below its keys");
  }
}

std::vector<std::string> Sweep::values(std::size_t index) const {
  std::vector<std::string> chosen(keys_.size());
  for (std::size_t g = groups_.size(); g-- > 0;) {
    const std::size_t begin = g == 0 ? 0 : groups_[g - 1];
    const std::size_t rows = keys_[begin].values.size();
    for (std::size_t k = begin; k < groups_[g]; ++k) chosen[k] = keys_[k].values[index % rows];
    index /= rows;
  }
  return chosen;
}

Scene Sweep::scene(std::size_t index) const {
  const std::vector<std::string> chosen = values(index);
  Scene section = section_;
  for (std::size_t k = 0; k < keys_.size(); ++k) section.replace(keys_[k].key, chosen[k]);
  Scene scene = common_;
  scene.overlay(section);
  return scene;
}

}  // namespace microslip
