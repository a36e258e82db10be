// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

#include "microslip/friction/active_set.hpp"
#include "microslip/friction/friction_law.hpp"

namespace microslip {

/// Computes mu/mu_s at n nodes from their slip, in [-inf, inf] and in the unit of the slip. The ratio
/// has n places. The last call of a search is for the slip of its solution.
using RatioOfSlip = std::function<void(const Eigen::VectorXd& slip, Eigen::VectorXd& ratio)>;

/// Solves slip conditions whose bound depends on the slip: with each slip the bound follows, and
/// with the bound the slip. This is done from bodies that stick and from bodies that slide fast. If
/// both come to the same end, the solution is unique as far as this search can tell.
///
/// The change falls from round to round by a factor for which docs/theory.md has formulas, "Friction
/// that falls with slip". Where the factor is above 1, there may be several solutions.
///
/// Cost: two to some hundred solves of ActiveSet, most of them with the same partition.
class SlipFrictionSearch {
 public:
  explicit SlipFrictionSearch(SlipBranch branch) : branch_(branch) {}

  /// \param conditions  in: with the bound at rest; out: with that of the solution
  /// \param state       in: zones to start from; out: the solution
  /// \throws NotConverged if there is no end, also where a force is more than friction carries as
  ///                      it falls; and as ActiveSet::solve
  void solve(ActiveSet& active_set, SlipConditions& conditions, const Prescribed& load,
             const RatioOfSlip& ratio_of, ContactState& state);

  /// mu/mu_s of the last solution, n.
  const Eigen::VectorXd& ratio() const { return ratio_; }

  /// Whether the last search found a second solution.
  bool has_second() const { return has_second_; }

 private:
  bool come_to_an_end(ActiveSet& active_set, SlipConditions& conditions, const Prescribed& load,
                      const RatioOfSlip& ratio_of, const Eigen::VectorXd& at_rest, double slip,
                      ContactState& state);

  SlipBranch branch_;
  Eigen::VectorXd ratio_;
  bool has_second_ = false;
};

}  // namespace microslip
