// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace microslip {

/// A key of the scenes that read_steady, read_transient and read_cylinder take.
struct Key {
  std::string_view name;
  std::string_view unit;  ///< "1" for words and pure numbers
  std::string_view meaning;
  std::string_view accepted;  ///< and, in brackets, the default
  /// Scenes in which the key has a role, as a noun; empty if it has one in all. Others refuse it.
  std::string_view role;
};

/// All of them, in the order in which a scene is written.
std::span<const Key> keys_of_scenes();

/// The one of that name; null if there is none.
const Key* find_key(std::string_view name);

/// Unit of one of these keys; "1" for all others.
std::string unit_of_key(std::string_view key);

}  // namespace microslip
