// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/steady_scene.hpp"

#include "microslip/experiments/contact_tables.hpp"

namespace microslip::experiments {

std::vector<Table> steady_scene(const SteadyProblem& problem) {
  const SteadySolution solution = solve_steady(problem);
  const double full_sliding = full_sliding_force(problem.bound);
  Table summary = empty_summary("steady rolling, the whole contact");
  summary.add({"force", solution.force, "N/mm"});
  summary.add({"creepage", solution.creepage, "1"});
  summary.add({"force_ratio", solution.force / full_sliding, "1"});
  summary.add({"full_sliding_force", full_sliding, "N/mm"});
  if (solution.stick_edge) summary.add({"stick_edge", *solution.stick_edge, "mm"});
  summary.add({"adhesion_elements", static_cast<double>(solution.adhesion_elements()), "1"});
  summary.add({"slip_elements", static_cast<double>(solution.slip_elements()), "1"});
  summary.add({"iterations", static_cast<double>(solution.iterations), "1"});
  summary.add({"residual", solution.residual, "1"});
  summary.add({"dissipation", solution.dissipation, "N/mm"});
  return {traction_table("steady rolling, values at the nodes",
                         {solution.x, solution.bound, solution.traction, solution.slip,
                          solution.displacement, solution.zones}),
          summary};
}

}  // namespace microslip::experiments
