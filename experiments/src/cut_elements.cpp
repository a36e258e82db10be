// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/cut_elements.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/require.hpp"

namespace microslip::experiments {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// An edge of the contact this close to an edge of an element counts as the same place, because
/// distances are rounded sums  [dx]
constexpr double rounding = 1e-9;

/// Cut elements narrower than this are left out  [dx]
constexpr double narrowest = 1e-6;

Index size_of(const auto& elements) { return static_cast<Index>(elements.size()); }

}  // namespace

CutElementRolling::CutElementRolling(const CattaneoToCarter& rolling, EdgeElements treatment,
                                     double elements)
    : kernel_(rolling.kernel),
      bound_(rolling.bound),
      force_(rolling.force),
      treatment_(treatment),
      contact_(elements),
      spacing_(2 * rolling.bound.half_width() / elements),
      shape_(constant_shape()),
      between_(VectorXd::NullaryExpr(
          static_cast<Index>(std::ceil(elements)) + 4,
          [&](Index i) { return influence(kernel_, shape_, spacing_, static_cast<double>(i)); })),
      elements_(elements_at(0)) {
  const VectorXd zeros = VectorXd::Zero(size_of(elements_));
  const std::vector<Zone> stuck(elements_.size(), Zone::adhesion);
  state_ =
      solve(elements_, {.bound = bound(elements_, 0), .offset = zeros, .reference = zeros}, stuck);
  state_.rigid_slip = 0;
  previous_first_ = first();
  previous_end_ = end();
  previous_zones_ = state_.zones;
}

CutElementRolling::Elements CutElementRolling::elements_at(double distance) const {
  const double end = distance + contact_;
  Elements elements;
  for (double left = std::floor(distance + rounding); left < end - rounding; ++left) {
    const auto number = static_cast<Index>(left);
    const double first = std::max(left, distance);
    const double last = std::min(left + 1, end);
    const bool cut = treatment_ == EdgeElements::cut && last - first < 1 - rounding;
    if (cut && last - first < narrowest) continue;
    const double node = left + 0.5;
    const bool node_inside = node > distance + rounding && node < end - rounding;
    if (treatment_ == EdgeElements::at_node && !node_inside) continue;
    elements.push_back(cut ? Element{number, (first + last) / 2, last - first}
                           : Element{number, node, 1});
  }
  return elements;
}

VectorXd CutElementRolling::bound(const Elements& elements, double distance) const {
  return VectorXd::NullaryExpr(size_of(elements), [&](Index i) {
    const Element& element = elements[static_cast<std::size_t>(i)];
    const double x = (element.middle - distance - contact_ / 2) * spacing_;
    if (treatment_ == EdgeElements::at_node) return bound_(x);
    const double width = element.width * spacing_;
    return (bound_.integral(x + width / 2) - bound_.integral(x - width / 2)) / width;
  });
}

double CutElementRolling::influence_of(const Element& source, const Element& at) const {
  if (source.whole() && at.whole()) return between_[std::abs(at.number - source.number)];
  return influence(kernel_, shape_, source.width * spacing_,
                   (at.middle - source.middle) / source.width);
}

MatrixXd CutElementRolling::response(const Elements& sources, const Elements& at) const {
  return MatrixXd::NullaryExpr(size_of(at), size_of(sources), [&](Index i, Index j) {
    return influence_of(sources[static_cast<std::size_t>(j)], at[static_cast<std::size_t>(i)]);
  });
}

LinearOperator CutElementRolling::response(const Elements& elements) const {
  if (treatment_ == EdgeElements::cut) return response(elements, elements);
  return influence_operator(kernel_, constant_basis(), spacing_, size_of(elements), Solver{});
}

ContactState CutElementRolling::solve(const Elements& elements, const SlipConditions& conditions,
                                      const std::vector<Zone>& first) const {
  const VectorXd weights = VectorXd::NullaryExpr(size_of(elements), [&](Index i) {
    return elements[static_cast<std::size_t>(i)].width * spacing_;
  });
  return ActiveSet(response(elements), weights).solve(conditions, PrescribedForce{force_}, first);
}

/// Returns the present zones, for the elements of the next step.
std::vector<Zone> CutElementRolling::zones_at(const Elements& next) const {
  std::vector<Zone> zones;
  for (const Element& element : next) {
    const bool known = element.number >= first() && element.number < end();
    const auto i = static_cast<std::size_t>(element.number - first());
    zones.push_back(known ? state_.zones[i] : Zone::adhesion);
  }
  return zones;
}

void CutElementRolling::step(double step_ratio) {
  require(step_ratio > 0 && step_ratio <= 2, "step.ratio", step_ratio, "a number in (0, 2]");
  const double distance = distance_ + step_ratio;
  const Elements next = elements_at(distance);
  const VectorXd u = response(elements_, next) * state_.traction;
  previous_first_ = first();
  previous_end_ = end();
  previous_zones_ = zones_at(next);
  state_ = solve(
      next,
      {.bound = bound(next, distance), .offset = -u, .reference = VectorXd::Zero(size_of(next))},
      previous_zones_);
  state_.rigid_slip /= step_ratio * spacing_;
  elements_ = next;
  distance_ = distance;
}

Index CutElementRolling::entered() const { return end() - previous_end_; }

Index CutElementRolling::left() const { return first() - previous_first_; }

Index CutElementRolling::released() const {
  Index count = 0;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const bool stuck_before =
        elements_[i].number < previous_end_ && previous_zones_[i] == Zone::adhesion;
    count += stuck_before && state_.zones[i] != Zone::adhesion;
  }
  return count;
}

VectorXd CutElementRolling::x() const {
  return VectorXd::NullaryExpr(size_of(elements_), [&](Index i) {
    const double middle = elements_[static_cast<std::size_t>(i)].middle;
    return (middle - distance_ - contact_ / 2) * spacing_;
  });
}

VectorXd CutElementRolling::width() const {
  return VectorXd::NullaryExpr(size_of(elements_), [&](Index i) {
    return elements_[static_cast<std::size_t>(i)].width * spacing_;
  });
}

double CutElementRolling::force() const { return width().dot(state_.traction); }

}  // namespace microslip::experiments
