// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <stdexcept>

#include "microslip/support/not_converged.hpp"
#include "microslip/support/work.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::VectorXd;

HertzBound hertz_like(const PolynomialBound& bound) {
  const double a = bound.half_width();
  return {a, bound.total() / full_sliding_force(HertzBound(a, 1))};
}

Truth truth_of(const Carter& carter) {
  return {carter.creepage(), carter.force(), [carter](double x) { return carter.traction(x); }};
}

Truth truth_of(const ChebyshevRolling& rolling, double half_width, double stick_ratio) {
  const double creepage = rolling.at(half_width * (1 - 2 * stick_ratio)).creepage;
  const auto solution =
      std::make_shared<const ChebyshevSolution>(rolling.solve(PrescribedCreepage{creepage}));
  return {creepage, solution->force(), [=](double x) { return solution->traction(x); }};
}

double wiggle_of(const VectorXd& error) {
  constexpr Index wave = 4;
  const Index n = error.size();
  if (n < wave + 2) return 0;
  VectorXd bend = error.segment(1, n - 2) - (error.head(n - 2) + error.tail(n - 2)) / 2;
  for (Index i = 1; i < bend.size(); i += 2) bend[i] = -bend[i];
  double largest = 0;
  for (Index i = 0; i + wave <= bend.size(); ++i) {
    const auto part = bend.segment(i, wave);
    const double least = part[0] > 0 ? part.minCoeff() : -part.maxCoeff();
    largest = std::max(largest, least / 2);
  }
  return largest;
}

Compared compared(const SteadyProblem& problem, const Truth& truth) {
  SteadySolution solution = solve_steady(problem);
  VectorXd exact = truth.at(solution.x);
  const double sum = (solution.traction - exact).lpNorm<1>();
  const double scale = solution.bound.maxCoeff() * static_cast<double>(exact.size());
  const double force_error = std::abs(solution.force / truth.force - 1);
  return {std::move(solution), std::move(exact), problem.grid.spacing() * sum, sum / scale,
          force_error};
}

Rolled roll(const CattaneoToCarter& start, const AdvectionScheme& scheme, double step_ratio,
            double elements, const Load& load) {
  TransientRolling rolling(start.problem(scheme), CattaneoShift{start.force});
  const double dx = start.grid.spacing();
  std::vector<double> distance{0}, creep{0}, force{start.force};
  Rolled rolled;
  rolling.roll(elements * dx, {step_ratio * dx}, load, [&](const TransientState& state) {
    creep.push_back(creep.back() + std::abs(state.creepage) * (state.distance - distance.back()));
    distance.push_back(state.distance);
    force.push_back(state.force);
    rolled.rounds += state.iterations;
  });
  rolled.x = rolling.x();
  rolled.traction = rolling.traction_at_nodes().cwiseAbs();
  rolled.distance = VectorXd::Map(distance.data(), static_cast<Index>(distance.size()));
  rolled.creep = VectorXd::Map(creep.data(), static_cast<Index>(creep.size()));
  rolled.force = VectorXd::Map(force.data(), static_cast<Index>(force.size()));
  return rolled;
}

Rolled roll(const CattaneoToCarter& start, const AdvectionScheme& scheme, double step_ratio,
            double elements) {
  return roll(start, scheme, step_ratio, elements, PrescribedForce{start.force});
}

namespace {

/// Extrapolates the operations of a run from smaller runs: with the growth between the last two
/// runs, at least as N; from a single run, as N^2.
double expected_work(const std::vector<double>& sizes, const std::vector<double>& work,
                     double elements) {
  if (work.empty()) return 0;
  const std::size_t last = work.size() - 1;
  double power = 2;
  if (last > 0) {
    power = std::log(work[last] / work[last - 1]) / std::log(sizes[last] / sizes[last - 1]);
  }
  return work[last] * std::pow(elements / sizes[last], std::clamp(power, 1.0, 3.0));
}

}  // namespace

std::string name_of(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::refused:
      return "refused";
    case Status::no_solution:
      return "no_solution";
    default:
      return "not_run";
  }
}

Attempt Runs::run(double size, const std::function<void()>& solve) {
  Attempt attempt{.message = "", .expected = expected_work(sizes_, work_, size)};
  if (attempt.expected > limits_.operations) return attempt;
  const WorkCount count;
  attempt.status = Status::ok;
  try {
    measure(solve, attempt);
  } catch (const std::invalid_argument& error) {
    attempt.status = Status::refused;
    attempt.message = error.what();
  } catch (const NotConverged& error) {
    attempt.status = Status::no_solution;
    attempt.message = error.what();
  }
  sizes_.push_back(size);
  work_.push_back(attempt.status == Status::ok ? attempt.work
                                               : count.operations() / limits_.solutions);
  return attempt;
}

/// Measures processor time, so that other processes do not count.
void Runs::measure(const std::function<void()>& solve, Attempt& attempt) const {
  constexpr double long_run = 2;  // [s]; a longer run is not repeated
  double total = 0;
  do {
    const WorkCount count;
    const std::clock_t start = std::clock();
    solve();
    const double time = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    attempt.work = count.operations() / limits_.solutions;
    attempt.time = std::fmin(attempt.time, time / limits_.solutions);
    total += time;
  } while (total < limits_.repeats && total < long_run);
}

}  // namespace microslip::experiments
