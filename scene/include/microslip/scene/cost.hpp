// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/scene/model.hpp"

namespace microslip {

/// \file
/// Forecasts of memory, work and steps of a scene.

/// Approximate upper limit of the memory to solve a scene and to write its tables  [bytes]:
///
///                           Toeplitz, per element   dense, per N^2 numbers
///   steady, differences     1000                    2.7
///   steady, calibrated      1000                    4
///   steady, chebyshev       600
///   transient               1600                    4.1
///   cylinder                1600                    5
///
/// and 1 kB per step or shift. The figures were measured at N from 2e4 to 1e6 by FFT, and from 2000
/// to 4000 with dense matrices, as the largest resident set minus the 12 MB of any program; each
/// figure is the largest over schemes and bases. Inversion takes at most the memory of calibrated
/// elements, which replace it if there is more than one stick zone. With target_error there is no
/// forecast for a line contact, and that of the finest grid for a patch.
///
/// \throws std::invalid_argument if matrices have to be dense and would be too large
double memory_needed(const Model& model);

/// Approximate number of operations of a solution, counted as in support/work, unless elements
/// replace inversion. It is accurate to a factor of three for N from 100 to 6400, and to a factor
/// of eight for shifts before rolling (tests/unit/cost_test.cpp); nan with target_error.
double work_needed(const Model& model);

/// Number of steps of a transient, or of a cylinder as long as the cylinder does not swing; 0 in
/// steady rolling.
double steps_needed(const Model& model);

}  // namespace microslip
