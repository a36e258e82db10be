// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "speed_accuracy_runs.hpp"

namespace microslip::experiments::speed_accuracy_study {

/// Compares schemes in steady rolling under prescribed creepages with Chebyshev collocation: in
/// plane strain with all step ratios, on a strip with the first step ratio.
std::vector<RunSeries> steady_contest(const SpeedAccuracyParameters& p);

/// Compares schemes that roll from a Cattaneo shift under a constant force with `remembered` on a
/// fine grid.
std::vector<RunSeries> transient_contest(const SpeedAccuracyParameters& p);

/// Compares schemes that roll from a Cattaneo shift under a constant creepage likewise.
std::vector<RunSeries> creepage_contest(const SpeedAccuracyParameters& p);

/// Compares schemes for a cylinder that rolls from rest down a slope.
std::vector<RunSeries> cylinder_contest(const SpeedAccuracyParameters& p);

/// Measures what the number of elements does to the creepage under rough bounds.
Table rough_table(const SpeedAccuracyParameters& p);

}  // namespace microslip::experiments::speed_accuracy_study
