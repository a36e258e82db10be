// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <concepts>
#include <stdexcept>
#include <string>
#include <string_view>

namespace microslip {

/// An error of a parameter, with the parameter's name. An argument of core has its name in the C++
/// interface, "half_width". with_places() turns the error into one of the scene's key,
/// "contact.half_width", and adds file and line.
class BadParameter : public std::invalid_argument {
 public:
  BadParameter(std::string_view name, const std::string& message)
      : std::invalid_argument(message), name_(name) {}

  /// Name of an argument, or key of a scene. Words in front of the name can select one of several
  /// values: "least value of coefficients".
  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

/// Rejects a parameter that is a text: "<name> = '<text>': expected <accepted>".
[[noreturn]] void reject(std::string_view name, std::string_view text, std::string_view accepted);

/// Rejects a parameter with one line: "<name> = <value>: expected <accepted>".
/// \param name  name of an argument, e.g. "half_width", or key of a scene
/// \throws      BadParameter if accepted_by_caller is false or the value is not finite
void require(bool accepted_by_caller, std::string_view name, double value,
             std::string_view accepted);

/// The same; the text of accepted values is made only for an error.
/// \param accepted  called without arguments
template <std::invocable Describe>
void require(bool accepted_by_caller, std::string_view name, double value,
             const Describe& accepted) {
  if (!accepted_by_caller || !std::isfinite(value)) require(false, name, value, accepted());
}

/// Rejects sizes in mm, N and s outside [1e-50, 1e50], so that products of sizes neither overflow
/// nor underflow.
void require_positive(std::string_view name, double value);

}  // namespace microslip
