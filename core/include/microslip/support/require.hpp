// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <concepts>
#include <stdexcept>
#include <string>
#include <string_view>

namespace microslip {

/// An error of a parameter, with the parameter's key, to which with_places() adds file and line.
class BadParameter : public std::invalid_argument {
 public:
  BadParameter(std::string_view key, const std::string& message)
      : std::invalid_argument(message), key_(key) {}

  /// The key in a scene file; a word before it says which of several values: "largest bound".
  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

/// Rejects a parameter that is a text: "<key> = '<text>': expected <accepted>".
[[noreturn]] void reject(std::string_view key, std::string_view text, std::string_view accepted);

/// Rejects a parameter with one line: "<key> = <value>: expected <accepted>".
/// \param key  the parameter's name as in a scene file, e.g. "kernel.width"
/// \throws     BadParameter if accepted_by_caller is false or the value is not finite
void require(bool accepted_by_caller, std::string_view key, double value,
             std::string_view accepted);

/// The same with a text that is made only where it is needed.
/// \param accepted  called without arguments
template <std::invocable Describe>
void require(bool accepted_by_caller, std::string_view key, double value,
             const Describe& accepted) {
  if (!accepted_by_caller || !std::isfinite(value)) require(false, key, value, accepted());
}

/// The same for sizes in mm, N and s: from 1e-50 to 1e50, so that their products are doubles.
void require_positive(std::string_view key, double value);

}  // namespace microslip
