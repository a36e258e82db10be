// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "../friction/slip_friction_search.hpp"
#include "microslip/friction/active_set.hpp"
#include "microslip/rolling/advection.hpp"
#include "rolling_grid.hpp"

namespace microslip {

/// Nodes that move with the contact, so that the previous tractions have to be moved.
class ContactGrid final : public RollingGrid {
 public:
  /// \throws std::invalid_argument as Advection
  explicit ContactGrid(const TransientProblem& problem);

  std::unique_ptr<RollingGrid> clone() const override;
  Eigen::VectorXd traction_at_nodes(const TransientState& state) const override;
  Eigen::VectorXd displacement(const Eigen::VectorXd& traction) override {
    return active_set_.response() * traction;
  }
  double condition() override { return active_set_.condition(); }
  void start_from(const Eigen::VectorXd& traction, TransientState& state) override;
  Shift solve_shift(const TransientState& before, const ShiftLoad& load,
                    TransientState& after) override;
  void solve_step(const TransientState& before, double length, const Load& load,
                  TransientState& after, StepJacobian* jacobian) override;
  void accept_step() override;
  void set_speed(double speed) override;

 private:
  void solve_slip(const ShiftLoad& load, double length);

  double dissipation(const TransientState& before, const TransientState& after,
                     double length) const;

  AdvectionScheme scheme_;
  double spacing_;
  ActiveSet active_set_;
  TractionBound traction_bound_;
  Eigen::VectorXd mean_bound_;
  Advection advection_;
  std::optional<SlipFriction> friction_;
  std::optional<SlipFrictionSearch> search_;  ///< if friction depends on slip

  // Conditions and state of the step that was solved last.
  SlipConditions conditions_;
  ContactState contact_;
};

}  // namespace microslip
