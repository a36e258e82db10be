// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <string>

#include "microslip/friction/friction_law.hpp"

namespace microslip::experiments {

/// Watches whether forces go back and forth from step to step. Where friction falls with slip at once,
/// each step may find the bodies sticking or sliding anew, and no step has a second solution then.
class BackAndForth {
 public:
  /// \param start  the force before the first step, over full sliding
  BackAndForth(const std::optional<SlipFriction>& friction, const Eigen::Vector2d& start)
      : is_at_once_(friction && !friction->remembers()), before_(start) {}

  /// \param force  at the end of a step, over full sliding
  void take(const Eigen::Vector2d& force) {
    const Eigen::Vector2d change = force - before_;
    if (is_at_once_ && change.dot(change_) < 0) {
      largest_ = std::max(largest_, std::min(change.norm(), change_.norm()));
    }
    change_ = change;
    before_ = force;
  }

  std::optional<std::string> doubt() const {
    constexpr double most = 0.02;
    if (largest_ <= most) return std::nullopt;
    return fmt::format(
        "forces go back and forth from step to step by {:.2g} of full sliding, as friction falls "
        "with slip at once; a contact.friction_memory that is long enough ends it",
        largest_);
  }

 private:
  bool is_at_once_;
  Eigen::Vector2d before_, change_ = Eigen::Vector2d::Zero();
  double largest_ = 0;
};

}  // namespace microslip::experiments
