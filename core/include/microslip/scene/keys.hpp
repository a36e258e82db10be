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
  bool open = false;   ///< whether the least itself is excluded
  bool below = false;  ///< whether the most itself is

  constexpr bool holds(double value) const {
    return (open ? value > least : value >= least) && (below ? value < most : value <= most);
  }
};

/// With both ends; with the one there is; without the least, without the most, and without both.
constexpr Range range(double least, double most) { return {.least = least, .most = most}; }
constexpr Range range_from(double least) { return {.least = least}; }
constexpr Range range_above(double least, double most) { return {least, most, true}; }
constexpr Range range_below(double least, double most) { return {least, most, false, true}; }
constexpr Range range_inside(double least, double most) { return {least, most, true, true}; }
inline constexpr Range above_zero{.least = 0, .open = true};
inline constexpr Range fraction = range(0, 1);
inline constexpr Range inner_fraction = range_inside(0, 1);

/// A key of a scene or of a study. Words, units and defaults of scenes have their only definition
/// in keys_of_scenes(); the ranges there repeat those of the model's parts, which a test compares
/// (tests/unit/scene_keys_test.cpp). Those of studies stand beside their readers, which Scene holds
/// to them (Scene::declare). tools/keys.py writes the documentation from the keys.
struct Key {
  enum class Type { word, number, whole, list, wholes, file };

  std::string_view name;
  Type type = Type::number;
  std::string_view unit = "1";  ///< "1" for words and pure numbers
  std::string_view meaning = "";
  Range range = {};            ///< of each number of a list
  std::string_view note = "";  ///< what else is accepted, and when
  /// Scenes in which the key has a role, as a noun; empty if it has one in all. Others refuse it.
  std::string_view role = "";
  double fallback = std::numeric_limits<double>::quiet_NaN();  ///< NaN if there is no default
  std::array<std::string_view, 4> words = {};                  ///< accepted; the last may be empty
  /// Gives the accepted words where a catalogue has them.
  std::vector<std::string_view> (*catalogue)() = nullptr;
  bool first_is_default = false;  ///< whether the first word is the default
};

/// All keys of scenes, in the order in which a scene is written.
std::span<const Key> keys_of_scenes();

/// The key of that name; null if there is none.
const Key* find_key(std::string_view name);

/// Unit of one of these keys; "1" for all others.
std::string unit_of_key(std::string_view key);

/// The accepted words of a key, the default first.
std::vector<std::string_view> words_of(const Key& key);

/// As text; empty if there is none.
std::string default_of(const Key& key);

/// Words, range and note of a key, in brackets the default if there is one: "0 ... 1 [0.5]".
/// \param quote  stands around each word
std::string accepted_by(const Key& key, const std::string& fallback, const std::string& quote = "");

/// Accepted values in a message: "whole numbers 3 ... 10 000; in rising order".
std::string expected_by(const Key& key);

}  // namespace microslip
