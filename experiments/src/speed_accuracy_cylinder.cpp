// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <utility>

#include "microslip/rolling/schemes.hpp"
#include "microslip/support/interpolation.hpp"
#include "speed_accuracy_problems.hpp"

namespace microslip::experiments::speed_accuracy_study {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct Motion {
  VectorXd position;  ///< after each step, and 0
  VectorXd velocity;
  EnergyLedger ledger;
};

Motion let_go(const SpeedAccuracyParameters& p, Index elements, const AdvectionScheme& scheme,
              Integrator integrator, double step_ratio, Solver::Type type) {
  const HertzBound& bound = p.hertz;
  RollingCylinder body({.contact = {PlaneKernel(p.material, p.cylinder_length), bound},
                        .grid = Grid({.half_width = bound.half_width(), .elements = elements}),
                        .basis = constant_basis(),
                        .scheme = scheme,
                        .solver = {.type = type}},
                       p.cylinder, integrator, step_ratio);
  std::vector<double> position{0}, velocity{0};
  while (body.state().position < p.distance) {
    body.step();
    position.push_back(body.state().position);
    velocity.push_back(body.state().velocity);
  }
  return {VectorXd::Map(position.data(), static_cast<Index>(position.size())),
          VectorXd::Map(velocity.data(), static_cast<Index>(velocity.size())), body.ledger()};
}

/// Interpolates velocities over the second half of the way; over the first half they grow as a
/// square root from rest.
VectorXd velocities(const SpeedAccuracyParameters& p, const Motion& motion) {
  constexpr Index places = 21;
  const double end = p.distance;
  return interpolated(motion.position, motion.velocity, VectorXd::LinSpaced(places, end / 2, end));
}

Judgement judge(const SpeedAccuracyParameters& p, const Motion& motion, const Motion& reference) {
  const EnergyLedger& ledger = motion.ledger;
  const VectorXd exact = velocities(p, reference);
  Judgement judgement;
  judgement.errors[Quantity::energy] = std::abs(ledger.total() / ledger.potential);
  judgement.errors[Quantity::motion] = (velocities(p, motion) - exact).norm() / exact.norm();
  judgement.rounds = static_cast<double>(motion.position.size() - 1);
  return judgement;
}

}  // namespace

std::vector<RunSeries> cylinder_contest(const SpeedAccuracyParameters& p) {
  const auto reference = std::make_shared<const Motion>(let_go(
      p, p.cylinder_reference, Remembered{}, Integrator::verlet, 1, Solver::Type::automatic));
  const std::vector<std::pair<std::string, Integrator>> integrators{
      {"verlet", Integrator::verlet},
      {"leapfrog", Integrator::leapfrog},
      {"midpoint", Integrator::midpoint}};
  std::vector<RunSeries> all;
  for (const std::string frame : {"remembered", "direct"}) {
    const AdvectionScheme scheme = advection_scheme(frame).scheme(1);
    for (const auto& [rule, integrator] : integrators) {
      for (const auto type : {Solver::Type::dense, Solver::Type::fft}) {
        for (const double c : p.cylinder_ratios) {
          const Solve solve = [=, by = integrator](Index elements) {
            return [=, motion = let_go(p, elements, scheme, by, c, type)] {
              return judge(p, motion, *reference);
            };
          };
          all.push_back(
              {{"cylinder", fmt::format("{} {}", frame, rule),
                frame == "remembered" ? "calibrated" : "standard", "constant", c, name_of(type)},
               p.sizes,
               p.cylinder_operations,
               1,
               solve});
        }
      }
    }
  }
  return all;
}

}  // namespace microslip::experiments::speed_accuracy_study
