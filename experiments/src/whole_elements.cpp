// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/whole_elements.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/require.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// An edge of the contact this close to an edge of an element counts as the same place, because
/// distances are rounded sums  [dx]
constexpr double rounding = 1e-9;

/// So many elements are kept behind the contact: the longest step may just have left them, and the
/// previous displacement depends on them.
constexpr Index kept = 2;

/// Shifts values by some elements; new values are `entering`.
template <class Vector, class Value>
void move_on(Vector& values, Index elements, const Value& entering) {
  std::fill(std::shift_left(values.begin(), values.end(), elements), values.end(), entering);
}

}  // namespace

WholeElementRolling::WholeElementRolling(const CattaneoToCarter& rolling, EdgeElements treatment)
    : hertz_(rolling.bound),
      force_(rolling.force),
      treatment_(treatment),
      elements_(rolling.grid.size()),
      spacing_(rolling.grid.spacing()),
      active_set_(
          influence_matrix(rolling.kernel, constant_basis(), spacing_, elements_ + 1 + kept),
          VectorXd::Constant(elements_ + 1 + kept, spacing_)),
      bound_(bound_now()) {
  if (treatment == EdgeElements::cut) throw std::invalid_argument("whole elements are not cut");
  const VectorXd zeros = VectorXd::Zero(bound_.size());
  state_ = active_set_.solve({.bound = bound_, .offset = zeros, .reference = zeros},
                             PrescribedForce{force_});
  state_.creepage = 0;
}

/// Returns the number of the leading element. Element 0 is at the trailing edge where nothing has
/// been rolled.
double WholeElementRolling::leading_element(double distance) const {
  return std::ceil(static_cast<double>(elements_) + distance - rounding) - 1;
}

VectorXd WholeElementRolling::x() const {
  const double leading =
      (leading_element(distance_) + 0.5 - distance_) * spacing_ - hertz_.half_width();
  const Index size = elements_ + 1 + kept;
  return VectorXd::NullaryExpr(
      size, [&](Index i) { return leading - static_cast<double>(size - 1 - i) * spacing_; });
}

VectorXd WholeElementRolling::bound_now() const {
  if (treatment_ == EdgeElements::at_node) {
    // Next to an edge the square root would turn a rounding error of a sum into 1e-8.
    const double edge = hertz_.half_width() - rounding * spacing_;
    return x().unaryExpr([&](double x) { return std::abs(x) < edge ? hertz_(x) : 0; });
  }
  return mean_bound_around(hertz_, x(), spacing_);
}

void WholeElementRolling::step(double step_ratio) {
  require(step_ratio > 0 && step_ratio <= 2, "step.ratio", step_ratio, "a number in (0, 2]");
  const double before = leading_element(distance_);
  distance_ += step_ratio;
  const auto moved = static_cast<Index>(leading_element(distance_) - before);
  bound_ = bound_now();
  move_on(state_.traction, moved, 0.0);
  move_on(state_.zones, moved, Zone::adhesion);
  active_set_.solve(
      {.bound = bound_, .offset = VectorXd::Zero(bound_.size()), .reference = state_.traction},
      PrescribedForce{force_}, state_);
  state_.creepage /= step_ratio * spacing_;
}

}  // namespace microslip::experiments
