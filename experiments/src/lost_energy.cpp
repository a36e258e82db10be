// SPDX-License-Identifier: GPL-3.0-or-later
#include "lost_energy.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "microslip/support/format.hpp"

namespace microslip::experiments {

void LostEnergy::add(const TransientState& state) {
  constexpr double much = 0.05;  // of full sliding
  const double length = state.distance - distance_;
  const double rate = state.dissipation;
  (rate < 0 ? gained_ : lost_) += std::abs(rate) * length;
  most_ = std::max(most_, rate);
  least_ = std::min(least_, rate);
  power_ = std::max(power_, std::abs(state.mean_force * state.creepage));
  if (std::abs(state.force - force_) > much * full_sliding_) {
    sudden_ += std::abs(state.end_dissipation - rate) * length;
  }
  distance_ = state.distance;
  force_ = state.force;
}

std::optional<std::string> LostEnergy::doubt() const {
  constexpr double doubtful = 0.05;
  constexpr double rounding = 1e-9;
  if (sudden_ > doubtful * lost_) {
    return fmt::format(
        "the dissipated energy is uncertain by {} N, because the force changes by more than 0.05 "
        "of "
        "full sliding in single steps; change it in more of them, or by a shift at the start",
        format_roughly(sudden_ + gained_));
  }
  if (-least_ <= rounding * power_) return std::nullopt;
  if (gained_ > doubtful * lost_) {
    return fmt::format(
        "the dissipated energy is uncertain by {} N: negative dissipations of single steps have "
        "this "
        "sum, because the elements do not resolve the loss; take more of them",
        format_roughly(gained_));
  }
  if (-least_ <= doubtful * most_) return std::nullopt;
  return fmt::format(
      "the dissipation of single steps is uncertain by {} N/mm, as it is negative by so much in "
      "one "
      "of them; the sum of the negative ones is {} of the dissipated energy",
      format_roughly(-least_), format_roughly(gained_ / lost_));
}

}  // namespace microslip::experiments
