// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "doubts.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "run_columns.hpp"

namespace microslip {

namespace {

/// Requires that each force is below full sliding of its row's contact, or 0 where the bodies do
/// not touch.
void require_all_carried(const Eigen::VectorXd& forces, const LoadHistory& loads,
                         const TractionBound& bound) {
  const double full = full_sliding_force(bound);
  for (Eigen::Index i = 0; i < forces.size(); ++i) {
    const ContactScale contact = loads.contact_of_row(static_cast<std::size_t>(i));
    require_carried(forces[i], contact, full, fmt::format("row {}: force", i + 1));
  }
}

/// The scene's value of the quantity in a column of the contact; 1 without the column.
double of_problem(Scene& scene, const std::optional<Eigen::VectorXd>& column,
                  const std::string& name) {
  if (!column) return 1;
  const std::string key = "contact." + name;
  if (scene.has(key)) return scene.positive(key);
  throw std::invalid_argument(fmt::format(
      "column '{}': expected {} to be given, of the contact that it changes", name, key));
}

void require_contacts(const LoadHistory& loads, const TransientProblem& problem) {
  if (!loads.changes_contact()) return;
  require_scheme_of_changes(problem.scheme);
  if (problem.contact.has_unlike_bodies()) {
    throw std::invalid_argument(
        "columns normal_load, half_width, peak_traction and friction: expected none of them where "
        "bodies differ in material");
  }
  double narrowest = std::numeric_limits<double>::infinity(), widest = 0;
  for (const ContactScale& contact : loads.contacts()) {
    narrowest = std::min(narrowest, contact.half_width);
    widest = std::max(widest, contact.half_width);
  }
  if ((narrowest != 1 || widest != 1) && !problem.contact.kernel.is_half_space()) {
    throw std::invalid_argument(fmt::format(
        "columns normal_load and half_width: expected none that changes the half-width where the "
        "kernel is {}, not a half-space",
        problem.contact.kernel.name()));
  }
  with_keys([&] {
    require_definite(problem.contact.kernel,
                     widest * (problem.grid.half_width() + problem.grid.spacing()));
  });
}

}  // namespace

LoadHistory read_run(Scene& scene, const TransientProblem& problem) {
  const std::vector<FileColumn> wanted = run_columns(scene);
  RunRows rows = scene.from_columns("load.file", wanted, [&](const auto& columns) {
    require_run(scene, wanted, columns);
    return RunRows{.distance = columns[0],
                   .time = columns[1],
                   .velocity = columns[2],
                   .creepage = columns[3],
                   .force = columns[4],
                   .angular_velocity = columns[5],
                   .normal_load = columns[6],
                   .half_width = columns[7],
                   .peak_traction = columns[8],
                   .friction = columns[9]};
  });
  if (rows.angular_velocity) {
    rows.radius = scene.positive("load.radius");
    warn_of_small_radius(scene, "load.radius", rows.radius, problem.grid.half_width());
  }
  rows.force_acts_before = starts_under_force(scene);
  return scene.with_file("load.file", [&] {
    rows.of_problem = reference_of(scene, rows);
    const LoadHistory loads(rows);
    require_contacts(loads, problem);
    require_scheme_of_direction(problem.scheme, loads);
    if (!loads.stops().empty()) require_scheme_of_stops(scene, problem.scheme);
    warn_of_large_creepages(scene, loads, problem.contact.bound);
    warn_of_other_load(scene, rows.normal_load);
    warn_of_short_way(scene, loads, rows.velocity, problem.grid.half_width());
    warn_of_short_turns(scene, rows.distance, problem.grid.half_width());
    if (rows.force) require_all_carried(*rows.force, loads, problem.contact.bound);
    return loads;
  });
}

RunRows::Reference reference_of(Scene& scene, const RunRows& rows) {
  return {.normal_load = of_problem(scene, rows.normal_load, "normal_load"),
          .half_width = of_problem(scene, rows.half_width, "half_width"),
          .peak_traction = of_problem(scene, rows.peak_traction, "peak_traction"),
          .friction = of_problem(scene, rows.friction, "friction")};
}

bool starts_under_force(const Scene& scene) {
  if (!scene.has("start.type")) return true;
  const std::string& type = scene.text("start.type");
  return type != "rest" && type != "file";
}

void require_scheme_of_changes(const AdvectionScheme& scheme) {
  if (std::holds_alternative<Remembered>(scheme)) return;
  reject("step.scheme", name_of(scheme),
         "remembered, which alone rolls on a contact that changes, as columns of load.file have "
         "it");
}

void require_scheme_of_direction(const AdvectionScheme& scheme, const LoadHistory& loads) {
  if (std::holds_alternative<Remembered>(scheme) || !loads.stops().empty()) return;
  if (loads.direction_to(loads.distance()) > 0) return;
  reject("step.scheme", name_of(scheme),
         "remembered, which alone rolls back, as rows of load.file have it");
}

void require_scheme_of_stops(Scene& scene, const AdvectionScheme& scheme) {
  if (!std::holds_alternative<Remembered>(scheme)) {
    reject(
        "step.scheme", name_of(scheme),
        "remembered, which alone turns and is shifted within a run, as rows of load.file have it");
  }
  if (scene.has("step.tolerance")) {
    reject("step.tolerance", scene.text("step.tolerance"),
           "none where the rows of load.file turn or shift the bodies; steps end at the rows, or "
           "are those of step.ratio");
  }
  if (scene.has("start.type") && scene.text("start.type") == "state") {
    reject("start.type", "state",
           "another start where the rows of load.file turn or shift the bodies");
  }
}

std::vector<double> row_ratios(const std::vector<double>& rows, double spacing) {
  std::vector<double> ratios;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i] > rows[i - 1]) ratios.push_back((rows[i] - rows[i - 1]) / spacing);
  }
  return ratios;
}

}  // namespace microslip
