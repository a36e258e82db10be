// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/patch/patch_response.hpp"
#include "microslip/patch/stick_slip.hpp"

namespace microslip {

/// The condition of a cell, linear about a state: by_q q + by_own t + by_centre c = right.
struct CellCondition {
  Eigen::Matrix2d by_q, by_own, by_centre;
  Eigen::Vector2d right;
};

/// The slip conditions of cells; equations and letters are those of solve_stick_slip().
class CellConditions {
 public:
  using Index = Eigen::Index;
  using Vector2d = Eigen::Vector2d;

  /// \param limits  g, which must outlive this object
  CellConditions(const PatchResponse& response, const Eigen::VectorXd& limits);

  /// \param length_ratio  r over r0
  /// \param width         of the transition: |q - r0 t| - 1 from which the slip is that at the centre
  void set(double length_ratio, double width);

  Vector2d quotient(const PatchState& state, Index i) const;

  /// Those of all cells, on the disc: 2n.
  Eigen::VectorXd quotients(const PatchState& state) const;

  /// Whether a cell slips in the next system, |q - r t| > 1.
  bool slips_next(const PatchState& state, Index i) const;

  /// s, which begins at the own slip and becomes that at the centre.
  Vector2d slip(const PatchState& state, Index i) const;

  /// |q - P(q - r0 s)|
  double error(const PatchState& state, Index i) const;

  /// The largest error, not a number if one is not.
  double residual(const PatchState& state) const;

  /// With z = q - r s, e = z/|z| and D = (1 - e e')/|z|, the condition q = e is linear about z:
  ///   (1 - D) q + r D s = e.
  /// Within the disc the condition is s = 0, which is e = 0 and D = 1.
  /// In the transition s depends on q - r0 t, too.
  /// \param q  on the disc
  CellCondition about(const PatchState& state, Index i, const Vector2d& q) const;

 private:
  const Eigen::VectorXd* limits_;
  Eigen::VectorXd lengths_;  ///< r0
  double length_ratio_ = 1, width_ = 0;
};

}  // namespace microslip
