// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_problems_steps.hpp"

#include <algorithm>
#include <cmath>

#include "campaign.hpp"
#include "microslip/experiments/profile.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/support/interpolation.hpp"

namespace microslip::experiments::open_problems_study {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Returns the largest step ratio of a scheme: the relaxed scheme has c* = 1.
double largest_ratio(const AdvectionEntry& scheme) {
  return scheme.takes_relaxation ? 1 : HUGE_VAL;
}

/// Returns the largest traction within a fifth of the half-width about a place.
double peak_near(const Rolled& rolled, double x, double half_width) {
  double peak = 0;
  for (Index i = 0; i < rolled.x.size(); ++i) {
    if (std::abs(rolled.x[i] - x) < half_width / 5) peak = std::max(peak, rolled.traction[i]);
  }
  return peak;
}

}  // namespace

StepTables step_tables(const OpenProblemsParameters& p, const Progress& progress) {
  StepTables tables{
      .steps = {"steps",
                "from a Cattaneo shift to Carter's solution, against the step ratio",
                {{"scheme", "1", "step.scheme: direct, relaxed (with c* = 1) or remembered"},
                 {"step_ratio", "1", "c = dq/dx"},
                 {"error", "N/mm", "sum of |p - reference| dx over the nodes"},
                 {"from_unit_step", "N/mm", "sum of |p - p(c = 1)| dx over the nodes", 1e-12},
                 {"peak", "1",
                  "largest |p| of the travelling peak, over the largest of the reference"},
                 {"total_variation", "N/mm^2", "sum of rises and falls of the traction"},
                 {"turning_points", "1", "local extrema above 1e-6 of the peak bound"},
                 {"creep_error", "mm", "|cumulative creep - cumulative creep of the reference|"}}},
      .traction = {"traction",
                   "from a Cattaneo shift to Carter's solution",
                   {{"scheme", "1", "step.scheme, or reference: remembered on a finer grid"},
                    {"step_ratio", "1", "c = dq/dx"},
                    {"x", "mm", "position; the leading edge is at x = +half_width"},
                    {"traction", "N/mm^2", "|p|"}}}};
  const CattaneoToCarter motion{
      .kernel = PlaneKernel(p.material, p.length),
      .bound = hertz_like(p.bound),
      .grid = Grid({.half_width = p.bound.half_width(), .elements = p.motion_elements}),
      .basis = constant_basis(),
      .force = p.force};
  const auto distance = static_cast<double>(p.distance);
  CattaneoToCarter fine = motion;
  fine.grid =
      Grid({.half_width = motion.grid.half_width(), .elements = p.refinement * motion.grid.size()});
  const Rolled reference =
      roll(fine, Remembered{}, 1, distance * static_cast<double>(p.refinement));
  const double dx = motion.grid.spacing();
  const auto add_traction = [&](const char* name, double c, const Rolled& rolled) {
    for (Index i = 0; i < rolled.x.size(); ++i) {
      if (std::abs(rolled.x[i]) > motion.grid.half_width() && rolled.traction[i] == 0) continue;
      tables.traction.add({name, c, rolled.x[i], rolled.traction[i]});
    }
  };
  add_traction("reference", 1, reference);
  Index highest = 0;
  const double peak = reference.traction.maxCoeff(&highest);
  const double peak_at = reference.x[highest];
  std::size_t done = 0;
  const std::vector<const char*> names{"direct", "relaxed", "remembered"};
  for (const char* name : names) {
    const AdvectionEntry& entry = advection_scheme(name);
    const AdvectionScheme scheme = entry.scheme(1);
    const Rolled unit = roll(motion, scheme, 1, distance);
    for (const double c : p.motion_ratios) {
      ++done;
      if (c > largest_ratio(entry)) continue;
      const Rolled rolled = roll(motion, scheme, c, distance);
      add_traction(name, c, rolled);
      const VectorXd exact = interpolated(reference.x, reference.traction, rolled.x);
      const VectorXd same = interpolated(unit.x, unit.traction, rolled.x);
      const double threshold = 1e-6 * motion.bound.peak();
      tables.steps.add({name, c, dx * (rolled.traction - exact).lpNorm<1>(),
                        dx * (rolled.traction - same).lpNorm<1>(),
                        peak_near(rolled, peak_at, motion.grid.half_width()) / peak,
                        total_variation(rolled.traction),
                        turning_points(rolled.traction, threshold),
                        std::abs(rolled.creep.tail(1)[0] - reference.creep.tail(1)[0])});
      progress(done, names.size() * p.motion_ratios.size());
    }
  }
  return tables;
}

}  // namespace microslip::experiments::open_problems_study
