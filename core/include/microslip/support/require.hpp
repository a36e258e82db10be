// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <concepts>
#include <stdexcept>
#include <string>
#include <string_view>

namespace microslip {

/// An error of a parameter, with its name. An argument of core has the name that it has in the
/// interface of C++, "half_width". with_places() makes it an error of the key of the scene,
/// "contact.half_width", and adds file and line.
class BadParameter : public std::invalid_argument {
 public:
  BadParameter(std::string_view name, const std::string& message)
      : std::invalid_argument(message), name_(name) {}

  /// An argument, or a key of a scene; words before it say which of its values:
  /// "least value of coefficients".
  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

/// Rejects a parameter that is a text: "<name> = '<text>': expected <accepted>".
[[noreturn]] void reject(std::string_view name, std::string_view text, std::string_view accepted);

/// Rejects a parameter with one line: "<name> = <value>: expected <accepted>".
/// \param name  of an argument, e.g. "half_width"; or the key of a scene
/// \throws      BadParameter if accepted_by_caller is false or the value is not finite
void require(bool accepted_by_caller, std::string_view name, double value,
             std::string_view accepted);

/// The same with a text that is made only where it is needed.
/// \param accepted  called without arguments
template <std::invocable Describe>
void require(bool accepted_by_caller, std::string_view name, double value,
             const Describe& accepted) {
  if (!accepted_by_caller || !std::isfinite(value)) require(false, name, value, accepted());
}

/// The same for sizes in mm, N and s: from 1e-50 to 1e50, so that their products are doubles.
void require_positive(std::string_view name, double value);

}  // namespace microslip
