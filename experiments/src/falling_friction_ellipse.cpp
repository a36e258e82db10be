// SPDX-License-Identifier: GPL-3.0-or-later
#include "falling_friction_ellipse.hpp"

#include <algorithm>

#include "microslip/experiments/rule.hpp"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip::experiments::falling_friction_study {

namespace {

/// A run from steady tractions, with friction at rest at first. Its second half counts.
struct EllipseRun {
  double least = 2, most = 0, sum = 0;
  int steps = 0, counted = 0, doubled = 0;
  bool settles = true;

  EllipseRun(const SteadyPatch& patch, const SteadyPatchSolution& from, double step,
             double distance) {
    PatchRolling rolling(patch);
    rolling.start_from(from.traction);
    const double full = patch.bound.total();
    try {
      while (rolling.distance() < distance - step / 2) {
        rolling.roll(step, patch.load);
        ++steps;
        doubled += rolling.has_second() ? 1 : 0;
        if (2 * rolling.distance() < distance) continue;
        const double now = rolling.resultants().head<2>().norm() / full;
        least = std::min(least, now);
        most = std::max(most, now);
        sum += now;
        ++counted;
      }
    } catch (const NotConverged&) {  // a row tells it
      settles = false;
    }
  }
};

}  // namespace

void add_ellipse(const FallingFrictionParameters& p, const FrictionOfMemory& friction,
                 const std::function<void()>& count, Table& table) {
  SteadyPatch patch{.material = {p.shear_modulus, p.poisson_ratio},
                    .bound = EllipticBound(p.half_width, p.lateral_half_width, p.peak_traction),
                    .rows = p.ellipse_rows,
                    .elements = p.ellipse_elements,
                    .load = {{{.by_resultant = false, .value = p.creepage}, {}, {}}}};
  for (const double memory : p.ellipse_memories) {
    patch.friction = friction(memory);
    const SteadyPatchSolution steady = solve_steady(patch);
    for (const double c : p.step_ratios) {
      const double dx = 2 * p.half_width / static_cast<double>(p.ellipse_elements);
      const EllipseRun run(patch, steady, c * dx, p.ellipse_distance);
      table.add({memory, c, run.settles ? 1.0 : 0.0, steady.force() / patch.bound.total(),
                 run.settles ? run.sum / run.counted : not_given,
                 run.settles ? run.most - run.least : not_given,
                 static_cast<double>(run.doubled) / std::max(run.steps, 1)});
      count();
    }
  }
}

}  // namespace microslip::experiments::falling_friction_study
