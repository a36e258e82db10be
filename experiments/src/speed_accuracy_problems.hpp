// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "speed_accuracy_runs.hpp"

namespace microslip::experiments::speed_accuracy_study {

/// Steady rolling under prescribed creepages, against Chebyshev collocation: plane strain with all
/// step ratios, and a strip with the first of them.
std::vector<RunSeries> steady_contest(const SpeedAccuracyParameters& p);

/// From a Cattaneo shift, under a constant force, against a fine grid (remembered).
std::vector<RunSeries> transient_contest(const SpeedAccuracyParameters& p);

/// A cylinder from rest down a slope.
std::vector<RunSeries> cylinder_contest(const SpeedAccuracyParameters& p);

}  // namespace microslip::experiments::speed_accuracy_study
