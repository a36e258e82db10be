// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/patch/steady_patch.hpp"

namespace microslip {

/// Units of motions and resultants by which the bound's peak, the size of the patch and the shear
/// modulus are 1.
struct PatchUnits {
  Eigen::Vector3d motion, resultant;

  explicit PatchUnits(const SteadyPatch& problem) {
    const double strain = problem.bound.peak() / problem.material.shear_modulus;
    const double c = problem.bound.size();
    motion = {strain, strain, strain / c};
    resultant = problem.bound.peak() * c * c * Eigen::Vector3d(1, 1, c);
  }
};

/// Limits of v by the bound at the centres of cells, over its peak and tan(theta/2).
/// \throws std::invalid_argument if a limit is not positive
Eigen::VectorXd limits_of(const JoinedRows& rows, const PatchBound& bound);

}  // namespace microslip
