// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>

#include "campaign.hpp"
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

Rolled roll_a_part(const SpeedAccuracyParameters& p, Index elements, const AdvectionScheme& scheme,
                   const Basis& basis, double step_ratio, Solver::Type type) {
  const auto& motion = p.transient;
  return roll({.kernel = PlaneKernel(p.material, p.length),
               .bound = motion.bound,
               .grid = Grid({.half_width = motion.bound.half_width(), .elements = elements}),
               .basis = basis,
               .force = motion.force,
               .solver = {.type = type}},
              scheme, step_ratio, static_cast<double>(elements / parts));
}

/// Returns the place of the peak, which starts at the leading end of the stick zone, k = (1 -
/// F)^1/2 of the half-width from the centre.
double peak_place(const SpeedAccuracyParameters& p) {
  const double a = p.transient.bound.half_width();
  const double part = p.transient.force / full_sliding_force(p.transient.bound);
  return a * (std::sqrt(1 - part) - 2.0 / parts);
}

Judgement judge(const SpeedAccuracyParameters& p, const Rolled& rolled, const Rolled& reference) {
  const VectorXd exact = interpolated(reference.x, reference.traction, rolled.x);
  const VectorXd difference = (rolled.traction - exact).cwiseAbs();
  const VectorXd creep = interpolated(reference.distance, reference.creep, rolled.distance);
  const double spacing = rolled.x[1] - rolled.x[0];
  double height = 0, exact_height = 0;
  for (Index i = 0; i < rolled.x.size(); ++i) {
    if (std::abs(rolled.x[i] - peak_place(p)) > p.transient.bound.half_width() / 5) continue;
    height = std::max(height, rolled.traction[i]);
    exact_height = std::max(exact_height, exact[i]);
  }
  Judgement judgement{.errors = {}, .rounds = rolled.rounds};
  judgement.errors[Quantity::creep] = (rolled.creep - creep).norm() /
                                      std::sqrt(static_cast<double>(creep.size() - 1)) /
                                      reference.creep.tail(1)[0];
  judgement.errors[Quantity::traction] = spacing * difference.sum() / p.transient.force;
  judgement.errors[Quantity::peak] = std::abs(height / exact_height - 1);
  return judgement;
}

}  // namespace

std::vector<RunSeries> transient_contest(const SpeedAccuracyParameters& p) {
  const auto reference = std::make_shared<const Rolled>(roll_a_part(
      p, p.transient.reference, Remembered{}, constant_basis(), 1, Solver::Type::automatic));
  std::vector<RunSeries> all;
  for (const AdvectionEntry& entry : advection_schemes()) {
    const AdvectionScheme scheme = entry.scheme(1);
    const char* edge = std::holds_alternative<Remembered>(scheme) ? "calibrated" : "standard";
    for (const auto type : {Solver::Type::dense, Solver::Type::fft}) {
      for (const std::string_view name : basis_names()) {
        const Basis basis = make_basis(name);
        for (const double c : p.transient.step_ratios) {
          const Solve solve = [=](Index elements) {
            return [=, rolled = roll_a_part(p, elements, scheme, basis, c, type)] {
              return judge(p, rolled, *reference);
            };
          };
          all.push_back(
              {{"transient", std::string(entry.name), edge, basis.name(), c, name_of(type)},
               p.sizes,
               p.transient.limit,
               1,
               solve});
        }
      }
    }
  }
  return all;
}

}  // namespace microslip::experiments::speed_accuracy_study
