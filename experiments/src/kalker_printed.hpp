// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

namespace microslip::experiments {

/// A coefficient as it is printed, and a unit of its last digit.
struct Printed {
  double value;
  double digit;
};

/// C11, C22, C23 and C33 of Kalker, Three-Dimensional Elastic Bodies in Rolling Contact (1990),
/// table E3.
/// \param ratio          a/b: 0.1, 0.2 ... 1, 1/0.9, 1/0.8 ... 10
/// \param poisson_ratio  0, 0.25 or 0.5
/// \return none for others
std::optional<std::array<Printed, 4>> kalker_printed(double ratio, double poisson_ratio);

}  // namespace microslip::experiments
