// SPDX-License-Identifier: GPL-3.0-or-later
#include "input_words.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "microslip/support/shown.hpp"
#include "number.hpp"

namespace microslip {

namespace {

/// A name of a group, with what its sign says.
struct InputName {
  std::string name;
  bool whole = false;
  bool angle = false;
  bool optional = false;
};

std::vector<InputName> split_names(const std::string& names) {
  std::vector<InputName> all;
  bool optional = false;
  for (std::size_t at = 0; at < names.size();) {
    const std::size_t end = std::min(names.size(), names.find(' ', at));
    InputName one{.name = names.substr(at, end - at)};
    if (one.name.front() == '[') {
      optional = true;
      one.name.erase(0, 1);
    }
    one.optional = optional;
    one.whole = one.name.front() == '#';
    one.angle = one.name.front() == '<';
    if (one.whole || one.angle) one.name.erase(0, 1);
    all.push_back(one);
    at = end + 1;
  }
  return all;
}

/// A number as Fortran writes it: also 1d-4, 1.5D3, .5 and 2.
std::optional<double> fortran_number(std::string text) {
  for (char& letter : text) {
    if (letter == 'd' || letter == 'D') letter = 'e';
  }
  return finite_number(text);
}

/// \return in [rad]
std::optional<double> fortran_angle(std::string text) {
  const char last = text.back();
  const bool in_degrees = last == 'd' || last == 'D';
  if (in_degrees || last == 'r' || last == 'R') text.pop_back();
  const std::optional<double> value = text.empty() ? std::nullopt : fortran_number(text);
  if (!value || !in_degrees) return value;
  return *value * std::numbers::pi / 180;
}

std::optional<double> value_of(const InputName& name, const std::string& text) {
  if (name.angle) return fortran_angle(text);
  if (!name.whole) return fortran_number(text);
  const auto value = converted<int>(text);
  if (!value) return std::nullopt;
  return *value;
}

}  // namespace

void refuse_input(const std::string& file, int line, std::string_view name, std::string_view value,
                  std::string_view accepted) {
  throw std::invalid_argument(fmt::format("{}:{}: {} = {}: expected {}", shown(file), line, name,
                                          shown(value, 60), accepted));
}

std::vector<std::string> InputWords::next_line(const std::string& name) {
  while (!rest_.empty()) {
    const std::size_t end = std::min(rest_.size(), rest_.find('\n'));
    std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(std::min(rest_.size(), end + 1));
    ++line_;
    text = text.substr(0, text.find('%'));
    std::vector<std::string> words;
    constexpr const char* separators = " \t\r,=";
    for (std::size_t at = text.find_first_not_of(separators); at != std::string_view::npos;
         at = text.find_first_not_of(separators, at)) {
      const std::size_t stop = std::min(text.size(), text.find_first_of(separators, at));
      words.emplace_back(text.substr(at, stop - at));
      at = stop;
    }
    if (!words.empty()) return words;
  }
  throw std::invalid_argument(
      fmt::format("{}:{}: the file ends here, expected {}", shown(file_), line_, name));
}

std::vector<InputNumber> InputWords::group(const std::string& names) {
  const std::vector<InputName> expected = split_names(names);
  const auto is_complete = [&](std::size_t read) {
    return read >= expected.size() || expected[read].optional;
  };
  std::vector<InputNumber> read;
  while (!is_complete(read.size())) {
    for (const std::string& word : next_line(expected[read.size()].name)) {
      if (read.size() == expected.size()) break;
      const InputName& name = expected[read.size()];
      const std::optional<double> value = value_of(name, word);
      if (!value && name.optional) break;
      if (!value) {
        refuse_input(file_, line_, name.name, word, name.whole ? "a whole number" : "a number");
      }
      read.push_back({*value, line_, word});
    }
  }
  return read;
}

std::vector<InputNumber> InputWords::numbers(const std::string& name, double count) {
  std::vector<InputNumber> read;
  while (static_cast<double>(read.size()) < count) {
    for (const std::string& word : next_line(name)) {
      if (static_cast<double>(read.size()) >= count) break;
      const std::optional<double> value = fortran_number(word);
      if (!value) refuse_input(file_, line_, name, word, "a number");
      read.push_back({*value, line_, word});
    }
  }
  return read;
}

void InputWords::skip(const std::string& name, double count) {
  for (double passed = 0; passed < count;) passed += static_cast<double>(next_line(name).size());
}

}  // namespace microslip
