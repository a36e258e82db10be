// SPDX-License-Identifier: GPL-3.0-or-later
#include "kalker_printed.hpp"

#include <cmath>
#include <cstddef>

namespace microslip::experiments {

namespace {

constexpr std::size_t ratios = 19;
using Row = std::array<double, ratios>;

constexpr std::array<double, 3> poisson_ratios{0, 0.25, 0.5};

// The rows are for nu = 0, 1/4, 1/2. With nu = 0, C22 is C11.
constexpr std::array<Row, 3> c11{Row{2.51, 2.59, 2.68, 2.78, 2.88, 2.98, 3.09, 3.19, 3.29, 3.40,
                                     3.51, 3.65, 3.82, 4.06, 4.37, 4.84, 5.57, 6.96, 10.7},
                                 Row{3.31, 3.37, 3.44, 3.53, 3.62, 3.72, 3.81, 3.91, 4.01, 4.12,
                                     4.22, 4.36, 4.54, 4.78, 5.10, 5.57, 6.34, 7.78, 11.7},
                                 Row{4.85, 4.81, 4.80, 4.82, 4.83, 4.91, 4.97, 5.05, 5.12, 5.20,
                                     5.30, 5.42, 5.58, 5.80, 6.11, 6.57, 7.34, 8.82, 12.9}};
constexpr std::array<Row, 3> c22{c11[0],
                                 Row{2.52, 2.63, 2.75, 2.88, 3.01, 3.14, 3.28, 3.41, 3.54, 3.67,
                                     3.81, 3.99, 4.21, 4.50, 4.90, 5.48, 6.40, 8.14, 12.8},
                                 Row{2.53, 2.66, 2.81, 2.98, 3.14, 3.31, 3.48, 3.65, 3.82, 3.98,
                                     4.16, 4.39, 4.67, 5.04, 5.56, 6.31, 7.51, 9.79, 16.0}};
constexpr std::array<Row, 3> c23{Row{.334, .483, .607, .720, .827, .930, 1.03, 1.13, 1.23, 1.33,
                                     1.44, 1.58, 1.76, 2.01, 2.35, 2.88, 3.79, 5.72, 12.2},
                                 Row{.473, .603, .715, .823, .929, 1.03, 1.14, 1.25, 1.36, 1.47,
                                     1.59, 1.75, 1.95, 2.23, 2.62, 3.24, 4.32, 6.63, 14.6},
                                 Row{.731, .809, .889, .977, 1.07, 1.18, 1.29, 1.40, 1.51, 1.63,
                                     1.77, 1.94, 2.18, 2.50, 2.96, 3.70, 5.01, 7.89, 18.0}};
constexpr std::array<Row, 3> c33{Row{6.42, 3.46, 2.49, 2.02, 1.74, 1.56, 1.43, 1.34, 1.27, 1.21,
                                     1.16, 1.10, 1.05, 1.01, .958, .912, .868, .828, .795},
                                 Row{8.28, 4.27, 2.96, 2.32, 1.93, 1.68, 1.50, 1.37, 1.27, 1.19,
                                     1.11, 1.04, .965, .892, .819, .747, .674, .601, .526},
                                 Row{11.7, 5.66, 3.72, 2.77, 2.22, 1.86, 1.60, 1.42, 1.27, 1.16,
                                     1.06, .954, .852, .751, .650, .549, .446, .341, .228}};

double ratio_of(std::size_t i) {
  const double up = static_cast<double>(i + 1) / 10, down = static_cast<double>(ratios - i) / 10;
  return up <= 1 ? up : 1 / down;
}

/// All values have three digits.
Printed printed(double value) { return {value, std::pow(10, std::floor(std::log10(value)) - 2)}; }

}  // namespace

std::optional<std::array<Printed, 4>> kalker_printed(double ratio, double poisson_ratio) {
  for (std::size_t n = 0; n < poisson_ratios.size(); ++n) {
    if (poisson_ratio != poisson_ratios[n]) continue;
    for (std::size_t i = 0; i < ratios; ++i) {
      if (std::abs(ratio / ratio_of(i) - 1) > 1e-9) continue;
      return std::array{printed(c11[n][i]), printed(c22[n][i]), printed(c23[n][i]),
                        printed(c33[n][i])};
    }
  }
  return std::nullopt;
}

}  // namespace microslip::experiments
