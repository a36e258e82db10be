// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/sine.hpp"

#include <cmath>

namespace microslip {

double x_minus_sine(double x) {
  if (std::abs(x) > 1.5) return x - std::sin(x);
  // The Taylor series, summed from the smallest term.
  constexpr int terms = 11;
  double sum = 0;
  for (int k = terms; k >= 1; --k) {
    sum = x * x / (2 * k * (2 * k + 1)) * (1 - sum);
  }
  return x * sum;
}

}  // namespace microslip
