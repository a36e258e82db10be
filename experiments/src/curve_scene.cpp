// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/curve_scene.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "curve_points.hpp"
#include "microslip/experiments/contact_tables.hpp"
#include "microslip/reference/fastsim.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/sweep.hpp"
#include "microslip/scene/unloaded.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged_at.hpp"
#include "microslip/support/require.hpp"
#include "study_keys.hpp"

namespace microslip::experiments {

namespace {

constexpr const char* creepages_key = "curve.creepages";

/// Returns the contact of a transient problem as a problem of steady rolling.
SteadyProblem contact_of(const TransientProblem& problem) {
  return {.contact = problem.contact,
          .grid = problem.grid,
          .load = PrescribedCreepage{0},
          .solver = problem.solver,
          .accepted = problem.accepted,
          .friction = problem.friction};
}

SteadyProblem read_contact_of_curve(Scene& scene) {
  if (scene.has("target_error")) {
    throw BadParameter("target_error",
                       "target_error: expected a scene without it, as a curve has a method");
  }
  if (scene.word("problem") == "steady") return read_unloaded_steady(scene);
  require_line_contact(scene);
  const Model model = read_model(scene);
  const auto* transient = std::get_if<TransientScene>(&model);
  return contact_of(transient != nullptr ? transient->problem
                                         : std::get<CylinderScene>(model).problem);
}

std::vector<double> read_creepages(Scene& scene, const TractionBound& bound) {
  if (!scene.has(creepages_key)) return {};
  const std::vector<double> creepages = scene.numbers(creepages_key);
  demand(scene, creepages_key, rising, creepages);
  for (const double creepage : {creepages.front(), creepages.back()}) {
    warn_of_large_creepage(scene, creepages_key, creepage, bound);
  }
  for (const char* other : {"curve.points", "curve.largest"}) {
    scene.at_most_one_of({creepages_key, other});
  }
  return creepages;
}

SteadySolution solved(SteadyProblem problem, const Load& load) {
  problem.load = load;
  SteadySolution solution = solve_steady(problem);
  require_evidence(solution.evidence, solution.condition, solution.iterations, problem.accepted);
  return solution;
}

/// Solves at a creepage. The message about a missing solution names the creepage.
SteadySolution solved_at(const SteadyProblem& problem, double creepage) {
  try {
    return solved(problem, PrescribedCreepage{creepage});
  } catch (const NotConverged& error) {
    throw NotConvergedAt("creepage " + format_short(creepage), error);
  }
}

/// Returns a creepage at which the whole contact slides, with some margin. Friction that falls with
/// slip lets it slide at less.
double beyond_sliding(SteadyProblem problem) {
  constexpr double almost_all = 0.999, margin = 1.25;
  problem.friction.reset();
  const double most = full_sliding_force(problem.contact.bound);
  return rounded_up(margin * solved(problem, PrescribedForce{-almost_all * most}).creepage);
}

std::vector<double> creepages_of(const CurveScene& scene) {
  if (!scene.creepages.empty()) return scene.creepages;
  const double largest = scene.largest ? *scene.largest : beyond_sliding(scene.problem);
  const double least = scene.problem.contact.has_unlike_bodies() ? -largest : 0;
  return evenly_spaced(least, largest, scene.points);
}

/// Returns |dF/dw| at a creepage so small that nothing slips. The bound has no part in it then, and
/// Hertz's is solved with more digits than a table. For like bodies.
double slope_without_creepage(const SteadyProblem& problem, double largest) {
  constexpr double small = 1e-9;
  const double creepage = small * largest;
  const double half_width = problem.grid.half_width();
  SteadyProblem sticking = problem;
  sticking.contact.bound = HertzBound(
      half_width, full_sliding_force(problem.contact.bound) * 2 / (std::numbers::pi * half_width));
  return std::abs(solved_at(sticking, creepage).force) / creepage;
}

Table empty_curve(const CurveScene& scene) {
  std::vector<Column> columns{
      {"creepage", "1", "w"}, {"force", "N/mm", "F"}, {"force_ratio", "1", "F over full sliding"}};
  if (scene.friction) {
    columns.push_back({"traction_coefficient", "1", "F over the normal load"});
  }
  if (scene.with_fastsim) {
    columns.push_back({"fastsim_force", "N/mm", "F by FASTSIM"});
    columns.push_back(
        {"fastsim_error", "1", "size of the difference of the force, over full sliding", 1e-12});
  }
  if (scene.problem.friction) {
    columns.push_back(second_solution_column());
  }
  columns.push_back({"method", "1", "that made the solution"});
  return {"curve", "force of steady rolling against the creepage", columns};
}

}  // namespace

CurveScene read_curve(Scene& scene) {
  const SteadyProblem problem = read_contact_of_curve(scene);
  CurveScene read{.problem = problem,
                  .creepages = read_creepages(scene, problem.contact.bound),
                  .points = 0,
                  .largest = std::nullopt,
                  .with_fastsim = false};
  if (read.creepages.empty()) {
    read.points = read_curve_points(scene);
    if (scene.has("curve.largest")) {
      read.largest = scene.positive("curve.largest");
      warn_of_large_creepage(scene, "curve.largest", *read.largest, problem.contact.bound);
    }
  }
  for (const std::string& law : read_laws_beside(scene)) {
    if (law != "fastsim") reject("curve.beside", law, "nothing or fastsim for a line contact");
    read.with_fastsim = true;
  }
  if (read.with_fastsim && problem.contact.has_unlike_bodies()) {
    reject("curve.beside", "fastsim", "nothing for bodies of different material");
  }
  if (scene.has("contact.normal_load") || problem.contact.has_unlike_bodies()) {
    read.friction = read_friction(scene);
  }
  return read;
}

std::vector<Table> curve_tables(const CurveScene& scene, const Progress& progress) {
  const SteadyProblem& problem = scene.problem;
  const double most = full_sliding_force(problem.contact.bound);
  const std::vector<double> creepages = creepages_of(scene);
  const double largest = std::max(std::abs(creepages.front()), std::abs(creepages.back()));
  std::optional<double> slope;
  if (!problem.contact.has_unlike_bodies() && largest > 0)
    slope = slope_without_creepage(problem, largest);
  if (scene.with_fastsim && !slope) {
    reject(creepages_key, "0", "a creepage that is not zero with FASTSIM");
  }
  std::optional<Fastsim> fastsim;
  if (scene.with_fastsim) fastsim.emplace(half_width_of(problem.contact.bound), most, *slope);

  const bool warns_of_fallback = !problem.contact.has_unlike_bodies() && !problem.friction &&
                                 !std::holds_alternative<TabulatedBound>(problem.contact.bound);
  Table table = empty_curve(scene);
  std::string fallback;
  double largest_error = 0;
  std::size_t done = 0;
  for (const double creepage : creepages) {
    const SteadySolution point = solved_at(problem, creepage);
    std::vector<Cell> row{creepage, point.force, point.force / most};
    if (scene.friction) row.emplace_back(*scene.friction * point.force / most);
    if (fastsim) {
      const double force = fastsim->force(creepage), error = std::abs(force - point.force) / most;
      largest_error = std::max(largest_error, error);
      row.emplace_back(force);
      row.emplace_back(error);
    }
    if (problem.friction) row.emplace_back(point.has_second ? 1.0 : 0.0);
    row.emplace_back(name_of(point.scheme));
    table.add(row);
    if (fallback.empty() && point.has_second) {
      fallback = fmt::format("creepage = {}: {}", format_short(creepage),
                             second_solution(problem.friction->branch));
    }
    if (fallback.empty() && !point.fallback.empty() && warns_of_fallback) {
      fallback = fmt::format("creepage = {}: by {}, because {}", format_short(creepage),
                             name_of(point.scheme), point.fallback);
    }
    progress(++done, creepages.size());
  }
  Table summary = empty_summary("ends of the creepage-force curve");
  summary.add({"full_sliding_force", most, "N/mm"});
  if (slope) summary.add({"slope_without_creepage", -*slope, "N/mm"});
  if (fastsim) {
    summary.add({"fastsim_flexibility", fastsim->flexibility(), "mm^3/N"});
    summary.add({"fastsim_full_sliding_creepage", fastsim->full_sliding_creepage(), "1"});
    summary.add({"fastsim_error", largest_error, "1"});
  }
  summary.add({"warning", fallback.empty() ? "none" : fallback, "1"});
  return {table, summary};
}

}  // namespace microslip::experiments
