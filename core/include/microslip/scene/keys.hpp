// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// Numbers that are accepted, ends included.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool open = false;  ///< whether the least itself is excluded
};

/// A key of the scenes that read_steady, read_transient and read_cylinder take. Words and defaults
/// have their only definition here. The ranges repeat those of the model's parts, which a test
/// compares (tests/unit/scene_keys_test.cpp). tools/keys.py writes the documentation from the keys.
struct Key {
  enum class Type { word, number, whole, list, file };

  std::string_view name;
  Type type = Type::number;
  std::string_view unit = "1";  ///< "1" for words and pure numbers
  std::string_view meaning;
  std::array<std::string_view, 3> words = {};  ///< accepted; the last may be empty
  /// Gives the accepted words where a catalogue has them.
  std::vector<std::string_view> (*catalogue)() = nullptr;
  bool first_is_default = false;  ///< whether the first word is the default
  Range range = {};
  double fallback = std::numeric_limits<double>::quiet_NaN();  ///< NaN if there is no default
  std::string_view note = "";                                  ///< what else is accepted, and when
  /// Scenes in which the key has a role, as a noun; empty if it has one in all. Others refuse it.
  std::string_view role = "";
};

/// All keys, in the order in which a scene is written.
std::span<const Key> keys_of_scenes();

/// The key of that name; null if there is none.
const Key* find_key(std::string_view name);

/// Unit of one of these keys; "1" for all others.
std::string unit_of_key(std::string_view key);

/// The accepted words of a key, the default first.
std::vector<std::string_view> words_of(const Key& key);

/// Words, range and note of a key, in brackets the default: "0 ... 1 [0.5]".
/// \param quote  stands around each word
std::string accepted_by(const Key& key, const std::string& quote = "");

}  // namespace microslip
