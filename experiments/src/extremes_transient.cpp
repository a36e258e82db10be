// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "extremes_cases.hpp"
#include "microslip/experiments/cattaneo_to_carter.hpp"
#include "microslip/experiments/contact_tables.hpp"
#include "microslip/reference/carter.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/support/interpolation.hpp"

namespace microslip::experiments::extremes_study {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Sorts the catalogue by order.
std::vector<AdvectionEntry> schemes_by_order() {
  std::vector<AdvectionEntry> all(advection_schemes().begin(), advection_schemes().end());
  std::ranges::stable_sort(all, {}, &AdvectionEntry::order);
  return all;
}

CattaneoToCarter rolling_of(const ExtremesParameters& p, Index elements) {
  const double force_ratio = (1 - p.stick_ratio) * (1 + p.stick_ratio);
  return {.kernel = PlaneKernel(p.material, p.length),
          .bound = p.bound,
          .grid = Grid({.half_width = p.bound.half_width(), .elements = elements}),
          .basis = constant_basis(),
          .force = -force_ratio * p.bound.total()};
}

/// The tractions at any place after a distance; Carter's, once the start has been left far behind.
class TransientTruth {
 public:
  explicit TransientTruth(const ExtremesParameters& p) : p_(p) {}

  VectorXd at(const VectorXd& x, Index elements, double distance) {
    constexpr double contacts = 3;
    constexpr Index refinement = 4;
    const CattaneoToCarter rolling = rolling_of(p_, elements);
    if (distance >= contacts * static_cast<double>(elements)) {
      const Carter carter = Carter::from_force(p_.material, p_.bound, rolling.force);
      return x.unaryExpr([&](double xi) { return carter.traction(xi); });
    }
    const auto [known, is_new] = fine_.try_emplace({elements, distance});
    if (is_new) {
      const TransientRolling fine = rolling.refined(distance, refinement);
      known->second = {fine.x(), fine.state().traction};
    }
    return interpolated(known->second.x, known->second.traction, x);
  }

 private:
  struct Fine {
    VectorXd x;
    VectorXd traction;
  };

  ExtremesParameters p_;
  std::map<std::pair<Index, double>, Fine> fine_;
};

Finding roll(const ExtremesParameters& p, const AdvectionEntry& scheme, Index elements,
             double step_ratio, double distance, TransientTruth& truth) {
  const CattaneoToCarter start = rolling_of(p, elements);
  const double dx = start.grid.spacing();
  const double relaxation = std::max(1.0, step_ratio);  // at least a whole element
  TransientRolling rolling(start.problem(scheme.scheme(relaxation)), CattaneoShift{start.force});
  WorstOfSteps worst;
  rolling.roll(distance * dx, {step_ratio * dx}, PrescribedForce{start.force},
               [&](const TransientState& state) { worst.include(state); });
  const VectorXd x = start.grid.nodes();
  const VectorXd traction = interpolated(rolling.x(), rolling.traction_at_nodes(), x);
  const VectorXd error = traction - truth.at(x, elements, distance);
  return {.error = dx * error.lpNorm<1>() / std::abs(start.force),
          .wiggle = wiggle_of(error) / p.bound.peak(),
          .condition = rolling.condition(),
          .evidence = worst.evidence,
          .iterations = static_cast<double>(worst.iterations)};
}

}  // namespace

Map transient_map(const ExtremesParameters& p) {
  Map map{"transient",
          "a Cattaneo shift that rolls on in steps of any length; error: integral of |p - exact| "
          "over the force",
          {{"step_ratio", "1", "c = dq/dx"},
           {"elements", "1", "N"},
           {"distance", "dx", "rolled; the least that the study allows, or two steps"}},
          {1, static_cast<double>(p.elements), not_given},
          {}};
  const auto truth = std::make_shared<TransientTruth>(p);
  for (const AdvectionEntry& scheme : schemes_by_order()) {
    for (const double c : p.transient_ratios) {
      for (const Index n : p.transient_sizes) {
        const double distance =
            std::max(std::min(p.distance, c * static_cast<double>(p.most_steps)), 2 * c);
        map.cases.push_back({.scheme = std::string(scheme.name),
                             .place = {c, static_cast<double>(n), distance},
                             .size = static_cast<double>(n),
                             .goes_on = n != p.transient_sizes.front(),
                             .solve = [=] { return roll(p, scheme, n, c, distance, *truth); }});
      }
    }
  }
  return map;
}

Map endurance_map(const ExtremesParameters& p) {
  Map map{"endurance",
          "the same over many steps; error: integral of |p - exact| over the force",
          {{"step_ratio", "1", "c = dq/dx"},
           {"steps", "1", "made so far"},
           {"distance", "dx", "rolled"}},
          {1, static_cast<double>(p.states.front()), not_given},
          {}};
  const auto truth = std::make_shared<TransientTruth>(p);
  for (const AdvectionEntry& scheme : schemes_by_order()) {
    for (const double c : p.endurance_ratios) {
      for (const Index steps : p.states) {
        const double distance = c * static_cast<double>(steps);
        const bool costly = scheme.name == "fractional";
        map.cases.push_back(
            {.scheme = std::string(scheme.name),
             .place = {c, static_cast<double>(steps), distance},
             .size = static_cast<double>(steps),
             .goes_on = costly && steps != p.states.front(),
             .solve = [=] { return roll(p, scheme, p.elements, c, distance, *truth); }});
      }
    }
  }
  return map;
}

}  // namespace microslip::experiments::extremes_study
