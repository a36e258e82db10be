// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "extremes_cases.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::experiments::extremes_study {

namespace {

using Eigen::VectorXd;

/// Factors by which quantities with a unit are scaled.
struct Scale {
  double modulus = 1;
  double length = 1;
  double traction = 1;
};

/// A result without units: tractions over the peak, and creepage times G over it.
using Solve = std::function<VectorXd(const ExtremesParameters& p, const Scale& scale)>;

struct ScaledScheme {
  std::string name;
  Solve solve;
};

struct Scaled {
  Material material;
  HertzBound bound;
  Kernel plane;
  Kernel strip;
  Grid grid;
  double force;
};

Scaled scaled(const ExtremesParameters& p, const Scale& scale) {
  const Material material{p.material.shear_modulus * scale.modulus, p.material.poisson_ratio};
  const double a = p.bound.half_width() * scale.length;
  const HertzBound bound(a, p.bound.peak() * scale.traction);
  return {.material = material,
          .bound = bound,
          .plane = PlaneKernel(material, p.length * scale.length),
          .strip = StripKernel(material, 2 * a),
          .grid = Grid({.half_width = a, .elements = p.elements}),
          .force = -bound.total() * (1 - p.stick_ratio) * (1 + p.stick_ratio)};
}

VectorXd without_units(const Scaled& from, const VectorXd& traction, double creepage) {
  VectorXd values(traction.size() + 1);
  const double peak = from.bound.peak();
  values << traction / peak, creepage * (from.material.shear_modulus / peak);
  return values;
}

ScaledScheme steady(const std::string& name, const std::string& in_tables, bool strip,
                    double step_ratio = 1) {
  return {in_tables, [=, method = steady_scheme(name).method(step_ratio)](
                         const ExtremesParameters& p, const Scale& scale) {
            const Scaled from = scaled(p, scale);
            const SteadySolution found =
                solve_steady({.contact = {strip ? from.strip : from.plane, from.bound},
                              .grid = from.grid,
                              .method = method,
                              .load = PrescribedForce{from.force}});
            return without_units(from, found.traction, found.creepage);
          }};
}

/// Rolls in steps that do not divide an element.
ScaledScheme transient(const std::string& name) {
  return {name, [=, scheme = advection_scheme(name).scheme(1)](const ExtremesParameters& p,
                                                               const Scale& scale) {
            const Scaled from = scaled(p, scale);
            TransientRolling rolling({.contact = {from.plane, from.bound},
                                      .grid = from.grid,
                                      .basis = constant_basis(),
                                      .scheme = scheme},
                                     CattaneoShift{from.force});
            for (int step = 0; step < 10; ++step) {
              rolling.step(0.3 * from.grid.spacing(), PrescribedForce{from.force});
            }
            return without_units(from, rolling.state().traction, rolling.state().creepage);
          }};
}

}  // namespace

Table scales_table(const ExtremesParameters& p) {
  Table table(
      "scales", "what is left of scale invariance: results without units",
      {{"scheme", "1", "how the case is solved"},
       {"scaled", "1", "shear modulus, length (half-width and kernel), traction, or all"},
       {"factor", "1", "of that"},
       {"deviation", "1",
        "of tractions over the peak and of creepage times G over it from those for a factor "
        "of 1; largest, relative to the largest",
        1e-12}});
  const std::vector<ScaledScheme> schemes{steady("standard", "standard", false),
                                          steady("standard", "standard, c = 0.001", false, 1e-3),
                                          steady("inversion", "inversion", false),
                                          steady("inversion", "inversion strip", true),
                                          steady("chebyshev", "chebyshev strip", true),
                                          transient("direct"),
                                          transient("fractional"),
                                          transient("remembered")};
  for (const ScaledScheme& scheme : schemes) {
    const VectorXd ordinary = scheme.solve(p, {});
    const auto add = [&](const std::string& what, double factor, const Scale& scale) {
      const VectorXd found = scheme.solve(p, scale);
      table.add(
          {scheme.name, what, factor,
           (found - ordinary).lpNorm<Eigen::Infinity>() / ordinary.lpNorm<Eigen::Infinity>()});
    };
    for (const double s : p.scales) {
      add("modulus", s, {.modulus = s});
      add("length", s, {.length = s});
      add("traction", s, {.traction = s});
      add("all", s, {.modulus = s, .length = s, .traction = s});
    }
  }
  return table;
}

}  // namespace microslip::experiments::extremes_study
