// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <random>

namespace microslip {

/// A random number in [0, 1), the same on all machines.
inline double unit_random(std::mt19937_64& random) {
  constexpr int digits = 53;
  return std::ldexp(static_cast<double>(random() >> (64 - digits)), -digits);
}

}  // namespace microslip
