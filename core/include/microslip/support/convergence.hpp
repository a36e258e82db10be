// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace microslip {

/// Order of convergence: least-squares slope of -log|error| against log(size).
/// \param sizes   at least two, positive, not all equal
/// \param errors  as many as sizes, not zero
/// \throws std::invalid_argument otherwise
double fitted_order(std::span<const double> sizes, std::span<const double> errors);

}  // namespace microslip
