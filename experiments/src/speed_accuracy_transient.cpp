// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "campaign.hpp"
#include "microslip/reference/carter.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/support/interpolation.hpp"
#include "speed_accuracy_problems.hpp"

namespace microslip::experiments::speed_accuracy_study {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The distance rolled is the contact's length over this. Numbers of elements are multiples of
/// this.
constexpr Index parts = 3;

/// A transient scheme with its basis, step ratio and solver.
struct TransientEntrant {
  AdvectionScheme scheme;
  Basis basis;
  double step_ratio;
  Solver::Type type;
};

/// The reference, which is remembered with c = 1.
TransientEntrant finest() { return {Remembered{}, constant_basis(), 1, Solver::Type::automatic}; }

CattaneoToCarter start_of(const SpeedAccuracyParameters& p, Index elements,
                          const TransientEntrant& by) {
  return {.kernel = PlaneKernel(p.material, p.length),
          .bound = p.hertz,
          .grid = Grid({.half_width = p.hertz.half_width(), .elements = elements}),
          .basis = by.basis,
          .force = p.force,
          .solver = {.type = by.type}};
}

/// Rolls from the shift on under its force.
Rolled under_force(const SpeedAccuracyParameters& p, Index elements, const TransientEntrant& by) {
  return roll(start_of(p, elements, by), by.scheme, by.step_ratio,
              static_cast<double>(elements / parts));
}

/// Rolls likewise under the creepage with which Carter's solution has the same force.
Rolled under_creepage(const SpeedAccuracyParameters& p, Index elements,
                      const TransientEntrant& by) {
  const Carter carter = Carter::from_force(p.material, p.hertz, p.force);
  return roll(start_of(p, elements, by), by.scheme, by.step_ratio,
              static_cast<double>(elements / parts), PrescribedCreepage{carter.creepage()});
}

/// Returns the place of the peak, which starts at the leading end of the stick zone, k = (1 -
/// F)^1/2 of the half-width from the centre.
double peak_place(const SpeedAccuracyParameters& p) {
  const double a = p.hertz.half_width();
  const double part = p.force / full_sliding_force(p.hertz);
  return a * (std::sqrt(1 - part) - 2.0 / parts);
}

/// Returns the mean creepage of each step of the second half of the way.
/// \param creep  at the distances
VectorXd late_creepages(const VectorXd& distance, const VectorXd& creep) {
  const Index steps = distance.size() / 2;
  const auto rise = [&](const VectorXd& of) -> VectorXd {
    return of.tail(steps) - of.segment(of.size() - steps - 1, steps);
  };
  return rise(creep).cwiseQuotient(rise(distance));
}

/// Returns the deviation of the errors of the late creepages from their mean, over the mean
/// creepage: a constant error is no noise.
double noise_of(const Rolled& rolled, const VectorXd& exact_creep) {
  const VectorXd exact = late_creepages(rolled.distance, exact_creep);
  const VectorXd error = late_creepages(rolled.distance, rolled.creep) - exact;
  const VectorXd noise = error.array() - error.mean();
  return noise.norm() / std::sqrt(static_cast<double>(noise.size())) / exact.mean();
}

Judgement judge_under_force(const SpeedAccuracyParameters& p, const Rolled& rolled,
                            const Rolled& reference) {
  const VectorXd exact = interpolated(reference.x, reference.traction, rolled.x);
  const VectorXd difference = (rolled.traction - exact).cwiseAbs();
  const VectorXd creep = interpolated(reference.distance, reference.creep, rolled.distance);
  const double spacing = rolled.x[1] - rolled.x[0];
  double height = 0, exact_height = 0;
  for (Index i = 0; i < rolled.x.size(); ++i) {
    if (std::abs(rolled.x[i] - peak_place(p)) > p.hertz.half_width() / 5) continue;
    height = std::max(height, rolled.traction[i]);
    exact_height = std::max(exact_height, exact[i]);
  }
  Judgement judgement{.errors = {}, .rounds = rolled.rounds};
  judgement.errors[Quantity::creep] = (rolled.creep - creep).norm() /
                                      std::sqrt(static_cast<double>(creep.size() - 1)) /
                                      reference.creep.tail(1)[0];
  judgement.errors[Quantity::noise] = noise_of(rolled, creep);
  judgement.errors[Quantity::traction] = spacing * difference.sum() / p.force;
  judgement.errors[Quantity::peak] = std::abs(height / exact_height - 1);
  return judgement;
}

Judgement judge_under_creepage(const SpeedAccuracyParameters&, const Rolled& rolled,
                               const Rolled& reference) {
  const VectorXd exact = interpolated(reference.distance, reference.force, rolled.distance);
  Judgement judgement{.errors = {}, .rounds = rolled.rounds};
  judgement.errors[Quantity::force] = (rolled.force - exact).norm() /
                                      std::sqrt(static_cast<double>(exact.size() - 1)) /
                                      std::abs(reference.force[0]);
  return judgement;
}

/// Lists the runs of all schemes, bases, step ratios and solvers.
/// \param run    rolls with so many elements by an entrant
/// \param judge  compares with the reference
template <class Run, class Judge>
std::vector<RunSeries> all_entrants(const SpeedAccuracyParameters& p, const std::string& problem,
                                    Run run, Judge judge) {
  const auto reference = std::make_shared<const Rolled>(run(p, p.transient_reference, finest()));
  std::vector<RunSeries> all;
  for (const AdvectionEntry& entry : advection_schemes()) {
    const AdvectionScheme scheme = entry.scheme(1);
    const char* edge = std::holds_alternative<Remembered>(scheme) ? "calibrated" : "standard";
    for (const auto type : {Solver::Type::dense, Solver::Type::fft}) {
      for (const std::string_view name : basis_names()) {
        const Basis basis = make_basis(name);
        for (const double c : p.transient_ratios) {
          const Solve solve = [=](Index elements) {
            const Rolled rolled = run(p, elements, TransientEntrant{scheme, basis, c, type});
            return [=] { return judge(p, rolled, *reference); };
          };
          all.push_back({{problem, std::string(entry.name), edge, basis.name(), c, name_of(type)},
                         p.sizes,
                         p.transient_operations,
                         1,
                         solve});
        }
      }
    }
  }
  return all;
}

}  // namespace

std::vector<RunSeries> transient_contest(const SpeedAccuracyParameters& p) {
  return all_entrants(p, "transient", under_force, judge_under_force);
}

std::vector<RunSeries> creepage_contest(const SpeedAccuracyParameters& p) {
  return all_entrants(p, "creepage", under_creepage, judge_under_creepage);
}

}  // namespace microslip::experiments::speed_accuracy_study
