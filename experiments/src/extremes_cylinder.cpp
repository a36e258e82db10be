// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>

#include "extremes_cases.hpp"
#include "microslip/dynamics/cylinder.hpp"
#include "microslip/experiments/contact_tables.hpp"

namespace microslip::experiments::extremes_study {

namespace {

using Eigen::Index;

struct Scheme {
  const char* name;
  AdvectionScheme advection;
  Integrator integrator;
};

const std::array<Scheme, 4> schemes{{{"midpoint", Remembered{}, Integrator::midpoint},
                                     {"verlet", Remembered{}, Integrator::verlet},
                                     {"leapfrog", Remembered{}, Integrator::leapfrog},
                                     {"direct_midpoint", Direct{}, Integrator::midpoint}}};

/// Makes a solid body of the mass 1, ten times as large as the contact. Another mass would only
/// change the unit of time.
RollingCylinder body_on(const ExtremesParameters& p, const Scheme& scheme, Index elements,
                        double slope_ratio, double step_ratio) {
  const double radius = 10 * p.bound.half_width();
  return {{.contact = {PlaneKernel(p.material, p.length), p.bound},
           .grid = Grid({.half_width = p.bound.half_width(), .elements = elements}),
           .basis = constant_basis(),
           .scheme = scheme.advection},
          {.mass = 1,
           .inertia = radius * radius / 2,
           .radius = radius,
           .slope_force = slope_ratio * p.bound.total()},
          scheme.integrator,
          step_ratio};
}

struct Roll {
  double velocity = 0;  ///< after the distance  [mm/s]
  double missed = 0;    ///< error of the balance of energy, over the work of gravity
  WorstOfSteps worst;
};

/// Rolls over three contact widths. The square of the velocity is taken as linear within a step.
Roll roll(const ExtremesParameters& p, RollingCylinder body) {
  const double distance = 6 * p.bound.half_width();
  Roll rolled;
  for (CylinderState before = body.state();; before = body.state()) {
    body.step();
    rolled.worst.include(body.contact().state());
    const CylinderState& state = body.state();
    if (state.position < distance) continue;
    const double part = (distance - before.position) / (state.position - before.position);
    rolled.velocity = std::sqrt(
        std::lerp(before.velocity * before.velocity, state.velocity * state.velocity, part));
    const EnergyLedger energies = body.ledger();
    rolled.missed = std::abs(energies.total() / energies.potential);
    return rolled;
  }
}

/// The velocity, computed with finer elements and steps.
class CylinderTruth {
 public:
  explicit CylinderTruth(const ExtremesParameters& p) : p_(p) {}

  double at(double slope_ratio) {
    constexpr Index refinement = 4;
    constexpr double step_ratio = 0.5;
    const auto [known, is_new] = velocities_.try_emplace(slope_ratio);
    if (is_new) {
      known->second =
          roll(p_, body_on(p_, schemes.front(), refinement * p_.elements, slope_ratio, step_ratio))
              .velocity;
    }
    return known->second;
  }

 private:
  ExtremesParameters p_;
  std::map<double, double> velocities_;
};

Finding finding_of_motion(const ExtremesParameters& p, const Scheme& scheme, double slope_ratio,
                          double step_ratio, CylinderTruth& truth) {
  RollingCylinder body = body_on(p, scheme, p.elements, slope_ratio, step_ratio);
  const Roll rolled = roll(p, body);
  return {.error = std::max(std::abs(rolled.velocity / truth.at(slope_ratio) - 1), rolled.missed),
          .evidence = rolled.worst.evidence,
          .iterations = static_cast<double>(rolled.worst.iterations)};
}

}  // namespace

Map cylinder_map(const ExtremesParameters& p) {
  Map map{"cylinder",
          "a cylinder that starts from rest on a slope, after three contact widths; error: the "
          "larger of two, of its velocity, and of the balance of energy over the work of gravity",
          {{"slope_ratio", "1", "slope force over full sliding; from 3 on a solid body slides"},
           {"step_ratio", "1", "c = v dt/dx, at most"}},
          {0.1, 1},
          {}};
  const auto truth = std::make_shared<CylinderTruth>(p);
  for (const Scheme& scheme : schemes) {
    for (const double slope_ratio : p.slope_ratios) {
      for (const double c : p.cylinder_ratios) {
        map.cases.push_back(
            {.scheme = scheme.name,
             .place = {slope_ratio, c},
             .size = static_cast<double>(p.elements) / c,
             .solve = [=] { return finding_of_motion(p, scheme, slope_ratio, c, *truth); }});
      }
    }
  }
  return map;
}

}  // namespace microslip::experiments::extremes_study
