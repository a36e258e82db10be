// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <optional>
#include <string>
#include <utility>

#include "microslip/experiments/contact_tables.hpp"
#include "microslip/experiments/scene_tables.hpp"
#include "patch_tables.hpp"

namespace microslip::experiments {

namespace {

std::vector<Table> tables_of(const SteadyPatch& patch, const SteadyPatchSolution& solution,
                             Table summary, const std::optional<double>& error) {
  add_patch_load(summary, solution.resultants, solution.motion, patch.bound);
  add_patch_shares(summary, patch.bound.total(), solution.force(),
                   solution.slip_area() / solution.area.sum());
  summary.add({"dissipation", solution.dissipation, "N"});
  if (patch.friction) summary.add({"second_solution", solution.has_second ? 1 : 0, "1"});
  add_patch_sizes(summary, patch);
  summary.add({"iterations", solution.iterations, "1"});
  if (error) summary.add({"estimated_error", *error, "1"});
  const std::optional<std::string> doubt = solution.has_second
                                               ? second_solution(patch.friction->branch)
                                               : doubt_of_patch(solution.evidence);
  add_evidence(summary, solution.evidence,
               {.condition = solution.condition,
                .iterations = solution.iterations,
                .accepted = patch.accepted,
                .steady = true,
                .doubt = doubt});
  return {patch_traction_table(std::string("steady rolling") + at_cells,
                               {solution.x, solution.y, solution.area, solution.bound,
                                solution.traction, solution.slip, solution.slips}),
          patch_edges_table(patch), summary};
}

}  // namespace

std::vector<Table> scene_tables(const SteadyPatch& patch, const Progress& progress) {
  progress(0, 1);
  const SteadyPatchSolution solution = solve_steady_with_change(patch);
  progress(1, 1);
  return tables_of(patch, solution, empty_summary("steady rolling, the whole contact"),
                   std::nullopt);
}

std::vector<Table> scene_tables(const PatchTarget& target, const Progress& progress) {
  progress(0, 1);
  const auto [patch, solution, error] = solve_steady_to(target.patch, target.error);
  progress(1, 1);
  Table summary = empty_summary(
      fmt::format("steady rolling, the whole contact; picked: grid.rows {}, grid.elements {}",
                  patch.rows, patch.elements));
  return tables_of(patch, solution, std::move(summary), error);
}

}  // namespace microslip::experiments
