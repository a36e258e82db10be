// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "microslip/rolling/transient.hpp"
#include "microslip/support/interpolation.hpp"
#include "speed_accuracy_problems.hpp"

namespace microslip::experiments {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Part of the contact's length that is rolled; sizes are its multiples.
constexpr Index parts = 3;

struct Rolled {
  VectorXd x;
  VectorXd traction;  ///< absolute values
  VectorXd distance;  ///< after each step, and 0
  VectorXd creep;     ///< integral of |w| until there  [mm]
  double rounds = 0;
};

Rolled roll(const SpeedAccuracyParameters& p, Index elements, const AdvectionScheme& scheme,
            const Basis& basis, double step_ratio, Solver::Type type) {
  const auto& motion = p.transient;
  const Grid grid({.half_width = motion.bound.half_width(), .elements = elements});
  TransientRolling rolling({.kernel = PlaneKernel(p.material, p.length),
                            .bound = motion.bound,
                            .grid = grid,
                            .basis = basis,
                            .scheme = scheme,
                            .solver = {.type = type}},
                           CattaneoShift{motion.force});
  std::vector<double> distance{0}, creep{0};
  Rolled rolled;
  const double whole = static_cast<double>(elements / parts) * grid.spacing();
  rolling.roll(whole, {step_ratio * grid.spacing()}, PrescribedForce{motion.force},
               [&](const TransientState& state) {
                 creep.push_back(creep.back() +
                                 std::abs(state.creepage) * (state.distance - distance.back()));
                 distance.push_back(state.distance);
                 rolled.rounds += state.iterations;
               });
  rolled.x = rolling.x();
  rolled.traction = rolling.traction_at_nodes().cwiseAbs();
  rolled.distance = VectorXd::Map(distance.data(), static_cast<Index>(distance.size()));
  rolled.creep = VectorXd::Map(creep.data(), static_cast<Index>(creep.size()));
  return rolled;
}

/// The peak starts at the stick zone's leading end, k = (1 - F)^1/2 of the half-width.
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

struct Named {
  const char* name;
  AdvectionScheme scheme;
};

std::vector<Named> schemes() {
  return {{"material", MaterialFixed{}},
          {"direct", Direct{}},
          {"relaxed", Relaxed{1}},
          {"relaxed_traction", RelaxedTraction{1}},
          {"fractional", Fractional{}}};
}

}  // namespace

std::vector<RunSeries> transient_contest(const SpeedAccuracyParameters& p) {
  const auto reference = std::make_shared<const Rolled>(roll(
      p, p.transient.reference, MaterialFixed{}, constant_basis(), 1, Solver::Type::automatic));
  std::vector<RunSeries> all;
  for (const auto& [name, scheme] : schemes()) {
    for (const auto type : {Solver::Type::dense, Solver::Type::fft}) {
      for (const char* basis : {"constant", "linear", "quadratic"}) {
        for (const double c : p.transient.step_ratios) {
          const Solve solve = [=, advection = scheme, shapes = make_basis(basis)](Index elements) {
            return [=, rolled = roll(p, elements, advection, shapes, c, type)] {
              return judge(p, rolled, *reference);
            };
          };
          const bool material = std::holds_alternative<MaterialFixed>(scheme);
          all.push_back(
              {{"transient", name, material ? "calibrated" : "standard", basis, c, name_of(type)},
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

}  // namespace microslip::experiments
