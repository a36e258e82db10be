// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/carter.hpp"

#include <fmt/core.h>

#include "microslip/experiments/claims.hpp"
#include "microslip/experiments/contact_tables.hpp"
#include "microslip/experiments/profile.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/reference/carter.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip::experiments {

namespace {

constexpr int exact_points = 1001;
const std::string exact_only = "as errors are differences to Carter's solution";

Carter exact_solution(const SteadyProblem& problem) {
  const Material& material = problem.contact.kernel.material();
  const auto& bound = std::get<HertzBound>(problem.contact.bound);
  if (const auto* force = std::get_if<PrescribedForce>(&problem.load)) {
    return Carter::from_force(material, bound, force->value);
  }
  return Carter::from_creepage(material, bound, std::get<PrescribedCreepage>(problem.load).value);
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

Table accuracy_table(const CarterParameters& parameters, const Carter& exact) {
  Table table(
      "accuracy", "force error against the step ratio",
      {{"step_ratio", "1", "c = dq/dx"}, {"relative_force_error", "1", "force / exact_force - 1"}});
  SteadyProblem problem = parameters.problem;
  for (const double step_ratio : parameters.accuracy_step_ratios) {
    problem.method = Differences{.step_ratio = step_ratio};
    table.add({step_ratio, solve_steady(problem).force / exact.force() - 1});
  }
  return table;
}

Table claims_of(const Table& summary, const Table& accuracy) {
  const std::size_t last = summary.rows() - 1;
  const double first_wiggles = summary.number(0, "turning_points");
  const double last_wiggles = summary.number(last, "turning_points");
  std::size_t best = 0;
  for (std::size_t i = 1; i < accuracy.rows(); ++i) {
    const auto error = [&](std::size_t row) {
      return std::abs(accuracy.number(row, "relative_force_error"));
    };
    if (error(i) < error(best)) best = i;
  }
  const double best_ratio = accuracy.number(best, "step_ratio");
  return claims_table(
      {{"wiggles arise when the step is small against the element", "1", not_given, last_wiggles,
        "1", holds_if({above(5), {"the number at the largest c", first_wiggles, equal_to(1)}}),
        fmt::format("local extrema of the traction at c = {}; at c = {}: {}; exact: 1",
                    format_short(summary.number(last, "step_ratio")),
                    format_short(summary.number(0, "step_ratio")), format_short(first_wiggles)),
        "carter_traction"},
       {"accuracy decreases again for c < 0.55", "1", 0.55, best_ratio, "1",
        holds_if({within(0.1, 0.55)}),
        "c of the least error of the force, on elements that fill the contact",
        "carter_accuracy"}});
}

}  // namespace

CarterParameters read_carter(Scene& scene) {
  using enum Key::Type;
  scene.declare({{"step.ratios", list, "1", "c of the tractions shown", range_from(min_step_ratio)},
                 {"accuracy.step_ratios", list, "1", "c of the errors of the force",
                  range_from(min_step_ratio)}});

  if (scene.has("contact.bound_file")) {
    throw BadParameter("contact.bound_file",
                       "contact.bound_file: Carter's solution is for a Hertzian bound; expected "
                       "contact.peak_traction");
  }
  const std::vector<double> step_ratios = scene.numbers("step.ratios");
  const SteadyProblem problem = read_steady(scene, Differences{});
  if (!problem.contact.kernel.is_plane()) {
    reject("kernel.type", problem.contact.kernel.name(), "plane without a layer, " + exact_only);
  }
  if (!std::holds_alternative<HertzBound>(problem.contact.bound)) {
    throw BadParameter("contact.bound_polynomial",
                       "contact.bound_polynomial, contact.roughness: expected none, " + exact_only);
  }
  return {.problem = problem,
          .step_ratios = step_ratios,
          .accuracy_step_ratios = scene.numbers("accuracy.step_ratios")};
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
                 {"iterations", "1", "stick/slip partitions tried"}});
  for (const double step_ratio : parameters.step_ratios) {
    problem.method = Differences{.step_ratio = step_ratio};
    const SteadySolution solution = solve_steady(problem);
    const Eigen::VectorXd at_nodes =
        solution.x.unaryExpr([&](double x) { return exact.traction(x); });
    add_solution(traction, step_ratio, solution, at_nodes);
    summary.add({step_ratio, solution.force, exact.force(), solution.force / exact.force() - 1,
                 (solution.traction - at_nodes).lpNorm<Eigen::Infinity>(),
                 turning_points(solution.traction), solution.adhesion_elements(),
                 solution.slip_elements(), solution.iterations});
    progress(summary.rows(), parameters.step_ratios.size());
  }
  const Table accuracy = accuracy_table(parameters, exact);
  return {traction, exact_table(exact, half_width_of(problem.contact.bound)), summary, accuracy,
          claims_of(summary, accuracy)};
}

}  // namespace microslip::experiments
