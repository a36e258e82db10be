// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace microslip {

/// Integral over [begin, end], finite; the ends may be integrable singularities. GSL's QAGS.
/// \param relative  required relative accuracy, in [1e-14, 1)
/// \throws NotConverged if the accuracy is not reached; the residual is the estimated relative
///                      error
double integrate(const std::function<double(double)>& integrand, double begin, double end,
                 double relative);

}  // namespace microslip
