// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/advection.hpp"

#include <utility>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// c*, where there is one.
std::optional<double> relaxation_of(const AdvectionScheme& scheme) {
  if (const auto* relaxed = std::get_if<Relaxed>(&scheme)) return relaxed->step_ratio;
  if (const auto* relaxed = std::get_if<RelaxedTraction>(&scheme)) return relaxed->step_ratio;
  return std::nullopt;
}

}  // namespace

Advection::Advection(Kernel kernel, Basis basis, double spacing, Index elements,
                     AdvectionScheme scheme, const Solver& solver)
    : kernel_(std::move(kernel)),
      basis_(std::move(basis)),
      spacing_(spacing),
      elements_(elements),
      scheme_(scheme),
      solver_(solver) {
  const double relaxation = relaxation_of(scheme).value_or(1);
  require_step_ratio(relaxation, "relaxation");
  if (!std::holds_alternative<Fractional>(scheme)) return;
  if (basis_.shapes().size() != 1) {
    reject("basis", basis_.name(), "equal functions at all nodes for fractional powers");
  }
  if (!kernel_.spreads()) {
    reject("scheme", "fractional",
           "another scheme with kernel winkler, which knows nothing of the material between nodes");
  }
  shift_.emplace(kernel_, basis_.shapes().front(), spacing, elements);
}

double Advection::fraction(double step_ratio) const {
  return step_ratio / solved_step_ratio(step_ratio);
}

double Advection::solved_step_ratio(double step_ratio) const {
  const auto* relaxed = std::get_if<RelaxedTraction>(&scheme_);
  return relaxed == nullptr ? step_ratio : relaxed->step_ratio;
}

void Advection::advect_directly(const VectorXd& previous, double step_ratio, double part,
                                SlipConditions& conditions) {
  if (step_ratio != difference_step_ratio_) {
    difference_ =
        influence_difference_operator(kernel_, basis_, spacing_, elements_, step_ratio, solver_);
    difference_step_ratio_ = step_ratio;
  }
  difference_->apply(previous, conditions.offset);
  conditions.offset *= part;
  conditions.reference = previous;
}

void Advection::advect(const VectorXd& previous, double step_ratio, SlipConditions& conditions) {
  require_step_ratio(step_ratio);
  if (shift_) {
    conditions.offset.setZero(elements_);
    conditions.reference = shift_->move(previous, step_ratio).traction;
    return;
  }
  const auto relaxation = relaxation_of(scheme_);
  if (!relaxation) return advect_directly(previous, step_ratio, 1, conditions);
  require(is_within_relaxation(step_ratio, *relaxation), "step_ratio", step_ratio,
          [&] { return "at most the relaxation, " + format_short(*relaxation); });
  const bool of_tractions = std::holds_alternative<RelaxedTraction>(scheme_);
  advect_directly(previous, *relaxation, of_tractions ? 1 : step_ratio / *relaxation, conditions);
}

}  // namespace microslip
