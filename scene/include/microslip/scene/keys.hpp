// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// An interval of accepted numbers, ends included.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool open = false;   ///< whether `least` is excluded
  bool below = false;  ///< whether `most` is excluded

  constexpr bool holds(double value) const {
    return (open ? value > least : value >= least) && (below ? value < most : value <= most);
  }
};

/// Ranges that include both ends; have no upper end; exclude `least`; exclude `most`; exclude both.
constexpr Range range(double least, double most) { return {.least = least, .most = most}; }
constexpr Range range_from(double least) { return {.least = least}; }
constexpr Range range_above(double least, double most) { return {least, most, true}; }
constexpr Range range_below(double least, double most) { return {least, most, false, true}; }
constexpr Range range_inside(double least, double most) { return {least, most, true, true}; }
inline constexpr Range above_zero{.least = 0, .open = true};
inline constexpr Range fraction = range(0, 1);
inline constexpr Range inner_fraction = range_inside(0, 1);

/// A key of a scene or of a study. Words, units and defaults of scenes have their only definition
/// in keys_of_scenes(). The ranges there repeat the ranges that core checks; a test compares both
/// (tests/unit/scene_keys_test.cpp). Keys of studies are defined beside the code that reads them,
/// and Scene enforces them (Scene::declare). tools/keys.py writes the documentation from the keys.
struct Key {
  enum class Type { word, number, whole, list, wholes, file, text };

  std::string_view name;
  Type type = Type::number;
  std::string_view unit = "1";  ///< "1" for words and pure numbers
  std::string_view meaning = "";
  Range range = {};            ///< for a list, range of each number
  std::string_view note = "";  ///< further accepted values, and conditions
  /// Scenes in which the key has a role, as a noun; other scenes reject the key. Empty if the key
  /// has a role in all scenes.
  std::string_view role = "";
  double fallback = std::numeric_limits<double>::quiet_NaN();  ///< NaN if there is no default
  std::array<std::string_view, 8> words = {};                  ///< accepted words; unused entries
                                                               ///< are empty
  /// Gives the accepted words if they come from a catalogue.
  std::vector<std::string_view> (*catalogue)() = nullptr;
  bool first_is_default = false;     ///< whether the first word is the default
  std::string_view patch_unit = "";  ///< in three dimensions, if it differs
  std::string_view patch_role = "";  ///< in three dimensions, where only some have the key
};

/// All keys of scenes, in the order of a written scene.
std::span<const Key> keys_of_scenes();

/// The key of that name; null if there is none.
const Key* find_key(std::string_view name);

/// The known key of the same name in another section, or else of the nearest name; empty if there
/// is none. Capital letters of the key count as small ones. Without `known`, among all keys of scenes.
std::string likely_key(const std::string& key, const std::vector<std::string>& known);
std::string likely_key(const std::string& key);

/// The keys of which each makes a scene three-dimensional.
inline constexpr std::array patch_keys{"contact.lateral_half_width", "contact.lateral_radius_1",
                                       "contact.lateral_radius_2", "contact.patch_file"};
bool is_patch_key(std::string_view key);

/// The unit of a key of scenes; "1" for all other keys.
/// \param in_patch  whether the scene has one of `patch_keys`
std::string unit_of_key(std::string_view key, bool in_patch = false);

std::string_view unit_of(const Key& key, bool in_patch);

/// The accepted words of a key, the default first.
std::vector<std::string_view> words_of(const Key& key);

/// The default of a key as text; empty if there is none.
std::string default_of(const Key& key);

/// Words, range and note of a key, followed by the default, if any, in brackets: "0 ... 1 [0.5]".
/// \param quote  put around each word
std::string accepted_by(const Key& key, const std::string& fallback, const std::string& quote = "");

/// The accepted values of a key, for a message: "whole numbers 3 ... 10 000; in rising order".
std::string expected_by(const Key& key);

}  // namespace microslip
