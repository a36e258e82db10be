// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/scene/scene.hpp"

namespace microslip {

/// A key of a scene, and the texts it takes in turn.
struct SweptKey {
  std::string key;
  std::vector<std::string> values;
  std::string unit = "1";  ///< of the values
};

/// The key that a key of a scene sweeps: "grid.elements" of "sweep.grid.elements" and of
/// "sweep.together_2.grid.elements"; nothing for any other key.
std::optional<std::string> swept_key(const std::string& key);

/// The values in a text: separated by blanks, or by | where values have blanks themselves. Ranges
/// among them are expanded:
///   first:step:last   first, first + step, ... up to last at most
///   first:logN:last   N numbers with equal ratios, both ends included; N >= 2, none zero, one sign
/// Numbers of a range are rounded to 15 digits of its largest, or of themselves with logN.
/// \param name  that sweeps a key: "sweep.grid.elements"
/// \param unit  of the values; nothing for that of the key in two dimensions
/// \throws std::invalid_argument in one line that has the name
std::vector<std::string> swept_values(const std::string& name, const std::string& text,
                                      const std::optional<std::string>& unit = std::nullopt);

/// Many scenes in one: its section `sweep` gives keys more than one value. Cases are all
/// combinations, and the last key varies fastest. Keys in a section `together`, or another one of
/// which the name begins so, take their values row by row, and so do the columns of the file that
/// the key `table` names. Such a group counts as one key, in the place of its first one.
class Sweep {
 public:
  static constexpr std::size_t max_cases = 100000;

  /// \param scene  a column of the table is left out if set() has given its key
  /// \throws std::invalid_argument if there is no section `sweep`, for what swept_values rejects,
  ///         for lists of a group that differ in length, for a key that is swept twice, for a table
  ///         that cannot be read or has a column that is no key, and for more than max_cases cases
  explicit Sweep(Scene scene);

  /// The swept keys; the keys of a group follow one another.
  const std::vector<SweptKey>& keys() const { return keys_; }
  std::size_t size() const { return size_; }

  /// Values of the swept keys of a case.
  std::vector<std::string> values(std::size_t index) const;

  /// Scene of a case: a swept value wins over one outside of the section.
  Scene scene(std::size_t index) const;

 private:
  void add_group(const std::string& name);
  void add_columns(const std::vector<SweptKey>& columns);
  void add(const std::string& name, const std::string& key, std::vector<std::string> values);
  void close_group(const std::string& name);

  Scene common_;
  bool in_patch_ = false;
  Scene section_;  ///< the swept keys, with their places
  std::vector<SweptKey> keys_;
  std::vector<std::size_t> groups_;  ///< where the keys of each end among all
  std::size_t size_ = 1;
};

}  // namespace microslip
