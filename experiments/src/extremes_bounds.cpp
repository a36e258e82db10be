// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>
#include <stdexcept>

#include "extremes_cases.hpp"
#include "microslip/friction/rough_bound.hpp"
#include "microslip/rolling/inverted_rolling.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip::experiments::extremes_study {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Hertz's bound in 201 rows, each 30 % too high or too low.
TractionBound noisy_bound(const HertzBound& hertz) {
  constexpr Index rows = 201;
  constexpr double share = 0.3;
  const double a = hertz.half_width();
  const VectorXd x = VectorXd::LinSpaced(rows, -a, a);
  VectorXd values(rows);
  for (Index i = 0; i < rows; ++i) {
    const double place = std::fmod(static_cast<double>(i) * std::sqrt(2.0), 1.0);
    values[i] = hertz(x[i]) * (place < 0.5 ? 1 - share : 1 + share);
  }
  return TabulatedBound(a, x, values);
}

TractionBound table_of(double half_width, const VectorXd& places, const VectorXd& values) {
  return TabulatedBound(half_width, half_width * places, values);
}

/// Lists bounds in the order of the coordinate `bound`.
std::vector<TractionBound> bounds(const HertzBound& hertz) {
  const double a = hertz.half_width();
  const double peak = hertz.peak();
  const auto rough = [&](double amplitude) {
    return rough_bound(hertz, {.amplitude = amplitude, .hurst = 0.3, .rows = 1025});
  };
  return {noisy_bound(hertz),
          table_of(a, Eigen::Vector2d(-1, 1), peak * Eigen::Vector2d(0.5, 1)),
          table_of(a, Eigen::Vector4d(-1, 0, 1e-3, 1), peak * Eigen::Vector4d(0.5, 0.5, 1, 0)),
          PolynomialBound(a, peak, Eigen::Vector3d(0.05, 0, 1)),
          rough(0.5),
          rough(1.5)};
}

/// Returns the creepage: by inversion with finer quadratures, or by so many elements that four
/// digits are right.
double truth_of(const SteadyProblem& problem) {
  constexpr double finer = 2;
  constexpr Index elements = 8001;
  try {
    const InvertedSolution found =
        InvertedRolling(problem.contact.kernel, problem.contact.bound, finer).solve(problem.load);
    if (found.keeps_conditions()) return found.creepage();
  } catch (const NotConverged&) {
  }
  return creepage_by_elements(problem, elements);
}

Finding solve(const SteadyProblem& problem, double truth) {
  const SteadySolution found = solve_steady(problem);
  return finding_of(found, std::abs(found.creepage / truth - 1));
}

}  // namespace

Map bounds_map(const ExtremesParameters& p) {
  // Rounding is the error that the tolerance of the solver leaves with many elements.
  Map map{
      "bounds",
      "steady rolling in plane strain, bounds that are not smooth, under small and large forces",
      {{"bound", "1",
        "1 noisy (30 %), 2 finite at both edges, 3 with a jump, 4 with two humps: two stick "
        "zones, 5 rough at all scales (50 %), 6 the same (150 %), zero in places"},
       {"load", "1", "force over full sliding"}},
      {1, 0.5},
      {},
      1e-10};
  const Kernel kernel = PlaneKernel(p.material, p.length);
  const std::vector<std::string_view> schemes{"standard", "calibrated", "inversion"};
  double kind = 0;
  for (const TractionBound& bound : bounds(p.bound)) {
    ++kind;
    for (const double part : p.bound_loads) {
      const SteadyProblem contact{
          .contact = {kernel, bound},
          .grid = Grid({.half_width = p.bound.half_width(), .elements = p.elements}),
          .load = PrescribedForce{-part * full_sliding_force(bound)}};
      const auto truth = std::make_shared<const double>(truth_of(contact));
      for (const std::string_view scheme : schemes) {
        const SteadyProblem problem = solved_by(steady_scheme(scheme), contact);
        map.cases.push_back({.scheme = std::string(scheme),
                             .place = {kind, part},
                             .size = static_cast<double>(p.elements),
                             .solve = [=] { return solve(problem, *truth); }});
      }
    }
  }
  return map;
}

}  // namespace microslip::experiments::extremes_study
