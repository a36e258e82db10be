// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/friction_law.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/support/format.hpp"
#include "microslip/support/interpolation.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

FrictionLaw::FrictionLaw(Form form, double kinetic, double half)
    : form_(form), kinetic_(kinetic), half_(half) {
  require(kinetic >= 0 && kinetic <= 1, "kinetic_ratio", kinetic, "a number in [0, 1]");
  require_positive("half_speed", half);
}

FrictionLaw::FrictionLaw(const VectorXd& speeds, const VectorXd& ratios)
    : form_(Form::table), kinetic_(0), half_(0), speeds_(speeds), ratios_(ratios) {
  const auto rows = static_cast<double>(speeds.size());
  require(speeds.size() >= 2 && ratios.size() == speeds.size(), "rows", rows,
          "at least 2, each with a speed and a ratio");
  require(speeds[0] == 0, "row 1: speed", speeds[0], "0, where the bodies stick");
  require(ratios[0] == 1, "row 1: ratio", ratios[0], "1, friction where the bodies stick");
  for (Index i = 1; i < speeds.size(); ++i) {
    require(speeds[i] > speeds[i - 1], fmt::format("row {}: speed", i + 1), speeds[i],
            [&] { return fmt::format("more than {}, that before", format_short(speeds[i - 1])); });
    require(ratios[i] >= 0 && ratios[i] <= 1, fmt::format("row {}: ratio", i + 1), ratios[i],
            "a number in [0, 1]");
  }
  kinetic_ = ratios[ratios.size() - 1];
}

double FrictionLaw::operator()(double speed) const {
  const double fall = 1 - kinetic_;
  switch (form_) {
    case Form::linear:
      return kinetic_ + fall * std::max(0.0, 1 - speed / (2 * half_));
    case Form::exponential:
      return kinetic_ + fall * std::exp2(-speed / half_);
    case Form::rational:
      return kinetic_ + fall / (1 + speed / half_);
    default:
      break;
  }
  return interpolated(speeds_, ratios_, speed);
}

double FrictionLaw::steepest() const {
  const double fall = 1 - kinetic_;
  switch (form_) {
    case Form::linear:
      return fall / (2 * half_);
    case Form::exponential:
      return fall * std::numbers::ln2 / half_;
    case Form::rational:
      return fall / half_;
    default:
      break;
  }
  double steepest = 0;
  for (Index i = 1; i < speeds_.size(); ++i) {
    const double slope = (ratios_[i - 1] - ratios_[i]) / (speeds_[i] - speeds_[i - 1]);
    steepest = std::max(steepest, slope);
  }
  return steepest;
}

double SlipFriction::ratio_after(double before, double distance, double time) const {
  const double target = law(distance / time);
  if (!remembers()) return target;
  const double way = std::max(distance, memory_speed * time);
  return target + (before - target) * std::exp(-way / memory_length);
}

double SlipFriction::ratio_after(double before, double from, double to, double time) const {
  const double ways = std::max((from + to) / 2, memory_speed) * time / memory_length;
  const double at_first = law(from), at_last = law(to);
  const double mean = ways > 0 ? -std::expm1(-ways) / ways : 1;
  return at_last + (before - at_first) * std::exp(-ways) - (at_last - at_first) * mean;
}

void validate(const SlipFriction& friction) {
  require_positive("speed", friction.speed);
  require(friction.memory_length >= 0, "friction_memory", friction.memory_length, "a number >= 0");
  require(friction.memory_speed >= 0, "memory_speed", friction.memory_speed, "a number >= 0");
}

}  // namespace microslip
