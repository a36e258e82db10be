// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/changed_keys.hpp"

#include <algorithm>
#include <sstream>

#include "number.hpp"

namespace microslip {

namespace {

bool same_word(const std::string& a, const std::string& b) {
  const auto first = finite_number(a);
  const auto second = finite_number(b);
  return first && second ? *first == *second : a == b;
}

bool same_value(const std::string& a, const std::string& b) {
  const auto words = [](const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> all;
    for (std::string word; in >> word;) all.push_back(word);
    return all;
  };
  return std::ranges::equal(words(a), words(b), same_word);
}

bool holds(const Parameters& parameters, const std::string& key, const std::string& text) {
  return std::ranges::any_of(parameters, [&](const auto& parameter) {
    return parameter.first == key && same_value(parameter.second, text);
  });
}

}  // namespace

std::vector<std::string> changed_keys(const Parameters& before, const Parameters& after) {
  std::vector<std::string> changed;
  const auto add_missing = [&](const Parameters& from, const Parameters& in) {
    for (const auto& [key, text] : from) {
      const bool is_new = std::ranges::find(changed, key) == changed.end();
      if (is_new && !holds(in, key, text)) changed.push_back(key);
    }
  };
  add_missing(before, after);
  add_missing(after, before);
  return changed;
}

}  // namespace microslip
