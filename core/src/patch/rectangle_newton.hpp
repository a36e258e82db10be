// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/linalg/gmres.hpp"
#include "microslip/patch/patch_load.hpp"
#include "microslip/patch/rectangles.hpp"

namespace microslip {

/// The slip conditions of rectangles: s = W m + B p + s0 with the motion m, and in each element
///   |p| <= g where s = 0,  p = -g s/|s| elsewhere;  R p are the resultants.
/// Vectors of 2n values have the parts along the rolling, then those across. The largest g is to be
/// about 1.
struct RectangleConditions {
  const Rectangles& rectangles;
  const RectangleInfluence& influence;  ///< B
  const Eigen::MatrixX3d& rigid;        ///< W: 2n x 3
  const Eigen::VectorXd& given;         ///< s0: 2n
  const Eigen::VectorXd& limits;        ///< g >= 0: n
  const Eigen::Matrix3Xd& resultants;   ///< R: 3 x 2n
  PatchLoad load;                       ///< m or R p, by components
};

/// Tractions and slip that fulfil them.
struct RectangleState {
  Eigen::VectorXd tractions;  ///< 2n
  Eigen::VectorXd slip;       ///< 2n, 0 where an element sticks
  Eigen::Vector3d motion;
  std::vector<bool> slips;  ///< n
  int iterations = 0;       ///< systems that were solved
  double residual = 0;  ///< largest error of a traction, and of a resultant over the largest one
};

/// Solves the conditions by Newton's method on p = P(p - r s), with the projection P onto the disc
/// of an element and a length r. An element slips where |p - r s| > g. Systems are solved by GMRES
/// with products by FFT; the blocks of rows are the preconditioner. Where Newton's method does not
/// converge, it is tried with other lengths and shorter steps, then the load is raised in parts.
/// \param start  tractions and motion to start from, beside full adhesion; nullptr for none
/// \throws NotConverged
RectangleState solve_rectangles(const RectangleConditions& conditions, const RectangleState* start);

}  // namespace microslip
