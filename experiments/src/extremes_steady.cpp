// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "extremes_cases.hpp"
#include "microslip/reference/carter.hpp"
#include "microslip/rolling/chebyshev_rolling.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/support/interpolation.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip::experiments::extremes_study {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A scheme with a basis.
struct SteadyChoice {
  std::string name;
  const SteadyEntry* entry;
  Basis basis;
};

/// Lists the catalogue without the named schemes: first differences, then the others by their
/// order. The standard scheme takes part with all bases, each other scheme with one.
std::vector<SteadyChoice> schemes_except(const std::vector<std::string>& names) {
  std::vector<SteadyChoice> all;
  const auto add = [&](const SteadyEntry& entry, const Basis& basis, const std::string& name) {
    const bool left_out = std::ranges::find(names, name) != names.end();
    if (!left_out) all.push_back({name, &entry, basis});
  };
  for (const SteadyEntry& entry : steady_schemes()) {
    const std::string name(entry.name);
    add(entry, basis_of(entry), name);
    if (name != "standard") continue;
    for (const std::string_view basis : basis_names()) {
      if (basis == basis_of(entry).name()) continue;
      add(entry, make_basis(basis), fmt::format("{} {}", name, basis));
    }
  }
  const auto rank = [](const SteadyChoice& s) { return s.entry->safe_steps ? 0 : s.entry->order; };
  std::ranges::stable_sort(all, {}, rank);
  return all;
}

struct Setting {
  Kernel kernel;
  HertzBound bound;
  std::shared_ptr<const Truth> truth;
};

/// Sets up plane strain in which the fraction 1 - `sliding` of the contact sticks.
Setting carter_setting(const ExtremesParameters& p, double sliding) {
  const double creepage = compliance(p.material) * p.bound.peak() * sliding;
  const Carter carter = Carter::from_creepage(p.material, p.bound, creepage);
  return {PlaneKernel(p.material, p.length), p.bound,
          std::make_shared<const Truth>(
              Truth{.creepage = creepage,
                    .force = -p.bound.total() * sliding * (2 - sliding),
                    .traction = [carter](double x) { return carter.traction(x); }})};
}

/// Takes the larger value of each error.
Finding worst_of(const Finding& a, const Finding& b) {
  return {.error = std::max(a.error, b.error),
          .wiggle = std::max(a.wiggle, b.wiggle),
          .condition = std::max(a.condition, b.condition),
          .evidence = worst_of(a.evidence, b.evidence),
          .iterations = std::max(a.iterations, b.iterations)};
}

double relative(double value, double exact, double scale) {
  return std::abs(value - exact) / (exact == 0 ? scale : std::abs(exact));
}

Finding solve(const SteadyChoice& scheme, const Setting& setting, const Grid& grid,
              double step_ratio, const Load& load) {
  const SteadySolution found = solve_steady(solved_by(*scheme.entry,
                                                      {.contact = {setting.kernel, setting.bound},
                                                       .grid = grid,
                                                       .basis = scheme.basis,
                                                       .load = load},
                                                      step_ratio));
  const Truth& truth = *setting.truth;
  const bool by_force = Prescribed(load).by_force;
  Finding finding = finding_of(
      found, by_force ? relative(found.creepage, truth.creepage,
                                 compliance(setting.kernel.material()) * setting.bound.peak())
                      : relative(found.force, truth.force, setting.bound.total()));
  finding.wiggle = wiggle_of(found.traction - truth.at(found.x)) / setting.bound.peak();
  return finding;
}

/// Solves under the creepage and under the force; the finding is the worst of both.
Case case_of(const SteadyChoice& scheme, const Setting& setting, const Grid::Parameters& grid,
             double step_ratio, std::vector<double> place) {
  return {.scheme = scheme.name,
          .place = std::move(place),
          .size = static_cast<double>(grid.elements),
          .solve = [=] {
            const Grid nodes(grid);
            const Truth& truth = *setting.truth;
            return worst_of(
                solve(scheme, setting, nodes, step_ratio, PrescribedCreepage{truth.creepage}),
                solve(scheme, setting, nodes, step_ratio, PrescribedForce{truth.force}));
          }};
}

Grid::Parameters grid_of(const ExtremesParameters& p, Index elements) {
  return {.half_width = p.bound.half_width(), .elements = elements};
}

/// Solves the reference for a strip: by Chebyshev collocation if possible, otherwise by the finest
/// elements.
std::shared_ptr<const Truth> strip_truth(const Kernel& kernel, const HertzBound& bound,
                                         const ExtremesParameters& p) {
  const double force = -bound.total() * (1 - p.stick_ratio) * (1 + p.stick_ratio);
  try {
    const auto solution = std::make_shared<const ChebyshevSolution>(
        ChebyshevRolling(kernel, bound).solve(PrescribedForce{force}));
    return std::make_shared<const Truth>(
        Truth{solution->creepage(), force, [=](double x) { return solution->traction(x); }});
  } catch (const std::invalid_argument&) {  // too narrow
  } catch (const NotConverged&) {           // likewise
  }
  SteadyProblem problem{.contact = {kernel, bound},
                        .grid = Grid(grid_of(p, 9 * p.elements)),
                        .load = PrescribedForce{force}};
  const auto truth_of = [&] {
    const SteadySolution found = solve_steady(problem);
    return std::make_shared<const Truth>(
        Truth{found.creepage, force, [x = found.x, traction = found.traction](double at) {
                return interpolated(x, traction, VectorXd::Constant(1, at))[0];
              }});
  };
  try {
    return truth_of();
  } catch (const std::invalid_argument&) {  // still too narrow
    problem.method = Differences{};
    return truth_of();
  }
}

}  // namespace

Map steps_map(const ExtremesParameters& p) {
  Map map{"steps",
          "steady rolling in plane strain, from tiny to huge steps and grids",
          {{"step_ratio", "1", "c = dq/dx; 1 where it has no role"}, {"elements", "1", "N"}},
          {1, static_cast<double>(p.elements)},
          {}};
  const Setting setting = carter_setting(p, 1 - p.stick_ratio);
  const auto add = [&](const SteadyChoice& scheme, double c, const std::vector<Index>& sizes) {
    for (const Index n : sizes) {
      map.cases.push_back(case_of(scheme, setting, grid_of(p, n), c, {c, static_cast<double>(n)}));
      map.cases.back().goes_on = n != sizes.front();
    }
  };
  const auto add_large = [&](const SteadyChoice& scheme, double c) {
    for (const Index n : p.large_sizes) add(scheme, c, {n});
  };
  for (const SteadyChoice& scheme : schemes_except({})) {
    if (!scheme.entry->safe_steps) continue;
    for (const double c : p.step_ratios) add(scheme, c, p.sizes);
  }
  for (const SteadyChoice& scheme :
       schemes_except({"standard quadratic", "known_edge", "trimmed"})) {
    if (!scheme.entry->safe_steps) continue;
    for (const double c : p.large_step_ratios) add_large(scheme, c);
  }
  for (const SteadyChoice& scheme : schemes_except({})) {
    if (scheme.entry->safe_steps) continue;
    add(scheme, 1, p.sizes);
    add_large(scheme, 1);
  }
  return map;
}

Map widths_map(const ExtremesParameters& p) {
  Map map{"widths",
          "steady rolling on strips of any width",
          {{"width", "dx", "strip width"}, {"poisson_ratio", "1", "nu"}},
          {1000, p.material.poisson_ratio},
          {}};
  const double dx = Grid(grid_of(p, p.elements)).spacing();
  for (const double nu : p.poisson_ratios) {
    for (const double width : p.strip_widths) {
      const Kernel kernel = StripKernel({p.material.shear_modulus, nu}, width * dx);
      const Setting setting{kernel, p.bound, strip_truth(kernel, p.bound, p)};
      for (const SteadyChoice& scheme :
           schemes_except({"standard quadratic", "known_edge", "trimmed"})) {
        map.cases.push_back(case_of(scheme, setting, grid_of(p, p.elements), 1, {width, nu}));
      }
    }
  }
  return map;
}

Map loads_map(const ExtremesParameters& p) {
  Map map{"loads",
          "steady rolling in plane strain, from full stick to full sliding",
          {{"stuck", "1", "a', part of the contact that sticks"}, {"sliding", "1", "1 - a'"}},
          {p.stick_ratio, not_given},
          {}};
  const auto add = [&](double stuck, double sliding) {
    const Setting setting = carter_setting(p, sliding);
    for (const SteadyChoice& scheme : schemes_except({"standard quadratic", "trimmed"})) {
      map.cases.push_back(case_of(scheme, setting, grid_of(p, p.elements), 1, {stuck, sliding}));
    }
  };
  for (const double sliding : p.sliding) add(1 - sliding, sliding);
  add(p.stick_ratio, 1 - p.stick_ratio);
  for (const double stuck : p.stick_ratios) add(stuck, 1 - stuck);
  // The quantity that is not prescribed follows from a difference of nearly equal numbers: the load
  // and full sliding, or the edges of stick zone and contact.
  for (const std::vector<double>& parts : {p.sliding, p.stick_ratios}) {
    for (const double part : parts) {
      if (part > 0) map.rounding = std::max(map.rounding, 1e-16 / part);
    }
  }
  return map;
}

Map offsets_map(const ExtremesParameters& p) {
  Map map{"offsets",
          "steady rolling in plane strain, with the edges anywhere within an element",
          {{"leading_offset", "dx", "from the last node to the leading edge"},
           {"trailing_offset", "dx", "from the trailing edge to the first node"}},
          {0.5, 0.5},
          {}};
  const Setting setting = carter_setting(p, 1 - p.stick_ratio);
  for (const SteadyChoice& scheme : schemes_except({"calibrated", "chebyshev"})) {
    for (const double leading : p.offsets) {
      for (const double trailing : p.offsets) {
        Grid::Parameters grid = grid_of(p, p.elements);
        grid.leading_offset = leading;
        grid.trailing_offset = trailing;
        map.cases.push_back(case_of(scheme, setting, grid, 1, {leading, trailing}));
      }
    }
  }
  return map;
}

}  // namespace microslip::experiments::extremes_study
