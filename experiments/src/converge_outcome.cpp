// SPDX-License-Identifier: GPL-3.0-or-later
#include "converge_outcome.hpp"

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "campaign.hpp"
#include "microslip/experiments/contact_tables.hpp"
#include "microslip/support/interpolation.hpp"
#include "microslip/support/require.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

Outcome outcome_of(const SteadyProblem& problem) {
  const SteadySolution solution = solve_steady(problem);
  if (!solution.fallback.empty()) throw std::invalid_argument(solution.fallback);
  require_evidence(solution.evidence, solution.condition, solution.iterations, problem.accepted);
  const bool under_force = Prescribed(problem.load).by_force;
  return {.distance = VectorXd::Zero(1),
          .answer = VectorXd::Constant(1, under_force ? solution.creepage : solution.force),
          .x = solution.x,
          .traction = solution.traction,
          .lost = solution.dissipation};
}

Outcome outcome_of(const TransientScene& scene) {
  TransientRolling rolling(scene.problem, scene.start, scene.loads.contact_at(0));
  Outcome outcome;
  for (const ShiftLoad& load : scene.shifts) outcome.lost += rolling.shift(load).dissipation;
  const bool under_force = Prescribed(scene.loads.at(0)).by_force;
  std::vector<double> distance{rolling.state().distance};
  std::vector<double> answer{under_force ? 0 : rolling.state().force};
  WorstOfSteps worst;
  using Clock = std::chrono::steady_clock;
  Clock::time_point before = Clock::now();
  rolling.roll_to(scene.distance, scene.step_lengths(), scene.loads, [&](const TransientState& s) {
    const Clock::time_point now = Clock::now();
    const double took = std::chrono::duration<double>(now - before).count();
    if (distance.size() > 1) outcome.longest_step = std::max(outcome.longest_step, took);
    const double length = s.distance - distance.back();
    answer.push_back(under_force ? answer.back() + length * s.creepage : s.force);
    distance.push_back(s.distance);
    outcome.lost += s.dissipation * length;
    worst.include(s);
    before = Clock::now();
  });
  constexpr double no_condition = 1;
  require_evidence(worst.evidence, no_condition, worst.iterations, scene.problem.accepted);
  outcome.distance = VectorXd::Map(distance.data(), static_cast<Index>(distance.size()));
  outcome.answer = VectorXd::Map(answer.data(), outcome.distance.size());
  outcome.x = rolling.x();
  outcome.traction = rolling.traction_at_nodes();
  return outcome;
}

Outcome outcome_of(const SteadyPatch& patch) {
  SteadyPatchSolution solution = solve_steady(patch);
  require_evidence(solution.evidence, solution.condition, solution.iterations, patch.accepted);
  Outcome outcome;
  outcome.distance = VectorXd::Zero(1);
  outcome.lost = solution.dissipation;
  outcome.patch = Outcome::Patch{patch, std::move(solution)};
  return outcome;
}

Outcome outcome_of(const SteadyTarget&) { throw std::logic_error("converge: a target error"); }
Outcome outcome_of(const PatchTarget&) { throw std::logic_error("converge: a target error"); }
Outcome outcome_of(const CylinderScene&) { throw std::logic_error("converge: a cylinder"); }
Outcome outcome_of(const PatchTransient&) {
  throw std::logic_error("converge: steps of an ellipse");
}

}  // namespace

Outcome solved(const Model& model) {
  return std::visit([](const auto& read) { return outcome_of(read); }, model);
}

Errors errors_of(const Outcome& outcome, const Outcome& exact) {
  const double energy = std::abs(outcome.lost / exact.lost - 1);
  if (exact.patch) {
    const double answer =
        change_of(exact.patch->problem, outcome.patch->solution, exact.patch->solution);
    return {answer, not_given, energy};
  }
  const VectorXd answer = interpolated(exact.distance, exact.answer, outcome.distance);
  const VectorXd traction = interpolated(exact.x, exact.traction, outcome.x);
  return {
      (outcome.answer - answer).lpNorm<Eigen::Infinity>() / exact.answer.lpNorm<Eigen::Infinity>(),
      (outcome.traction - traction).lpNorm<1>() / traction.lpNorm<1>(), energy};
}

}  // namespace microslip::experiments
