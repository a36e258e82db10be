// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/halfspace/basis.hpp"
#include "microslip/linalg/solver.hpp"

namespace microslip {

/// Distance, in elements, from the outermost nodes to the edges at which a scheme of differences
/// over one element feels its tractions vanish, found where the exact solution is known: for n
/// elements and a strain that grows linearly (Carter's), the distance for which the force is exact.
/// For n -> inf it tends to 0.825347 for constant and to 0.884948 for linear functions, as
/// Wiener-Hopf theory says, tests/unit/edge_calibration_test.cpp.
/// \param elements  n, >= 2; odd for quadratic functions
double calibrated_offset(const Basis& basis, Eigen::Index elements, const Solver& solver = {});

/// The same with a Winkler layer in series: the difference of leading_edge_constants() with and
/// without it is added, which is that for n -> inf; of springs alone 1.
/// \param softness  microslip::softness(), in [0, inf]
/// \throws std::invalid_argument for quadratic functions with a softness above 0 that is finite
double calibrated_offset(const Basis& basis, Eigen::Index elements, double softness,
                         const Solver& solver = {});

/// The fraction of the strain by a pressure that a difference over the element ahead of the last
/// node is to have, if the pressure vanishes like a square root at the leading edge and the bodies
/// stick there: then free rolling without slip has its creepage to second order, 2/pi beta a/R_r.
/// For constant functions, the last node calibrated_offset() elements from the edge. Measured with
/// up to 800 elements and extrapolated; tests/unit/unlike_bodies_test.cpp.
inline constexpr double pressure_seen_at_edge = 0.96989;

}  // namespace microslip
