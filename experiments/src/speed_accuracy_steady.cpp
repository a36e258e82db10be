// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>

#include "microslip/rolling/chebyshev_rolling.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/spectrum/leading_edge.hpp"
#include "speed_accuracy_problems.hpp"

namespace microslip::experiments {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Of tractions that are functions of the position, at so many places.
constexpr Index samples = 1023;

struct Truth {
  PrescribedCreepage load;
  ChebyshevSolution solution;
};

/// One kernel and bound under some loads.
struct Problem {
  std::string name;
  Kernel kernel;
  PolynomialBound bound;
  std::vector<Truth> truths;
};

std::shared_ptr<const Problem> make_problem(const SpeedAccuracyParameters& p, std::string name,
                                            const Kernel& kernel) {
  const ChebyshevRolling reference(kernel, p.bound);
  std::vector<Truth> truths;
  for (const double stick_ratio : p.steady.stick_ratios) {
    const PrescribedCreepage load{
        reference.at(p.bound.half_width() * (1 - 2 * stick_ratio)).creepage};
    truths.push_back({load, reference.solve(load)});
  }
  return std::make_shared<const Problem>(Problem{std::move(name), kernel, p.bound, truths});
}

/// Raises the errors to those of one more load.
void judge(const Truth& truth, double force, double spacing, const VectorXd& x,
           const VectorXd& traction, Errors& errors) {
  const double exact = truth.solution.force();
  const VectorXd difference =
      traction - x.unaryExpr([&](double xi) { return truth.solution.traction(xi); });
  const auto raise = [&](Quantity of, double error) {
    errors[of] = std::fmax(errors[of], error / std::abs(exact));
  };
  raise(Quantity::force, std::abs(force - exact));
  raise(Quantity::traction, spacing * difference.lpNorm<1>());
}

/// A leading edge that a table of schemes can name.
struct Edge {
  std::string name;
  double leading_offset = 0.5;
  double trailing_offset = 0.5;
};

Solve steady_solve(const std::shared_ptr<const Problem>& problem, const Edge& edge,
                   const Basis& basis, double step_ratio, Solver::Type type) {
  return [=](Index elements) {
    const Grid grid({.half_width = problem->bound.half_width(),
                     .elements = elements,
                     .leading_offset = edge.leading_offset,
                     .trailing_offset = edge.trailing_offset});
    std::vector<SteadySolution> solutions;
    for (const Truth& truth : problem->truths) {
      Differences differences{.step_ratio = std::isnan(step_ratio) ? 1 : step_ratio};
      if (edge.name == "exact") {
        differences.edge_displacement = ChebyshevRolling(problem->kernel, problem->bound)
                                            .solve(truth.load)
                                            .displacement(problem->bound.half_width());
      }
      SteadyProblem problem_of_load{.kernel = problem->kernel,
                                    .bound = problem->bound,
                                    .grid = grid,
                                    .basis = basis,
                                    .method = differences,
                                    .load = truth.load,
                                    .solver = {.type = type}};
      if (edge.name == "inversion") problem_of_load.method = Inversion{};
      if (edge.name == "calibrated") problem_of_load.method = Calibrated{};
      solutions.push_back(solve_steady(problem_of_load));
    }
    return [=] {
      Judgement judgement;
      for (std::size_t k = 0; k < solutions.size(); ++k) {
        const SteadySolution& s = solutions[k];
        judge(problem->truths[k], s.force, grid.spacing(), s.x, s.traction, judgement.errors);
        judgement.rounds += s.iterations / static_cast<double>(solutions.size());
      }
      return judgement;
    };
  };
}

/// N unknowns.
Solve chebyshev_solve(const std::shared_ptr<const Problem>& problem) {
  return [=](Index unknowns) {
    std::vector<ChebyshevSolution> solutions;
    for (const Truth& truth : problem->truths) {
      solutions.push_back(
          ChebyshevRolling(problem->kernel, problem->bound, unknowns).solve(truth.load));
    }
    return [=] {
      Judgement judgement;
      const Grid grid({.half_width = problem->bound.half_width(), .elements = samples});
      const VectorXd x = grid.nodes();
      for (std::size_t k = 0; k < solutions.size(); ++k) {
        const ChebyshevSolution& s = solutions[k];
        judge(problem->truths[k], s.force(), grid.spacing(), x,
              x.unaryExpr([&](double xi) { return s.traction(xi); }), judgement.errors);
        judgement.rounds += s.evaluations() / static_cast<double>(solutions.size());
      }
      return judgement;
    };
  };
}

void add_problem(const SpeedAccuracyParameters& p, const std::shared_ptr<const Problem>& problem,
                 const std::vector<double>& step_ratios, std::vector<RunSeries>& all) {
  const auto loads = static_cast<double>(problem->truths.size());
  const auto add = [&](const Edge& edge, const Basis& basis, double c, Solver::Type type) {
    const Contestant who{problem->name, "collocation", edge.name, basis.name(), c, name_of(type)};
    all.push_back(
        {who, p.sizes, p.steady.limit, loads, steady_solve(problem, edge, basis, c, type)});
  };
  all.push_back(
      {{problem->name, "inversion", "none", "none", not_given, "none"},
       {p.sizes.front()},
       p.steady.limit,
       loads,
       steady_solve(problem, {"inversion"}, constant_basis(), not_given, Solver::Type::automatic)});
  for (const auto type : {Solver::Type::dense, Solver::Type::fft}) {
    for (const char* name : {"constant", "linear", "quadratic"}) {
      const Basis basis = make_basis(name);
      add({"calibrated"}, basis, not_given, type);
      if (basis.name() != "quadratic") {
        // Where a difference over one element feels it, and the midpoint rule the trailing one.
        constexpr double trailing = 0.656936;
        add({"aligned", leading_edge_constants(basis).offset, trailing}, basis, 1, type);
      }
      for (const double c : step_ratios) {
        add({"standard"}, basis, c, type);
        add({"exact"}, basis, c, type);
      }
    }
    for (const double c : step_ratios) add({"trimmed"}, trimmed_linear_basis(0.5), c, type);
  }
  all.push_back({{problem->name, "chebyshev", "none", "none", not_given, "none"},
                 p.steady.unknowns,
                 p.steady.limit,
                 loads,
                 chebyshev_solve(problem)});
}

}  // namespace

std::vector<RunSeries> steady_contest(const SpeedAccuracyParameters& p) {
  std::vector<RunSeries> all;
  add_problem(p, make_problem(p, "plane", PlaneKernel(p.material, p.length)), p.steady.step_ratios,
              all);
  add_problem(p, make_problem(p, "strip", StripKernel(p.material, p.width)),
              {p.steady.step_ratios.front()}, all);
  return all;
}

}  // namespace microslip::experiments
