// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "microslip/patch/patch_load.hpp"
#include "microslip/patch/steady_patch.hpp"

namespace microslip {

/// A patch rolls by steps of any length. The material of each row remembers the sum of its
/// displacement and of all rigid slip so far, which does not change while it sticks. So tractions
/// that travel are not smeared, and short steps make no wiggles.
///
/// In a step over dq, the material at the centre of a cell comes from x + dq, or has entered on the
/// way. With m, its displacement before the step, its own slip is
///   t = w + [u(x) - m]/length,
/// w the mean rigid slip over the length that it rolled, which is dq or the distance to the leading
/// edge. It sticks by t = 0. It slips in the direction of the same slip of the material that passes
/// the centre in the middle of the step. As dq tends to 0, that is the slip at the centre of steady
/// rolling. Equations: docs/ellipse.md.
///
/// Motions are at most 1e8 times the strain mu p0/G, beside which displacements keep their digits.
///
/// A step that throws leaves all as it was before. One object serves one thread.
/// Order: 2 in dq; tests/unit/patch_rolling_test.cpp
/// Cost of a step: that of steady rolling; plus that of a response if its length is another one
/// than before.
class PatchRolling {
 public:
  using Index = Eigen::Index;

  /// Begins at rest, without tractions.
  /// \param problem  its load is not used
  /// \throws std::invalid_argument if a number is out of its range
  explicit PatchRolling(const SteadyPatch& problem);
  ~PatchRolling();
  PatchRolling(PatchRolling&&) noexcept;
  PatchRolling& operator=(PatchRolling&&) noexcept;

  /// Shifts the bodies without rolling.
  /// \param load  shifts of the first body [mm] and its rotation [rad] in the place of motions, or
  ///              resultants
  /// \throws std::invalid_argument as validate(SteadyPatch); NotConverged
  void shift(const PatchLoad& load);

  /// Rolls over a step.
  /// \param dq  from 1e-6 of the size and the distance rolled, to 1e6 of the size  [mm]
  /// \throws std::invalid_argument if a number is out of its range; NotConverged
  void roll(double dq, const PatchLoad& load);

  double distance() const;             ///< rolled so far  [mm]
  Eigen::VectorXd x() const;           ///< of the centres of cells  [mm]
  Eigen::VectorXd y() const;           ///< [mm]
  Eigen::MatrixX2d tractions() const;  ///< along and across, at the centres  [N/mm^2]
  Eigen::MatrixX2d slip() const;       ///< [1]; by a shift [mm]; 0 where a cell sticks
  const std::vector<bool>& slips() const;
  Eigen::Vector3d resultants() const;  ///< Fx, Fy [N], Mz about the centre [N mm]
  /// xi, eta [1] and phi [1/mm], as means over the step; of a shift in [mm] and [rad]
  Eigen::Vector3d motion() const;

  int iterations() const;   ///< systems that the last step took
  double residual() const;  ///< largest error of the slip conditions, over the bound  [1]

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace microslip
