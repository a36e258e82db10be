// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/experiments/open_problems.hpp"

namespace microslip::experiments::open_problems_study {

/// Steady rolling by all treatments of the leading edge, against Chebyshev collocation.
struct SteadyTables {
  Table cases;
  Table errors;
  Table orders;
  Table steps;
};

SteadyTables steady_tables(const OpenProblemsParameters& p, const Progress& progress);

/// An error of Chebyshev collocation up to this is rounding only  [1].
inline constexpr double chebyshev_rounding = 1e-12;

/// An error of the inversion up to this is rounding only  [1].
inline constexpr double inversion_rounding = 1e-12;

/// The creepage-force curve, and the digits of its points.
struct CurveTables {
  Table curve;
  Table digits;
};

CurveTables curve_tables(const OpenProblemsParameters& p);

}  // namespace microslip::experiments::open_problems_study
