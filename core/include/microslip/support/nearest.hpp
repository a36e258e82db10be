// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace microslip {

/// \file
/// Text for messages about unknown names.

/// The name that differs from the word by the fewest edits, one to `most`; empty if there is none.
/// Cost: proportional to the product of the lengths.
std::string nearest(const std::string& word, const std::vector<std::string>& names,
                    std::size_t most = 3);

/// " (did you mean 'x'?)" with `meant` as x; empty if `meant` is empty.
std::string suggestion(const std::string& meant);

/// The names of items.
template <class Items>
std::vector<std::string> names_of(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.emplace_back(item.name);
  return names;
}

/// All texts in one, with a separator between two of them.
template <class Texts>
std::string joined(const Texts& texts, const std::string& separator) {
  std::string all;
  for (const auto& text : texts) {
    if (!all.empty()) all += separator;
    all += text;
  }
  return all;
}

}  // namespace microslip
