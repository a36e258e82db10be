// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/patch/joined_rows.hpp"

namespace microslip {

/// Slip as a linear function of the unknowns and of the rigid motion.
struct SlipMap {
  Eigen::MatrixXd by_traction;  ///< 2n x 2n
  Eigen::MatrixX3d by_motion;   ///< 2n x 3
};

/// The slip and the resultants of joined rows on half-spaces of one material, in steady rolling:
///   s = w + du/dq - du/dx,  w = (xi - phi y, eta + phi x).
/// The size of the ellipse is 1 and the shear modulus 1: unknowns are tractions over G, the spin is
/// phi c, forces are over G c^2, and the moment is over G c^3.
///
/// A vector of 2n values has the longitudinal parts of n cells, then the lateral ones.
class PatchResponse {
 public:
  using Index = Eigen::Index;

  /// \param poisson_ratio  nu, in [0, 0.5]
  PatchResponse(const JoinedRows& rows, double poisson_ratio);

  const JoinedRows& rows() const { return rows_; }

  /// The slip by which a cell sticks: a difference from its centre to the centre ahead, for the
  /// first cell to the leading edge.
  const SlipMap& own() const { return own_; }

  /// The unknowns by motion where all sticks.
  const Eigen::MatrixX3d& adhering() const { return adhering_; }

  /// Forces along and across, and the moment about the centre, by the unknowns: 3 x 2n.
  const Eigen::Matrix3Xd& resultants() const { return resultants_; }

  /// Resultants by motion where all sticks: -C11, -C22, -C23, C32 and -C33 of Kalker.
  Eigen::Matrix3d linear() const { return resultants_ * adhering_; }

 private:
  JoinedRows rows_;
  SlipMap own_;
  Eigen::MatrixX3d adhering_;
  Eigen::Matrix3Xd resultants_;
};

}  // namespace microslip
