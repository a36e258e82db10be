// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/patch/steady_patch.hpp"

namespace microslip {

/// Units of motions and resultants by which the bound's peak, the size of the patch and the shear
/// modulus are 1.
struct PatchUnits {
  Eigen::Vector3d motion, resultant;
  Eigen::Vector3d shift;  ///< of shifts and the rotation in the place of motions
  double peak;            ///< of the bound  [N/mm^2]
  double size;            ///< c  [mm]

  PatchUnits(const Material& material, double peak_of_bound, double size_of_patch)
      : resultant(peak_of_bound * size_of_patch * size_of_patch *
                  Eigen::Vector3d(1, 1, size_of_patch)),
        peak(peak_of_bound),
        size(size_of_patch) {
    const double strain = peak / material.shear_modulus;
    motion = {strain, strain, strain / size};
    shift = size * motion;
  }

  /// The load in these units.
  /// \param motions  motion, or shift
  PatchLoad scaled(PatchLoad load, const Eigen::Vector3d& motions) const;
};

/// The joined rows of a problem, of the size 1.
JoinedRows rows_of(const SteadyPatch& problem);

/// Limits of v by the bound at the centres of cells, over its peak and tan(theta/2).
/// \throws std::invalid_argument if a limit is not positive
Eigen::VectorXd limits_of(const JoinedRows& rows, const PatchBound& bound);

/// The centres of cells, x and y, over the size.
Eigen::MatrixX2d centres_of(const JoinedRows& rows);

/// The slip at the centres of cells along and across, 0 where they stick.
Eigen::MatrixX2d slip_of(const PatchState& state);

/// The unknowns v within limits. Where the boundary of slip is within a cell, they may be above them by
/// some hundredths, see SlipBoundary.
Eigen::VectorXd within_limits(const Eigen::VectorXd& unknowns, const Eigen::VectorXd& limits);

/// The tractions at the centres of cells, along and across, by the unknowns v in units of the peak.
Eigen::MatrixX2d tractions_of(const JoinedRows& rows, const Eigen::VectorXd& unknowns, double peak);

/// The same tractions, of which those above the bound by rounding are the bound.
/// \param bound  of as many elements
/// \throws std::invalid_argument for another number of them, and above the bound
Eigen::MatrixX2d tractions_within(const Eigen::MatrixX2d& tractions, const Eigen::VectorXd& bound);

}  // namespace microslip
