// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace microslip {

/// x - sin(x), without cancellation where x is small.
/// Accuracy: 1e-15 relative, tests/digits/closed_form_test.cpp
double x_minus_sine(double x);

}  // namespace microslip
