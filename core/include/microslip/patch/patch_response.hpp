// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "microslip/patch/joined_rows.hpp"

namespace microslip {

/// Slip of the cells as a linear function of the tractions v and of the motion.
struct PatchSlipMap {
  Eigen::MatrixXd by_traction;  ///< 2n x 2n
  Eigen::MatrixX3d by_motion;   ///< 2n x 3
};

/// The part of the slip that a cell has from what was before: 2n each.
struct ImposedSlip {
  Eigen::VectorXd own, centre;
  Eigen::VectorXd seen = {};  ///< see SeenSlip; empty for none
};

/// The slip between the centre of a cell and the centre ahead, as it is seen from the contact in the
/// middle of a step: w - du/dx + du/dq. In steady rolling it is the own slip. In a step it follows from
/// the own slip of the cell and of the cell ahead, and imposed slip: by_own t + by_ahead t_ahead +
/// seen. A step that is shorter than the distance of the centres changes it by its part of that
/// distance; the rest is that of the step before, in `seen`. Where the material was not in both cells
/// before the step, it is the own slip over a longer way. Each has n values; there are none for a shift.
struct SeenSlip {
  Eigen::VectorXd by_own, by_ahead;
  Eigen::VectorXd ways;  ///< over the distance from centre to centre, >= 1

  /// In steady rolling the own slip is seen.
  static SeenSlip steady(Eigen::Index cells);
};

/// Joined rows on half-spaces of one material roll steadily. With u the displacement by the
/// tractions, the slip is rigid slip and elastic slip,
///   s = w - du/dx,  w = (xi - phi y, eta + phi x).
/// It is taken twice: as the **own** slip of a cell, a difference from its centre to the centre
/// ahead, by which the cell sticks; and as the slip at its **centre**, of fourth order, which is the
/// direction of a traction that slips. The elastic own slip is -w in a cell that sticks. All else is
/// a linear function of it.
///
/// The size of the ellipse is 1 and the shear modulus 1: unknowns are tractions over G, the spin is
/// phi c, forces are over G c^2, and the moment is over G c^3. A vector of 2n values has the
/// longitudinal parts of n cells, then the lateral ones; one of 3 values has xi, eta and phi, or Fx,
/// Fy and Mz.
class PatchResponse {
 public:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  using Stencils = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  /// \param poisson_ratio  nu, in [0, 0.5]
  PatchResponse(const JoinedRows& rows, double poisson_ratio);

  /// Makes the response of other slip than in steady rolling: in a step, or in a shift.
  /// \param pole  see pole(); without rows for a shift
  PatchResponse(const JoinedRows& rows, const PatchSlipMap& own, const PatchSlipMap& centre,
                const Stencils& pole, const SeenSlip& seen);

  const JoinedRows& rows() const { return rows_; }

  /// The unknowns by the elastic own slip: 2n x 2n.
  const Matrix& unknowns() const { return unknowns_; }

  /// The elastic slip at centres by the elastic own slip: 2n x 2n.
  const Matrix& centre_slip() const { return centre_slip_; }

  /// The lateral slip at centres that differences over a cell lack where the tractions turn about it,
  /// by the unknowns: n x 2n. About a pole of tractions of the size g, which turn with the spin,
  /// lateral slip goes as g/G ln(1/r), and cells cut the logarithm off at their own length. It is
  /// that of how much more the tractions turn with the cells around than a linear field would. Cells
  /// that are not two from all edges have none.
  const Stencils& pole() const { return pole_; }

  /// Whether slip is that in rolling, over the distance; a shift has no stencils.
  bool rolls() const { return pole_.rows() > 0; }

  /// The same by the elastic own slip: n x 2n.
  const Matrix& pole_slip() const { return pole_slip_; }

  const SeenSlip& seen() const { return seen_; }

  /// Computes the slip seen from the contact by own slip and what is imposed: 2n; 0 in a shift.
  /// \param imposed  empty for none
  void see(const Eigen::VectorXd& own, const Eigen::VectorXd& imposed,
           Eigen::VectorXd& found) const;

  /// The rigid slip by the motion: 2n x 3.
  const Eigen::MatrixX3d& rigid_own_slip() const { return rigid_own_slip_; }
  const Eigen::MatrixX3d& rigid_centre_slip() const { return rigid_centre_slip_; }

  /// The own slip of a cell by its own unknown: 2n.
  const Eigen::VectorXd& stiffness() const { return stiffness_; }

  /// Forces along and across, and the moment about the centre, by the unknowns: 3 x 2n.
  const Eigen::Matrix3Xd& resultants() const { return resultants_; }

  /// The condition number of the own slip by the unknowns, in the sum norm.
  double condition() const { return condition_; }

  /// The resultants by the elastic own slip: 3 x 2n.
  const Eigen::Matrix3Xd& relief() const { return relief_; }

  /// Resultants by the motion where all sticks: -C11, -C22, -C23, C32 and -C33 of Kalker.
  const Eigen::Matrix3d& linear() const { return linear_; }

 private:
  PatchResponse(const JoinedRows& rows, const Matrix& displacement);

  /// Sets the unknowns and the slip at centres, from those by tractions.
  void solve(const Eigen::MatrixXd& own, const Eigen::MatrixXd& centre);

  JoinedRows rows_;
  Stencils pole_;
  SeenSlip seen_;
  Matrix unknowns_, centre_slip_, pole_slip_;
  Eigen::MatrixX3d rigid_own_slip_, rigid_centre_slip_;
  Eigen::VectorXd stiffness_;
  Eigen::Matrix3Xd resultants_, relief_;
  Eigen::Matrix3d linear_;
  double condition_;
};

}  // namespace microslip
