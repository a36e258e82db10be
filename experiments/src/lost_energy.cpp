// SPDX-License-Identifier: GPL-3.0-or-later
#include "lost_energy.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "microslip/support/format.hpp"

namespace microslip::experiments {

void LostEnergy::add(const Step& step) {
  (step.rate < 0 ? gained_ : lost_) += std::abs(step.rate) * step.length;
  most_ = std::max(most_, step.rate);
  least_ = std::min(least_, step.rate);
  power_ = std::max(power_, step.power);
  sudden_ += std::abs(step.sudden_rate - step.rate) * step.length;
}

void LostEnergy::add(const TransientState& state, double length, double force_before,
                     double full_sliding) {
  constexpr double much = 0.05;  // of full sliding
  const bool is_sudden = std::abs(state.force - force_before) > much * full_sliding;
  add({.length = length,
       .rate = state.dissipation,
       .power = std::abs(state.mean_force * state.creepage),
       .sudden_rate = is_sudden ? state.end_dissipation : state.dissipation});
}

std::optional<std::string> LostEnergy::doubt() const {
  constexpr double doubtful = 0.05;
  constexpr double rounding = 1e-9;
  if (sudden_ > doubtful * lost_) {
    return fmt::format(
        "the dissipated energy is uncertain by {} {}, because the force changes by more than 0.05 "
        "of full sliding in single steps; change it in more of them, or by a shift at the start",
        format_roughly(sudden_ + gained_), energy_unit_);
  }
  if (-least_ <= rounding * power_) return std::nullopt;
  if (gained_ > doubtful * lost_) {
    return fmt::format(
        "the dissipated energy is uncertain by {} {}: negative dissipations of single steps have "
        "this sum, because the elements do not resolve the loss; take more of them",
        format_roughly(gained_), energy_unit_);
  }
  if (-least_ <= doubtful * most_) return std::nullopt;
  return fmt::format(
      "the dissipation of single steps is uncertain by {} {}, as it is negative by so much in one "
      "of them; the sum of the negative ones is {} of the dissipated energy",
      format_roughly(-least_), rate_unit_, format_roughly(gained_ / lost_));
}

}  // namespace microslip::experiments
