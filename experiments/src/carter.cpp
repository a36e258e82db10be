// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/carter.hpp"

#include "microslip/experiments/steady_scene.hpp"
#include "microslip/reference/carter.hpp"
#include "microslip/scene/model.hpp"

namespace microslip::experiments {

namespace {

constexpr int exact_points = 1001;

Carter exact_solution(const SteadyProblem& problem) {
  const Material& material = material_of(problem.kernel);
  if (const auto* force = std::get_if<PrescribedForce>(&problem.load)) {
    return Carter::from_force(material, problem.bound, force->value);
  }
  return Carter::from_creepage(material, problem.bound,
                               std::get<PrescribedCreepage>(problem.load).value);
}

Table exact_table(const Carter& exact, double half_width) {
  Table table("exact", "Carter's solution, thesis (10.1)",
              {{"x", "mm", "position"},
               {"traction", "N/mm^2", "exact traction"},
               {"slip", "1", "exact relative slip"}});
  for (int i = 0; i < exact_points; ++i) {
    const double x = half_width * (2.0 * i / (exact_points - 1) - 1);
    table.add({x, exact.traction(x), exact.slip(x)});
  }
  return table;
}

void add_solution(Table& table, double step_ratio, const SteadySolution& solution,
                  const Eigen::VectorXd& exact) {
  for (Eigen::Index i = 0; i < solution.x.size(); ++i) {
    table.add({step_ratio, solution.x[i], solution.bound[i], solution.traction[i], solution.slip[i],
               region(solution.zones[static_cast<std::size_t>(i)]), exact[i]});
  }
}

}  // namespace

Eigen::Index turning_points(const Eigen::VectorXd& values) {
  Eigen::Index count = 0;
  for (Eigen::Index i = 1; i + 1 < values.size(); ++i) {
    count += (values[i] - values[i - 1]) * (values[i + 1] - values[i]) < 0;
  }
  return count;
}

CarterParameters read_carter(Scene& scene) {
  const std::vector<double> step_ratios = scene.numbers("step.ratios");
  return {.problem = read_steady(scene, step_ratios.front()), .step_ratios = step_ratios};
}

std::vector<Table> carter(const CarterParameters& parameters, const Progress& progress) {
  SteadyProblem problem = parameters.problem;
  const Carter exact = exact_solution(problem);
  Table traction("traction", "steady rolling for several step ratios, values at the nodes",
                 {{"step_ratio", "1", "c = dq/dx"},
                  {"x", "mm", "position; the leading edge is at x = +half_width"},
                  {"bound", "N/mm^2", "traction bound g"},
                  {"traction", "N/mm^2", "tangential traction p"},
                  {"slip", "1", "relative slip s"},
                  {"region", "1", "A adhesion, S slip"},
                  {"exact", "N/mm^2", "Carter's traction at x"}});
  Table summary("summary", "steady rolling for several step ratios, the whole contact",
                {{"step_ratio", "1", "c = dq/dx"},
                 {"force", "N/mm", "total force F"},
                 {"exact_force", "N/mm", "Carter's force"},
                 {"relative_force_error", "1", "force / exact_force - 1"},
                 {"largest_error", "N/mm^2", "largest difference of traction and exact at a node"},
                 {"turning_points", "1", "local extrema of the traction; exact: 1"},
                 {"adhesion_elements", "1", "elements in adhesion"},
                 {"slip_elements", "1", "elements in slip"},
                 {"iterations", "1", "linear systems factorised"}});
  for (const double step_ratio : parameters.step_ratios) {
    problem.step_ratio = step_ratio;
    const SteadySolution solution = solve_steady(problem);
    const Eigen::VectorXd at_nodes =
        solution.x.unaryExpr([&](double x) { return exact.traction(x); });
    add_solution(traction, step_ratio, solution, at_nodes);
    summary.add({step_ratio, solution.force, exact.force(), solution.force / exact.force() - 1,
                 (solution.traction - at_nodes).lpNorm<Eigen::Infinity>(),
                 static_cast<double>(turning_points(solution.traction)),
                 static_cast<double>(solution.adhesion_elements()),
                 static_cast<double>(solution.slip_elements()),
                 static_cast<double>(solution.iterations)});
    progress(summary.rows(), parameters.step_ratios.size());
  }
  return {traction, exact_table(exact, problem.bound.half_width()), summary};
}

}  // namespace microslip::experiments
