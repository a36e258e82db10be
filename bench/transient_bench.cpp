// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>

#include "bench.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::bench {

namespace {

using Eigen::Index;

/// A transient scheme tends to the tractions of this method.
SteadyMethod steady_of(const AdvectionScheme& scheme) {
  if (std::holds_alternative<Remembered>(scheme)) return Inversion{};
  return Differences{.step_ratio = 1};
}

Grid grid_of(const BenchParameters& p, Index n) {
  return Grid({.half_width = p.bound.half_width(), .elements = n});
}

TransientProblem problem_of(const BenchParameters& p, const AdvectionScheme& scheme, Index n,
                            Solver::Type type) {
  return {.contact = {p.strip(), p.bound},
          .grid = grid_of(p, n),
          .basis = constant_basis(),
          .scheme = scheme,
          .solver = {.type = type}};
}

/// Rolls on in a steady state, one element a step.
Work steady_steps(const BenchParameters& p, const AdvectionScheme& scheme, Index n,
                  Solver::Type type) {
  const SteadySolution steady = solve_steady({.contact = {p.strip(), p.bound},
                                              .grid = grid_of(p, n),
                                              .method = steady_of(scheme),
                                              .load = p.force,
                                              .solver = {.type = type}});
  auto rolling =
      std::make_shared<TransientRolling>(problem_of(p, scheme, n, type), steady.traction);
  const double length = grid_of(p, n).spacing();
  // Until what is made once is made, and the partition is that of the step before.
  for (int i = 0; i < 4; ++i) rolling->step(length, p.force);
  return [rolling, length, load = p.force] {
    rolling->step(length, load);
    return rolling->state().iterations;
  };
}

/// N steps of one element, that is over the length of the contact, from a shift.
Work from_shift(const BenchParameters& p, const AdvectionScheme& scheme, const Load& load, Index n,
                Solver::Type type) {
  const TransientProblem problem = problem_of(p, scheme, n, type);
  return [problem, load, force = p.force.value] {
    TransientRolling rolling(problem, CattaneoShift{force});
    double partitions = 0;
    rolling.roll(2 * problem.grid.half_width(), {problem.grid.spacing()}, load,
                 [&](const TransientState& state) { partitions += state.iterations; });
    return partitions;
  };
}

}  // namespace

std::vector<Case> transient_cases(const BenchParameters& p) {
  std::vector<Case> cases;
  const auto add = [&](const std::string& quantity, const AdvectionScheme& scheme, Index n,
                       Index most_dense, const auto& prepare) {
    cases.push_back({{quantity, "strip", name_of(scheme) + "_fft", n},
                     [=] { return prepare(scheme, n, Solver::Type::fft); }});
    if (n > most_dense) return;
    cases.push_back({{quantity, "strip", name_of(scheme) + "_dense", n},
                     [=] { return prepare(scheme, n, Solver::Type::dense); }});
  };
  const auto step = [&p](const AdvectionScheme& scheme, Index n, Solver::Type type) {
    return steady_steps(p, scheme, n, type);
  };
  const auto roll_by = [&p](const Load& load) {
    return [&p, load](const AdvectionScheme& scheme, Index n, Solver::Type type) {
      return from_shift(p, scheme, load, n, type);
    };
  };
  for (const char* name : transients) {
    const AdvectionScheme scheme = advection_scheme(name).scheme(1);
    for (const Index n : p.step) add("step", scheme, n, p.dense_step, step);
    for (const Index n : p.rolling) {
      add("rolling_by_force", scheme, n, p.dense_rolling, roll_by(p.force));
      add("rolling_by_creepage", scheme, n, p.dense_rolling, roll_by(p.creepage));
    }
  }
  return cases;
}

}  // namespace microslip::bench
