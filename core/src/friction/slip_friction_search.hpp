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

/// A contact whose bound is mu/mu_s times that at rest, as SlipFrictionSearch solves it.
class SlipContact {
 public:
  virtual ~SlipContact() = default;

  /// Begins anew, as if all slipped at one speed.
  /// \param slip    0 or infinity
  /// \param ratios  mu/mu_s of this slip
  virtual void begin(double slip, Eigen::VectorXd& ratios) = 0;

  /// Solves with the bound of these ratios, from the last solution on.
  /// \return whether friction carries the resultants
  virtual bool solve(const Eigen::VectorXd& ratios) = 0;

  /// Computes mu/mu_s by the slip of the solution.
  virtual void find_ratios(Eigen::VectorXd& ratios) = 0;

  /// The tractions of the solution, over the largest bound at rest.
  virtual Eigen::VectorXd tractions() const = 0;
};

/// Solves slip conditions whose bound depends on the slip: with each slip the bound follows, and
/// with the bound the slip. This is done from bodies that stick and from bodies that slide fast. If
/// both come to the same end, the solution is unique as far as this search can tell.
///
/// The change falls from round to round by a factor for which docs/theory.md has formulas, "Friction
/// that falls with slip". Where the factor is above 1, there may be several solutions.
///
/// Cost: two to some hundred solves of the contact, most of them with the same partition.
class SlipFrictionSearch {
 public:
  explicit SlipFrictionSearch(SlipBranch branch) : branch_(branch) {}

  /// \return whether friction carries the resultants as it falls; if so, the contact has the solution
  /// \throws NotConverged if there is no end; and as SlipContact::solve
  [[nodiscard]] bool solve(SlipContact& contact);

  /// The same for the slip conditions of a line contact.
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
  bool come_to_an_end(SlipContact& contact, double slip);

  SlipBranch branch_;
  Eigen::VectorXd ratio_;
  bool has_second_ = false;
};

}  // namespace microslip
