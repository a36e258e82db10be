// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/scene/model.hpp"

namespace microslip {

/// \file
/// Forecasts of memory, work and steps of a scene.

/// About how much memory it takes at most to solve a scene and to write its tables  [bytes]:
///
///                           Toeplitz, per element   dense, per N^2 numbers
///   steady, differences     1000                    2.7
///   steady, calibrated      1000                    4
///   steady, chebyshev       600
///   transient               1600                    4.1
///   cylinder                1600                    5
///
/// and 1 kB a step or shift. Measured at N from 2e4 to 1e6 by FFT, and from 2000 to 4000 with all
/// entries, as the largest resident set less 12 MB that a program takes anyway; each is the largest
/// over schemes and bases. An inversion takes as much as calibrated elements at most, which replace
/// it where there is more than one stick zone. Nothing is known with target_error.
///
/// \throws std::invalid_argument if matrices would be too large as they must be dense
double memory_needed(const Model& model);

/// About how many operations, as support/work counts them, a solution takes, where inversion is not
/// replaced by elements: within a factor of three for N from 100 to 6400, of shifts before rolling
/// eight (tests/unit/cost_test.cpp); nan with target_error.
double work_needed(const Model& model);

/// Steps of a transient, or of a cylinder as long as it does not swing; 0 in steady rolling.
double steps_needed(const Model& model);

}  // namespace microslip
