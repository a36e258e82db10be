// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/patch/patch_response.hpp"
#include "microslip/patch/stick_slip.hpp"

namespace microslip {

/// The part of its limit that a cell carries less, and its derivatives.
struct Shortfall {
  double value = 0;
  Eigen::RowVector2d by_seen_ahead =
      Eigen::RowVector2d::Zero();                     ///< by seen slip of the cell ahead
  Eigen::RowVector2d by_seen = by_seen_ahead;         ///< by that of the cell
  Eigen::RowVector2d by_seen_behind = by_seen_ahead;  ///< by that of the cell behind
  Eigen::RowVector2d by_q_ahead = by_seen_ahead;      ///< by q of the cell ahead
  Eigen::RowVector2d by_q = by_seen_ahead;            ///< by that of the cell
};

/// The cells in which slip begins, behind a zone that sticks.
///
/// Traction has a kink there, a square root of the distance, which is not in what is interpolated
/// between centres. With the boundary at the part z of the way from the centre of a cell to the centre
/// ahead, and a kink that is b after one cell, the forces are those of a line contact if the cell
/// carries b (1 - z)(0.19 - 0.55 z + 0.15 z^2) less than its limit: less as slip begins at its centre,
/// and a little more as the boundary goes on. Here z and b follow from the slip of the cell, as far as
/// it is against its traction, from that of the cell behind, and from the traction of the cell ahead.
/// Derivation: docs/ellipse.md.
class SlipBoundary {
 public:
  using Index = Eigen::Index;

  /// \param response  must outlive this object
  /// \param limits    g, over G and by p/v; must outlive this object
  SlipBoundary(const PatchResponse& response, const Eigen::VectorXd& limits);

  /// The shortfall of a cell in a state. It is 0 of cells at the edges, and in shifts.
  Shortfall shortfall(const PatchState& state, Index cell) const;

 private:
  const PatchResponse* response_;
  const Eigen::VectorXd* limits_;
  Eigen::VectorXd slips_;  ///< slip of the cell behind over b and slip_behind(): n
};

}  // namespace microslip
