// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace microslip {

/// Of characters; the names of sections before it are part of a key.
inline constexpr std::size_t longest_key = 200;

/// \throws std::invalid_argument if a key is longer
void require_short(const std::string& key);

/// Reads a property tree in INFO format as dotted keys with texts, in their order. A number and its
/// unit need no quotes: `half_width 1 mm`. There is no #include.
/// \param text   lines that end in \n, at most Scene::most_text bytes
/// \param store  takes key and text; false if the key is there already
/// \throws std::invalid_argument in one line
void read_info(const std::string& text,
               const std::function<bool(const std::string& key, const std::string& text)>& store);

}  // namespace microslip
