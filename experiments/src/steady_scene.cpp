// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/steady_scene.hpp"

namespace microslip::experiments {

namespace {

Table traction_table(const SteadySolution& solution) {
  Table table("traction", "steady rolling, values at the nodes",
              {{"x", "mm", "position; the leading edge is at x = +half_width"},
               {"bound", "N/mm^2", "traction bound g"},
               {"traction", "N/mm^2", "tangential traction p"},
               {"slip", "1", "relative slip s"},
               {"displacement", "mm", "tangential displacement difference u"},
               {"region", "1", "A adhesion, S slip"}});
  for (Eigen::Index i = 0; i < solution.x.size(); ++i) {
    table.add({solution.x[i], solution.bound[i], solution.traction[i], solution.slip[i],
               solution.displacement[i], region(solution.zones[static_cast<std::size_t>(i)])});
  }
  return table;
}

Table summary_table(const SteadySolution& solution, double full_sliding) {
  Table table("summary", "steady rolling, the whole contact",
              {{"quantity", "1", "name"},
               {"value", "see unit", "value"},
               {"unit", "1", "unit of the value"}});
  table.add({"force", solution.force, "N/mm"});
  table.add({"creepage", solution.creepage, "1"});
  table.add({"force_ratio", solution.force / full_sliding, "1"});
  table.add({"full_sliding_force", full_sliding, "N/mm"});
  table.add({"adhesion_elements", static_cast<double>(solution.adhesion_elements()), "1"});
  table.add({"slip_elements", static_cast<double>(solution.slip_elements()), "1"});
  table.add({"iterations", static_cast<double>(solution.iterations), "1"});
  table.add({"dissipation", solution.dissipation, "N/mm"});
  return table;
}

}  // namespace

std::string region(Zone zone) { return zone == Zone::adhesion ? "A" : "S"; }

std::vector<Table> steady_scene(const SteadyProblem& problem) {
  const SteadySolution solution = solve_steady(problem);
  return {traction_table(solution), summary_table(solution, full_sliding_force(problem.bound))};
}

}  // namespace microslip::experiments
