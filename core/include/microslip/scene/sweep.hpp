// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/scene/scene.hpp"

namespace microslip {

/// A key of a scene, and the texts it takes in turn.
struct SweptKey {
  std::string key;
  std::vector<std::string> values;
};

/// The values in a text: separated by blanks, or by | where values have blanks themselves. Ranges
/// among them are expanded:
///   first:step:last   first, first + step, ... up to last at most
///   first:logN:last   N numbers with equal ratios, both ends included; N >= 2, none zero, one sign
/// Numbers of a range are rounded to 15 digits of its largest, or of themselves with logN.
/// \param key  for messages
/// \throws std::invalid_argument in one line that names the key
std::vector<std::string> swept_values(const std::string& key, const std::string& text);

/// Many scenes in one: its section `sweep` gives keys more than one value. Cases are all
/// combinations, and the last key varies fastest.
class Sweep {
 public:
  static constexpr std::size_t max_cases = 100000;

  /// \throws std::invalid_argument if there is no section `sweep`, for what swept_values rejects,
  ///         and for more than max_cases cases
  explicit Sweep(Scene scene);

  const std::vector<SweptKey>& keys() const { return keys_; }
  std::size_t size() const { return size_; }

  /// Values of the swept keys of a case.
  std::vector<std::string> values(std::size_t index) const;

  /// Scene of a case: a swept value wins over one outside of the section.
  Scene scene(std::size_t index) const;

 private:
  Scene common_;
  Scene section_;
  std::vector<SweptKey> keys_;
  std::size_t size_ = 1;
};

}  // namespace microslip
