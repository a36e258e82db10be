// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>

#include "campaign.hpp"
#include "microslip/halfspace/leading_edge.hpp"
#include "microslip/rolling/schemes.hpp"
#include "speed_accuracy_problems.hpp"

namespace microslip::experiments::speed_accuracy_study {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Tractions that are functions of the position are sampled at so many places.
constexpr Index samples = 1023;

/// One kernel and bound under several loads.
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
  for (const double stick_ratio : p.stick_ratios) {
    truths.push_back(truth_of(reference, p.bound.half_width(), stick_ratio));
  }
  return std::make_shared<const Problem>(Problem{std::move(name), kernel, p.bound, truths});
}

/// Raises the errors to the errors of one more load, where these are larger.
void judge(const Truth& truth, double force, double spacing, const VectorXd& x,
           const VectorXd& traction, Errors& errors) {
  const VectorXd difference = traction - truth.at(x);
  const auto raise = [&](Quantity of, double error) {
    errors[of] = std::fmax(errors[of], error / std::abs(truth.force));
  };
  raise(Quantity::force, std::abs(force - truth.force));
  raise(Quantity::traction, spacing * difference.lpNorm<1>());
}

/// A scheme of the catalogue that takes part, with its basis and grid.
struct Entrant {
  std::string_view edge;  ///< as written into tables
  const SteadyEntry* scheme;
  std::string_view basis;
  double step_ratio;
  double leading_offset = 0.5;
  double trailing_offset = 0.5;
};

Solve steady_solve(const std::shared_ptr<const Problem>& problem, const Entrant& entrant,
                   Solver::Type type) {
  return [=](Index elements) {
    const Grid grid({.half_width = problem->bound.half_width(),
                     .elements = elements,
                     .leading_offset = entrant.leading_offset,
                     .trailing_offset = entrant.trailing_offset});
    std::vector<SteadySolution> solutions;
    for (const Truth& truth : problem->truths) {
      solutions.push_back(solve_steady(solved_by(*entrant.scheme,
                                                 {.contact = {problem->kernel, problem->bound},
                                                  .grid = grid,
                                                  .basis = make_basis(entrant.basis),
                                                  .load = PrescribedCreepage{truth.creepage},
                                                  .solver = {.type = type}},
                                                 entrant.step_ratio)));
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

/// Solves by Chebyshev collocation with N unknowns.
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

/// Aligns the grid: the edges lie where a difference over one element feels the leading edge, and
/// the midpoint rule the trailing edge.
Entrant aligned(std::string_view basis) {
  return {.edge = "aligned",
          .scheme = &steady_scheme("standard"),
          .basis = basis,
          .step_ratio = 1,
          .leading_offset = leading_edge_constants(make_basis(basis)).offset,
          .trailing_offset = 0.656936};
}

/// Lists all schemes that solve by elements, from the catalogues of schemes and bases.
std::vector<Entrant> entrants(const std::vector<double>& step_ratios) {
  std::vector<Entrant> all;
  const auto add = [&](std::string_view basis, double c, const auto& accepts) {
    for (const SteadyEntry& scheme : steady_schemes()) {
      if (scheme.by_elements && accepts(scheme)) all.push_back({scheme.name, &scheme, basis, c});
    }
  };
  for (const std::string_view basis : basis_names()) {
    add(basis, not_given, [](const SteadyEntry& s) { return !s.safe_steps; });
    if (basis == "constant" || basis == "linear") all.push_back(aligned(basis));
    for (const double c : step_ratios) {
      add(basis, c, [](const SteadyEntry& s) { return s.safe_steps && s.basis.empty(); });
    }
  }
  for (const std::string_view basis : basis_names()) {
    for (const double c : step_ratios) {
      add(basis, c, [=](const SteadyEntry& s) { return s.safe_steps && s.basis == basis; });
    }
  }
  return all;
}

void add_problem(const SpeedAccuracyParameters& p, const std::shared_ptr<const Problem>& problem,
                 const std::vector<double>& step_ratios, std::vector<RunSeries>& all) {
  const auto loads = static_cast<double>(problem->truths.size());
  const auto add = [&](const Contestant& who, const std::vector<Index>& sizes, const Solve& solve) {
    all.push_back({who, sizes, p.steady_operations, loads, solve});
  };
  for (const SteadyEntry& scheme : steady_schemes()) {
    if (scheme.by_elements || scheme.name == "chebyshev") continue;
    const std::string name(scheme.name);
    add({problem->name, name, "none", "none", not_given, "none"}, {p.sizes.front()},
        steady_solve(problem, {"none", &scheme, "constant", 1}, Solver::Type::automatic));
  }
  for (const auto type : {Solver::Type::dense, Solver::Type::fft}) {
    for (const Entrant& entrant : entrants(step_ratios)) {
      const std::string edge(entrant.edge), basis(entrant.basis);
      const std::string shown = entrant.scheme->basis.empty() ? basis : edge + " " + basis;
      add({problem->name, "collocation", edge, shown, entrant.step_ratio, name_of(type)}, p.sizes,
          steady_solve(problem, entrant, type));
    }
  }
  add({problem->name, "chebyshev", "none", "none", not_given, "none"}, p.unknowns,
      chebyshev_solve(problem));
}

}  // namespace

std::vector<RunSeries> steady_contest(const SpeedAccuracyParameters& p) {
  std::vector<RunSeries> all;
  add_problem(p, make_problem(p, "plane", PlaneKernel(p.material, p.length)), p.step_ratios, all);
  add_problem(p, make_problem(p, "strip", StripKernel(p.material, p.width)),
              {p.step_ratios.front()}, all);
  return all;
}

}  // namespace microslip::experiments::speed_accuracy_study
