// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "extremes_cases.hpp"
#include "microslip/reference/brush.hpp"
#include "microslip/reference/carter.hpp"
#include "microslip/rolling/schemes.hpp"

namespace microslip::experiments::extremes_study {

namespace {

using Eigen::Index;

SteadyProblem problem_of(const ExtremesParameters& p, const Kernel& kernel, double force_ratio) {
  return {.contact = {kernel, p.bound},
          .grid = Grid({.half_width = p.bound.half_width(), .elements = p.elements}),
          .load = PrescribedForce{-force_ratio * p.bound.total()}};
}

/// The creepage, and the size to which errors are relative.
struct Creepage {
  double exact;
  double scale;
};

Case case_of(const ExtremesParameters& p, std::string_view scheme, const SteadyProblem& problem,
             const std::shared_ptr<const Creepage>& truth, std::vector<double> place) {
  return {.scheme = std::string(scheme),
          .place = std::move(place),
          .size = static_cast<double>(p.elements),
          .solve = [=, solved = solved_by(steady_scheme(scheme), problem)]() -> Finding {
            const SteadySolution found = solve_steady(solved);
            return finding_of(found, std::abs(found.creepage - truth->exact) / truth->scale);
          }};
}

/// Returns the creepage under a force in (0, full sliding).
double brush_creepage(const Brush& brush, double force) {
  constexpr double guess = 0.1, factor = 8;
  std::uintmax_t iterations = 200;
  const auto ends = boost::math::tools::bracket_and_solve_root(
      [&](double creepage) { return -brush.force(creepage) - force; }, guess, factor, true,
      boost::math::tools::eps_tolerance<double>(50), iterations);
  return (ends.first + ends.second) / 2;
}

/// Returns the creepage by so many elements that four digits are right.
double by_fine_elements(const SteadyProblem& problem) {
  constexpr Index finer = 41;
  return creepage_by_elements(problem, finer * problem.grid.size());
}

/// Under a layer this many times as compliant as the half-space, the half-space changes the
/// creepage by less than 1e-7, and the closed form of springs alone is the truth.
constexpr double springs_alone = 1e8;

Creepage under_springs(const ExtremesParameters& p, const SteadyProblem& problem, double layer) {
  const double force = std::abs(std::get<PrescribedForce>(problem.load).value);
  const double exact =
      layer >= springs_alone
          ? brush_creepage(Brush(problem.contact.kernel.layer_compliance(), p.bound), force)
          : by_fine_elements(problem);
  return {exact, exact};
}

Creepage of_unlike_bodies(const ExtremesParameters& p, const SteadyProblem& problem) {
  const SteadySolution inverted = solve_steady(solved_by(steady_scheme("inversion"), problem));
  const double exact =
      inverted.scheme == SteadyScheme::inversion ? inverted.creepage : by_fine_elements(problem);
  const double force = std::abs(std::get<PrescribedForce>(problem.load).value);
  const double of_like = Carter::from_force(p.material, p.bound, force).creepage();
  return {exact, std::max(std::abs(exact), std::abs(of_like))};
}

}  // namespace

Map kernels_map(const ExtremesParameters& p) {
  Map map{
      "kernels",
      "steady rolling of a half-space in plane strain under a layer of springs, from no layer to "
      "springs alone",
      {{"layer", "1", "compliance of the layer over 2 (1 - nu) a/G"},
       {"load", "1", "force over full sliding"}},
      {1, 0.5},
      {}};
  const double unit = compliance(p.material) * p.bound.half_width();
  for (const double layer : p.layers) {
    const Kernel kernel = LayeredKernel(PlaneKernel(p.material, p.length), layer * unit);
    for (const double part : p.kernel_loads) {
      const SteadyProblem problem = problem_of(p, kernel, part);
      const auto truth = std::make_shared<const Creepage>(under_springs(p, problem, layer));
      for (const std::string_view scheme : {"standard", "calibrated"}) {
        map.cases.push_back(case_of(p, scheme, problem, truth, {layer, part}));
      }
    }
  }
  return map;
}

Map bodies_map(const ExtremesParameters& p) {
  Map map{
      "bodies",
      "steady rolling of bodies of different material in plane strain; errors are relative to "
      "the larger of the creepage and the creepage of like bodies",
      {{"beta_over_mu", "1", "beta/mu"}, {"load", "1", "force over full sliding, with its sign"}},
      {1, 0.5},
      {}};
  const Kernel kernel = PlaneKernel(p.material, p.length);
  std::vector<double> loads{0};
  for (const double part : p.kernel_loads) loads.insert(loads.end(), {-part, part});
  std::ranges::sort(loads);
  for (const double strain : p.strains) {
    for (const double part : loads) {
      SteadyProblem problem = problem_of(p, kernel, part);
      problem.contact.pressure_strain = strain * compliance(p.material);
      const auto truth = std::make_shared<const Creepage>(of_unlike_bodies(p, problem));
      for (const std::string_view scheme : {"standard", "calibrated"}) {
        map.cases.push_back(case_of(p, scheme, problem, truth, {strain, part}));
      }
    }
  }
  return map;
}

}  // namespace microslip::experiments::extremes_study
