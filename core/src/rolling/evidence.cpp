// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/evidence.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// A violation above this fraction of the accepted limit is doubtful.
constexpr double doubtful = 0.1;

/// Above these limits, an error of the dissipation and an unresolved bound are doubtful.
constexpr double doubtful_dissipation = 0.25;
constexpr double doubtful_resolution = 0.02;
constexpr double doubtful_zones = 0.15;
constexpr double doubtful_change = 0.03;

/// Number of samples in each interval of the contact, and in a slip zone.
constexpr Index samples_of_part = 5;
constexpr Index samples_of_slip = 200;

double ratio(double part, double whole) { return part > 0 ? part / whole : 0; }

}  // namespace

double Evidence::bound_violation() const { return ratio(excess, load); }
double Evidence::slip_violation() const { return ratio(backward, power); }
double Evidence::bound_resolution() const { return ratio(unresolved, load); }
double Evidence::dissipation_error() const { return ratio(std::abs(dissipated - power), power); }
double Evidence::violation() const { return std::max(bound_violation(), slip_violation()); }

Evidence worst_of(const Evidence& a, const Evidence& b) {
  return {.residual = std::max(a.residual, b.residual),
          .excess = std::max(a.excess, b.excess),
          .backward = std::max(a.backward, b.backward),
          .unresolved = std::max(a.unresolved, b.unresolved),
          .dissipated = std::min(a.dissipated, b.dissipated),
          .load = std::max(a.load, b.load),
          .power = std::max(a.power, b.power),
          .full_sliding = std::max(a.full_sliding, b.full_sliding),
          .one_element = std::max(a.one_element, b.one_element),
          .change = std::max(a.change, b.change)};
}

Evidence evidence_by_elements(const ElementValues& values, double force, double creepage) {
  const auto& [lengths, bound, means, traction, slip] = values;
  Evidence evidence{.load = std::abs(force),
                    .power = std::abs(creepage * force),
                    .full_sliding = lengths.dot(means)};
  for (Index i = 0; i < lengths.size(); ++i) {
    const double size = std::abs(traction[i]);
    const double power = lengths[i] * traction[i] * slip[i];
    if (size > bound[i]) evidence.excess += lengths[i] * (size - bound[i]);
    if (slip[i] != 0) evidence.unresolved += lengths[i] * std::abs(bound[i] - means[i]);
    evidence.backward += std::max(0.0, power);
    evidence.dissipated -= power;
  }
  return evidence;
}

Evidence evidence_by_samples(const TractionBound& bound,
                             const std::function<double(double)>& traction,
                             const std::function<double(double)>& slip, double stick_edge,
                             double stick_end, Index parts, double force, double creepage) {
  const double a = half_width_of(bound);
  Evidence evidence{.load = std::abs(force),
                    .power = std::abs(creepage * force),
                    .full_sliding = full_sliding_force(bound)};
  const auto places = [](double from, double to, Index samples) -> VectorXd {
    const double width = (to - from) / static_cast<double>(samples);
    return VectorXd::NullaryExpr(
        samples, [=](Index i) { return from + width * (static_cast<double>(i) + 0.5); });
  };
  const Index samples = samples_of_part * parts;
  for (const double x : places(-a, a, samples)) {
    const double g = std::visit([&](const auto& of) { return of(x); }, bound);
    evidence.excess +=
        std::max(0.0, std::abs(traction(x)) - g) * 2 * a / static_cast<double>(samples);
  }
  for (const auto& [from, to] : {std::pair(-a, stick_edge), std::pair(stick_end, a)}) {
    const double width = (to - from) / samples_of_slip;
    if (width <= 0) continue;
    for (const double x : places(from, to, samples_of_slip)) {
      const double power = width * traction(x) * slip(x);
      evidence.backward += std::max(0.0, power);
      evidence.dissipated -= power;
    }
  }
  return evidence;
}

void validate(const Acceptance& accepted) {
  require(accepted.violation > 0 && accepted.violation <= 1, "violation", accepted.violation,
          "a number in (0, 1]");
  require(accepted.condition >= 1, "condition", accepted.condition, "a number >= 1");
}

void require_evidence(const Evidence& evidence, double condition, int iterations,
                      const Acceptance& accepted) {
  const auto refuse = [&](const std::string& why) {
    throw NotConverged(why, iterations, evidence.violation());
  };
  const auto check = [&](const std::string& name, double value, const std::string& limit,
                         double most) {
    if (value <= most) return;
    refuse(fmt::format("the result's {} is {}: expected at most the {}, {}", name,
                       format_short(value), limit, format_short(most)));
  };
  check("residual", evidence.residual, "tolerance", accepted.residual);
  check("condition", condition, "accepted condition", accepted.condition);
  check("bound_violation", evidence.bound_violation(), "accepted violation", accepted.violation);
  check("slip_violation", evidence.slip_violation(), "accepted violation", accepted.violation);
  if (evidence.load > (1 + accepted.violation) * evidence.full_sliding) {
    refuse(fmt::format(
        "the result's force, {}, is above full sliding, {}: the elements do not resolve the bound; "
        "take more of them, or in a line contact the scheme inversion",
        format_short(evidence.load), format_short(evidence.full_sliding)));
  }
  if (evidence.dissipated < -accepted.violation * evidence.power) {
    refuse(fmt::format("the result's dissipation is negative, {}: take more elements",
                       format_short(evidence.dissipated)));
  }
}

std::optional<std::string> doubt_of(const Evidence& evidence, const Acceptance& accepted,
                                    bool steady) {
  const auto above = [](const std::string& name, double value, const std::string& why) {
    return fmt::format("{} is {}: {}", name, format_roughly(value), why);
  };
  if (evidence.violation() > doubtful * accepted.violation) {
    return above("the violation of the contact conditions", evidence.violation(),
                 "force or creepage may be wrong by as much; take more elements");
  }
  if (evidence.bound_resolution() > doubtful_resolution) {
    return above(
        "bound_resolution", evidence.bound_resolution(),
        "the elements do not resolve the bound; take more of them, or in a line contact the "
        "scheme inversion or remembered");
  }
  if (evidence.one_element > doubtful_zones) {
    return above(
        "the force in zones of stick or slip that are one element long, over the rest to full "
        "sliding,",
        evidence.one_element,
        "the creepage may be wrong by as much; take more elements, or the scheme inversion");
  }
  if (evidence.change > doubtful_change) {
    return above(
        "the change of the result from elements that are twice as long", evidence.change,
        "the elements do not resolve the bound; take more of them, or the scheme inversion");
  }
  if (steady && evidence.dissipated > (1 + doubtful_dissipation) * evidence.power) {
    return above("dissipation_error", evidence.dissipation_error(),
                 "tractions and slip at the nodes lose more energy than the load gives; take more "
                 "elements");
  }
  return std::nullopt;
}

}  // namespace microslip
