// SPDX-License-Identifier: GPL-3.0-or-later
#include "converge_outcome.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "campaign.hpp"
#include "microslip/experiments/contact_tables.hpp"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/support/interpolation.hpp"
#include "microslip/support/require.hpp"
#include "rolled_patch.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::Vector3d;
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

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point before) {
  return std::chrono::duration<double>(Clock::now() - before).count();
}

Outcome outcome_of(const TransientScene& scene) {
  TransientRolling rolling(scene.problem, scene.start, scene.loads.contact_at(0));
  Outcome outcome;
  for (const ShiftLoad& load : scene.shifts) outcome.lost += rolling.shift(load).dissipation;
  const bool under_force = Prescribed(scene.loads.at(0)).by_force;
  std::vector<double> distance{rolling.state().distance};
  std::vector<double> answer{under_force ? 0 : rolling.state().force};
  WorstOfSteps worst;
  Clock::time_point before = Clock::now();
  rolling.roll_to(scene.distance, scene.step_lengths(), scene.loads, [&](const TransientState& s) {
    const double took = seconds_since(before);
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

Outcome outcome_of(const PatchTransient& scene) {
  const PatchHistory& loads = scene.loads;
  const PatchBound& bound = scene.patch.bound;
  RolledPatch rolled(scene.patch, scene.scheme, loads.contact_at(0));
  Outcome outcome;
  Outcome::PatchSteps steps{bound.size(), {}, {}};
  Vector3d way = Vector3d::Zero();
  WorstOfPatch worst;
  const auto include = [&](const PatchStepEnd& end, double length) {
    way += length * end.motion;
    steps.resultants.emplace_back(
        end.resultants.cwiseQuotient(largest_resultants(bound, end.contact)));
    steps.ways.push_back(way);
    outcome.lost += length * end.dissipation;
    worst.include(end);
  };
  for (const PatchLoad& load : scene.shifts) include(rolled.shift(load), 1);
  if (scene.start) rolled.start_from(*scene.start);
  std::vector<double> distance{scene.from};
  for_steps(scene.distance, scene.step_lengths(), scene.from,
            [&](double from, double to, double length) {
              const Clock::time_point before = Clock::now();
              const PatchStepEnd end = rolled.roll(loads, from, to, length);
              if (distance.size() > 1) {
                outcome.longest_step = std::max(outcome.longest_step, seconds_since(before));
              }
              include(end, length);
              distance.push_back(to);
            });
  require_evidence(worst.evidence, rolled.condition().value_or(1), worst.iterations,
                   scene.patch.accepted);
  outcome.distance = VectorXd::Map(distance.data(), static_cast<Index>(distance.size()));
  outcome.patch_steps = std::move(steps);
  return outcome;
}

Outcome outcome_of(const SteadyTarget&) { throw std::logic_error("converge: a target error"); }
Outcome outcome_of(const PatchTarget&) { throw std::logic_error("converge: a target error"); }
Outcome outcome_of(const CylinderScene&) { throw std::logic_error("converge: a cylinder"); }

/// Both have the same steps.
double error_of(const Outcome::PatchSteps& steps, const Outcome::PatchSteps& exact) {
  if (steps.ways.size() != exact.ways.size()) {
    throw std::logic_error("converge: other steps of an ellipse");
  }
  double of_resultants = 0;
  MotionChange of_ways{exact.size};
  for (std::size_t i = 0; i < exact.ways.size(); ++i) {
    of_resultants = std::max(of_resultants,
                             (steps.resultants[i] - exact.resultants[i]).lpNorm<Eigen::Infinity>());
    of_ways.include(steps.ways[i], exact.ways[i]);
  }
  return std::max(of_resultants, of_ways.relative());
}

}  // namespace

bool Outcome::has_answer() const {
  if (patch) return !patch->solution.resultants.isZero(0);
  if (!patch_steps) return !answer.isZero(0);
  return std::ranges::any_of(patch_steps->resultants,
                             [](const Vector3d& one) { return !one.isZero(0); });
}

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
  if (exact.patch_steps) {
    return {error_of(*outcome.patch_steps, *exact.patch_steps), not_given, energy};
  }
  const VectorXd answer = interpolated(exact.distance, exact.answer, outcome.distance);
  const VectorXd traction = interpolated(exact.x, exact.traction, outcome.x);
  return {
      (outcome.answer - answer).lpNorm<Eigen::Infinity>() / exact.answer.lpNorm<Eigen::Infinity>(),
      (outcome.traction - traction).lpNorm<1>() / traction.lpNorm<1>(), energy};
}

}  // namespace microslip::experiments
