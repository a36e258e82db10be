// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>

#include "campaign.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/spectrum/leading_edge.hpp"
#include "speed_accuracy_problems.hpp"

namespace microslip::experiments::speed_accuracy_study {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Of tractions that are functions of the position, at so many places.
constexpr Index samples = 1023;

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
    truths.push_back(truth_of(reference, p.bound.half_width(), stick_ratio));
  }
  return std::make_shared<const Problem>(Problem{std::move(name), kernel, p.bound, truths});
}

/// Raises the errors to those of one more load.
void judge(const Truth& truth, double force, double spacing, const VectorXd& x,
           const VectorXd& traction, Errors& errors) {
  const VectorXd difference = traction - truth.at(x);
  const auto raise = [&](Quantity of, double error) {
    errors[of] = std::fmax(errors[of], error / std::abs(truth.force));
  };
  raise(Quantity::force, std::abs(force - truth.force));
  raise(Quantity::traction, spacing * difference.lpNorm<1>());
}

/// Where the edges are, in elements beyond the last node and before the first.
struct Alignment {
  double leading = 0.5;
  double trailing = 0.5;
};

Solve steady_solve(const std::shared_ptr<const Problem>& problem, const SteadyEntry& scheme,
                   const Alignment& edges, const Basis& basis, double step_ratio,
                   Solver::Type type) {
  return [=, &scheme](Index elements) {
    const Grid grid({.half_width = problem->bound.half_width(),
                     .elements = elements,
                     .leading_offset = edges.leading,
                     .trailing_offset = edges.trailing});
    std::vector<SteadySolution> solutions;
    for (const Truth& truth : problem->truths) {
      solutions.push_back(solve_steady(solved_by(scheme,
                                                 {.kernel = problem->kernel,
                                                  .bound = problem->bound,
                                                  .grid = grid,
                                                  .basis = basis,
                                                  .load = PrescribedCreepage{truth.creepage},
                                                  .solver = {.type = type}},
                                                 step_ratio)));
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
      solutions.push_back(ChebyshevRolling(problem->kernel, problem->bound, unknowns)
                              .solve(PrescribedCreepage{truth.creepage}));
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

/// All schemes and functions of the catalogue, in the order in which they always stood.
void add_problem(const SpeedAccuracyParameters& p, const std::shared_ptr<const Problem>& problem,
                 const std::vector<double>& step_ratios, std::vector<RunSeries>& all) {
  const auto loads = static_cast<double>(problem->truths.size());
  const auto add_smooth = [&](std::string_view name, const std::vector<Index>& sizes,
                              const Solve& solve) {
    all.push_back({{problem->name, std::string(name), "none", "none", not_given, "none"},
                   sizes,
                   p.steady.limit,
                   loads,
                   solve});
  };
  const auto add = [&](const SteadyEntry& scheme, std::string_view functions, double c,
                       Solver::Type type) {
    const std::string name(scheme.name), basis(functions);
    const std::string shown = scheme.basis.empty() ? basis : name + " " + basis;
    all.push_back({{problem->name, "collocation", name, shown, c, name_of(type)},
                   p.sizes,
                   p.steady.limit,
                   loads,
                   steady_solve(problem, scheme, {}, make_basis(basis), c, type)});
  };
  const auto add_aligned = [&](std::string_view functions, Solver::Type type) {
    // Where a difference over one element feels it, and the midpoint rule the trailing one.
    constexpr double trailing = 0.656936;
    const Basis basis = make_basis(functions);
    all.push_back({{problem->name, "collocation", "aligned", basis.name(), 1, name_of(type)},
                   p.sizes,
                   p.steady.limit,
                   loads,
                   steady_solve(problem, steady_scheme("standard"),
                                {leading_edge_constants(basis).offset, trailing}, basis, 1, type)});
  };
  const auto with_steps = [](const SteadyEntry& scheme) { return scheme.safe_steps.has_value(); };
  for (const SteadyEntry& scheme : steady_schemes()) {
    if (scheme.by_elements || scheme.name == "chebyshev") continue;
    add_smooth(scheme.name, {p.sizes.front()},
               steady_solve(problem, scheme, {}, constant_basis(), 1, Solver::Type::automatic));
  }
  for (const auto type : {Solver::Type::dense, Solver::Type::fft}) {
    for (const std::string_view basis : basis_names()) {
      for (const SteadyEntry& scheme : steady_schemes()) {
        if (scheme.by_elements && !with_steps(scheme)) add(scheme, basis, not_given, type);
      }
      if (basis == "constant" || basis == "linear") add_aligned(basis, type);
      for (const double c : step_ratios) {
        for (const SteadyEntry& scheme : steady_schemes()) {
          if (with_steps(scheme) && scheme.basis.empty()) add(scheme, basis, c, type);
        }
      }
    }
    for (const double c : step_ratios) {
      for (const SteadyEntry& scheme : steady_schemes()) {
        if (!scheme.basis.empty()) add(scheme, scheme.basis, c, type);
      }
    }
  }
  add_smooth("chebyshev", p.steady.unknowns, chebyshev_solve(problem));
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

}  // namespace microslip::experiments::speed_accuracy_study
