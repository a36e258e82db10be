// SPDX-License-Identifier: GPL-3.0-or-later
#include "few_steps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <variant>

#include "microslip/halfspace/influence.hpp"
#include "microslip/rolling/straight_steps.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/format.hpp"

namespace microslip {

namespace {

/// The mean length over which the load is straight to a tenth of full sliding; 0 if it is shorter
/// than the shortest of steps.  [mm]
double length_of_change(const TransientProblem& problem, const LoadHistory& loads) {
  constexpr double part = 0.1;
  const auto lengths =
      straight_steps(loads, tolerance_of_load(problem, part),
                     std::numeric_limits<double>::infinity(), static_cast<std::size_t>(most_steps));
  return lengths ? loads.distance() / static_cast<double>(lengths->size()) : 0;
}

}  // namespace

std::vector<double> read_step_ratios(Scene& scene) {
  std::vector<double> ratios = scene.numbers("step.ratio");
  for (const double ratio : ratios) {
    require(ratio == 0 || ratio >= min_step_ratio, "step.ratio", ratio,
            ratio < 0 ? "numbers >= 1e-15 or 0; bodies roll back by rows of load.file"
                      : "numbers >= 1e-15 or 0");
  }
  std::erase(ratios, 0);
  require(!ratios.empty(), "step.ratio", 0, "at least one number > 0");
  return ratios;
}

namespace {

double read_whole_distance(Scene& scene, double of_file) {
  if (std::isinf(of_file)) return scene.positive("motion.distance");
  const double distance = scene.number("motion.distance", of_file);
  constexpr double printed = 1e-6;  // the file's distance may be a rounded one
  require_positive("motion.distance", distance);
  require(distance <= (1 + printed) * of_file, "motion.distance", distance,
          [&] { return "at most the distance of load.file, " + format_short(of_file); });
  return std::min(distance, of_file);
}

}  // namespace

double read_distance(Scene& scene, double of_file, double from) {
  const double distance = read_whole_distance(scene, of_file);
  require(distance > from, "motion.distance", distance,
          [&] { return "more than the distance of start.state, " + format_short(from); });
  return distance;
}

LoadTolerance tolerance_of_load(const TransientProblem& problem, double part) {
  const double force = part * full_sliding_force(problem.contact.bound);
  return {.shift = force / stiffness(problem), .force = force, .contact = part};
}

std::string instead_of_many_steps(const TransientProblem& problem, const LoadHistory& loads,
                                  bool has_tolerance) {
  if (loads.distances().empty()) return "";
  constexpr double steady = 10;  // contact lengths
  std::string advice;
  if (!has_tolerance && std::holds_alternative<Remembered>(problem.scheme)) {
    advice = "; step.tolerance, as 1e-3, takes steps as long as the load is straight";
  }
  const double contact = 2 * problem.grid.half_width();
  const double change = length_of_change(problem, loads);
  if (change < steady * contact) return advice;
  return advice + fmt::format(
                      "; the load changes over {} mm and the contact is {} mm long, so that "
                      "rolling is steady at each place: microslip curve computes its force",
                      format_roughly(change), format_roughly(contact));
}

void require_few_rows(const Scene& scene, const TransientProblem& problem,
                      const LoadHistory& loads) {
  for (const char* key : {"step.ratio", "step.tolerance", "motion.distance"}) {
    if (scene.has(key)) return;
  }
  const auto steps = static_cast<double>(loads.distances().size()) - 1;
  if (steps <= most_steps) return;
  scene.with_file("load.file", [&] {
    throw std::invalid_argument(fmt::format("expected at most {} steps, and its rows make {:.0f}{}",
                                            format_short(most_steps), steps,
                                            instead_of_many_steps(problem, loads, false)));
  });
}

}  // namespace microslip
