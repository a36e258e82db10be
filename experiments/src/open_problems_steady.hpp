// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/experiments/open_problems.hpp"

namespace microslip::experiments {

/// Steady rolling by all treatments of the leading edge, against Chebyshev collocation.
struct SteadyTables {
  Table cases;
  Table errors;
  Table orders;
  Table steps;
};

SteadyTables steady_tables(const OpenProblemsParameters& p, const Progress& progress);

/// The creepage-force curve, and the digits of its points.
struct CurveTables {
  Table curve;
  Table digits;
};

CurveTables curve_tables(const OpenProblemsParameters& p);

}  // namespace microslip::experiments
