// SPDX-License-Identifier: GPL-3.0-or-later
#include "resolved_elements.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "graded_elements.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr Index most_graded_rows = 400;  // for graded elements
constexpr Index most_graded = 1000;
constexpr Index fewest_equal = 256;
constexpr Index elements_per_row = 4;
constexpr Index most_equal = 16384;
constexpr double small_change = 2e-3;  // change from elements twice as long

/// Values at the nodes of the problem, by the element that holds the node.
/// \param ends  of the elements of `fine`, ascending
SteadySolution sampled(const SteadyProblem& problem, const SteadySolution& fine,
                       const ElementEnds& ends) {
  SteadySolution at_nodes = fine;
  const VectorXd x = problem.grid.nodes();
  at_nodes.x = x;
  at_nodes.bound = bound_at(problem.contact.bound, x);
  for (VectorXd* values : {&at_nodes.traction, &at_nodes.slip, &at_nodes.displacement}) {
    values->resize(x.size());
  }
  at_nodes.zones.clear();
  for (Index i = 0; i < x.size(); ++i) {
    const auto next = std::ranges::upper_bound(ends, x[i]);
    const auto element = std::clamp<Index>(next - ends.begin() - 1, 0, fine.x.size() - 1);
    at_nodes.traction[i] =
        std::clamp(fine.traction[element], -at_nodes.bound[i], at_nodes.bound[i]);
    at_nodes.slip[i] = fine.slip[element];
    at_nodes.displacement[i] = fine.displacement[element];
    at_nodes.zones.push_back(fine.zones[static_cast<std::size_t>(element)]);
  }
  return at_nodes;
}

ElementEnds halved(const ElementEnds& ends) {
  ElementEnds finer;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    finer.insert(finer.end(), {ends[i], std::midpoint(ends[i], ends[i + 1])});
  }
  finer.push_back(ends.back());
  return finer;
}

SteadySolution on_graded(const SteadyProblem& problem) {
  const Index fewest = std::clamp<Index>(problem.grid.size(), 60, 400);
  const ElementEnds long_elements = graded_elements(problem.contact.bound, fewest);
  const GradedState fine = solve_graded(problem, halved(long_elements), most_graded);
  const GradedState coarse = solve_graded(problem, long_elements, most_graded);
  SteadySolution solution = graded_solution(problem, fine);
  solution.evidence.change =
      change_of_answer(problem.load, graded_solution(problem, coarse), solution);
  return sampled(problem, solution, fine.ends);
}

SteadySolution on_equal(const SteadyProblem& problem) {
  SteadyProblem by_elements = problem;
  by_elements.method = Calibrated{};
  const auto solve = [&](Index elements) {
    by_elements.grid = Grid({.half_width = problem.grid.half_width(), .elements = elements});
    return solve_steady(by_elements);
  };
  // Elements that are longer than the rows' distances agree with one another on the answer under
  // the mean bound, which may be 4 % off next to full sliding: the comparison says something from
  // several elements a row on.
  const Index rows = std::get<TabulatedBound>(problem.contact.bound).x().size();
  Index elements =
      std::max({fewest_equal, problem.grid.size(), std::min(elements_per_row * rows, most_equal)});
  SteadySolution coarse = solve(elements / 2);
  for (;; elements *= 2) {
    SteadySolution fine = solve(elements);
    fine.evidence.change = change_of_answer(problem.load, coarse, fine);
    if (fine.evidence.change > small_change && 2 * elements <= most_equal) {
      coarse = std::move(fine);
      continue;
    }
    const double step = fine.x.size() > 1 ? fine.x[1] - fine.x[0] : 2 * problem.grid.half_width();
    ElementEnds ends;
    for (const double x : fine.x) ends.push_back(x - step / 2);
    ends.push_back(fine.x[fine.x.size() - 1] + step / 2);
    return sampled(problem, fine, ends);
  }
}

}  // namespace

SteadySolution solve_on_resolved_elements(const SteadyProblem& problem, const std::string& why) {
  const auto& table = std::get<TabulatedBound>(problem.contact.bound);
  const bool graded = table.x().size() <= most_graded_rows && problem.contact.kernel.has_material();
  SteadySolution solution = graded ? on_graded(problem) : on_equal(problem);
  solution.scheme = graded ? SteadyScheme::graded : SteadyScheme::calibrated;
  solution.fallback = why;
  return solution;
}

}  // namespace microslip
