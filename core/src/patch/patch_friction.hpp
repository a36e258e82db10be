// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "../friction/slip_friction_search.hpp"
#include "friction_rows.hpp"
#include "microslip/patch/stick_slip.hpp"

namespace microslip {

/// Stick and slip of a patch in steady rolling or in a step, by mu/mu_s of each cell. Cells are in the
/// order of JoinedRows.
class SlippingPatch : public SlipContact {
 public:
  /// The equations of stick and slip, all of which must outlive their use; scale and order are those
  /// of solve_stick_slip().
  struct Equations {
    const PatchResponse& response;
    const Eigen::VectorXd& at_rest;  ///< limits of cells at rest: n
    const PatchLoad& load;
    const PatchState* start;     ///< where a search starts; nullptr for adhesion
    const ImposedSlip* imposed;  ///< nullptr in steady rolling
  };

  /// \param rows   of the same patch, with what they remember before the step
  /// \param dq     of the step, over the size of the problem's patch; infinity in steady rolling
  /// \param speed  of a slip of 1  [mm/s]
  SlippingPatch(const Equations& equations, const FrictionRows& rows, double dq, double speed);

  void begin(double slip, Eigen::VectorXd& ratios) override;

  /// \return false also where stick and slip are not found: resultants that friction carries one by
  ///         one may be too much together
  bool solve(const Eigen::VectorXd& ratios) override;
  void find_ratios(Eigen::VectorXd& ratios) override;
  Eigen::VectorXd tractions() const override;

  /// The state of the solution, with the systems of all rounds.
  const PatchState& state() const { return state_; }

  /// Limits of cells in the solution: n.
  const Eigen::VectorXd& limits() const { return limits_; }

  /// Speeds of slip in the solution: n. A cell that begins to slip has its own slip, and not yet that
  /// at its centre, so that speeds begin at 0  [mm/s]
  Eigen::VectorXd speeds() const;

 private:
  bool carries() const;

  Equations given_;
  const FrictionRows& rows_;
  double dq_, speed_;
  Eigen::VectorXd arms_;  ///< distances of centres from x = y = 0, over the size
  Eigen::VectorXd limits_;
  PatchState state_;
  bool is_new_ = true;  ///< since begin()
  int iterations_ = 0;
};

/// Searches the solution of the patch, on the branch of its law.
/// \return whether there is a second solution
/// \throws NotConverged, also where resultants are more than friction carries as it falls
bool solve_by_friction(SlippingPatch& patch, SlipBranch branch);

}  // namespace microslip
