// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "microslip/experiments/contact_tables.hpp"
#include "microslip/experiments/scene_tables.hpp"
#include "patch_tables.hpp"

namespace microslip::experiments {

std::vector<Table> scene_tables(const SteadyPatch& patch, const Progress& progress) {
  progress(0, 1);
  const SteadyPatchSolution solution = solve_steady_with_change(patch);
  progress(1, 1);
  Table summary = empty_summary("steady rolling, the whole contact");
  add_patch_load(summary, solution.resultants, solution.motion, patch.bound);
  add_patch_shares(summary, patch.bound.total(), solution.force(),
                   solution.slip_area() / solution.area.sum());
  summary.add({"dissipation", solution.dissipation, "N"});
  add_patch_sizes(summary, patch);
  summary.add({"iterations", solution.iterations, "1"});
  add_evidence(summary, solution.evidence,
               {.condition = solution.condition,
                .iterations = solution.iterations,
                .accepted = patch.accepted,
                .steady = true,
                .doubt = doubt_of_patch(solution.evidence)});
  return {patch_traction_table(std::string("steady rolling") + at_cells,
                               {solution.x, solution.y, solution.area, solution.bound,
                                solution.traction, solution.slip, solution.slips}),
          patch_edges_table(patch), summary};
}

}  // namespace microslip::experiments
