// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/unlike_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "microslip/experiments/claims.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/convergence.hpp"
#include "study_keys.hpp"
#include "table_values.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Parameters = UnlikeBodiesParameters;

namespace {

/// Creepages of free rolling, over beta a/R_r without slip, over mu a/R_r without friction; they
/// depend on neither L0 nor the scale.
constexpr double without_slip = 2 / std::numbers::pi;
constexpr double without_friction = 2 * 0.457385508786518;  // Bentall and Johnson 1967 print 0.457

/// Results of a Gauss-Chebyshev method for beta/mu = 2.87667: creepage over mu a/R_r, force over
/// full sliding.
struct Known {
  double force_ratio, creepage;
};
constexpr Known known[] = {{0, 2 * 0.372097 * 2.87667}, {0.75, 1.04729}, {-0.75, 2.69428}};

SteadySolution rolled(const Parameters& p, double ratio, double force_ratio, Index elements,
                      const char* scheme = "calibrated") {
  const Grid grid({.half_width = p.bound.half_width(), .elements = elements});
  const double far = 100 * p.bound.half_width();
  return solve_steady(solved_by(
      steady_scheme(scheme),
      {.contact = {PlaneKernel(p.material, far), p.bound, pressure_strain({p.material, ratio}, 1)},
       .grid = grid,
       .load = PrescribedForce{force_ratio * full_sliding_force(p.bound)}}));
}

/// Returns mu a/R, the combined compliance times the peak of the bound.
double unit_of(const Parameters& p) { return compliance(p.material) * p.bound.peak(); }

/// Adds a row for each zone.
void add_zones(Table& table, const char* of, double value, const Parameters& p,
               const SteadySolution& solution) {
  const Index n = solution.x.size();
  const double a = p.bound.half_width();
  const auto zone = [&](Index i) { return solution.zones[static_cast<std::size_t>(i)]; };
  double begin = -a;
  for (Index i = 0; i < n; ++i) {
    if (i + 1 < n && zone(i + 1) == zone(i)) continue;
    const double end = i + 1 < n ? (solution.x[i] + solution.x[i + 1]) / 2 : a;
    table.add({of, value, begin / a, end / a, static_cast<double>(zone(i))});
    begin = end;
  }
}

struct Curves {
  Table free{"free",
             "creepage of free rolling against beta/mu",
             {{"ratio", "1", "beta/mu"},
              {"creepage", "1", "w over beta a/R; 2/pi without slip, 0.9148 without friction"},
              {"dissipation", "1", "energy lost per mm, over full sliding times beta a/R", 1e-12},
              {"zones", "1", "number of zones of stick and slip"}}};
  Table tractive{"tractive",
                 "creepage against the force",
                 {{"ratio", "1", "beta/mu"},
                  {"force_ratio", "1", "F over full sliding"},
                  {"creepage", "1", "w over mu a/R"},
                  {"alike", "1", "the same of bodies of one material: Carter's"}}};
  Table zones{"zones",
              "zones of stick and slip, from the trailing to the leading edge",
              {{"of", "1", "free: against beta/mu; tractive: against the force"},
               {"value", "1", "beta/mu, or F over full sliding"},
               {"begin", "1", "x/a"},
               {"end", "1", "x/a"},
               {"zone", "1", "0 sticks; else the sign of the traction where bodies slip"}}};
};

Curves curves_of(const Parameters& p, const Progress& progress) {
  Curves curves;
  const double unit = unit_of(p);
  const std::size_t total = static_cast<std::size_t>(p.free_points) +
                            p.ratios.size() * static_cast<std::size_t>(p.tractive_points);
  std::size_t done = 0;
  for (int i = 0; i < p.free_points; ++i) {
    const double ratio = log_spaced(p.smallest, p.largest, i, p.free_points);
    const SteadySolution solution = rolled(p, ratio, 0, p.elements);
    const std::size_t before = curves.zones.rows();
    add_zones(curves.zones, "free", ratio, p, solution);
    curves.free.add({ratio, solution.creepage / (ratio * unit),
                     solution.dissipation / (full_sliding_force(p.bound) * ratio * unit),
                     curves.zones.rows() - before});
    progress(++done, total);
  }
  constexpr double most = 0.95;
  for (const double ratio : p.ratios) {
    for (int i = 0; i < p.tractive_points; ++i) {
      const double force = most * (2.0 * i / (p.tractive_points - 1) - 1);
      const SteadySolution solution = rolled(p, ratio, force, p.elements);
      if (ratio == p.zones_ratio) add_zones(curves.zones, "tractive", force, p, solution);
      const double alike = std::copysign(1 - std::sqrt(1 - std::abs(force)), -force);
      curves.tractive.add({ratio, force, solution.creepage / unit, alike});
      progress(++done, total);
    }
  }
  return curves;
}

struct Errors {
  Table errors{"errors",
               "error of the creepage against the number of elements, at tractive.zones_of",
               {{"scheme", "1", "leading_edge: calibrated or standard"},
                {"force_ratio", "1", "F over full sliding"},
                {"elements", "1", "N"},
                {"creepage", "1", "w over mu a/R"},
                {"error", "1", "the same less that by inversion", 1e-9}}};
  Table orders{"orders",
               "fitted orders in dx",
               {{"scheme", "1", "leading_edge"},
                {"force_ratio", "1", "F over full sliding"},
                {"exact", "1", "w over mu a/R by inversion"},
                {"order", "1", "least-squares slope"}}};
};

Errors errors_of(const Parameters& p) {
  Errors found;
  const double unit = unit_of(p);
  for (const auto& [force_ratio, expected] : known) {
    const double exact =
        rolled(p, p.zones_ratio, force_ratio, p.elements, "inversion").creepage / unit;
    for (const char* scheme : {"calibrated", "standard"}) {
      std::vector<double> sizes, errors;
      for (const Index n : p.sizes) {
        const double creepage = rolled(p, p.zones_ratio, force_ratio, n, scheme).creepage / unit;
        sizes.push_back(static_cast<double>(n));
        errors.push_back(std::abs(creepage - exact));
        found.errors.add({scheme, force_ratio, sizes.back(), creepage, creepage - exact});
      }
      found.orders.add({scheme, force_ratio, exact, fitted_order(sizes, errors)});
    }
  }
  return found;
}

/// Returns the largest relative difference from the known results.
double from_known(const Errors& found) {
  double largest = 0;
  for (const auto& [force_ratio, expected] : known) {
    const double exact = found.orders.latest({{"force_ratio", force_ratio}}, "exact");
    largest = std::max(largest, std::abs(exact / expected - 1));
  }
  return largest;
}

Table claims_of(const Parameters& p, const Curves& curves, const Errors& found) {
  const double stuck = curves.free.number(0, "creepage");
  const double sliding = rolled(p, 1e5, 0, p.elements, "inversion").creepage / (1e5 * unit_of(p));
  const auto order = [&](const char* scheme) {
    return found.orders.latest({{"scheme", scheme}, {"force_ratio", 0.0}}, "order");
  };
  // Bentall and Johnson print this for aluminium on steel: a = 0.1 mm, R = 25 mm, mu = 0.05.
  const double printed =
      rolled(p, 2.87667, 0, 200, "standard").creepage / unit_of(p) * 0.05 * 0.1 / 25;
  return claims_table(
      {{"bodies of different material creep in free rolling, without slip, too", "none", not_given,
        stuck / without_slip, "1", ours_if({between(0.99, 1.01)}),
        "creepage at the smallest beta/mu over (2/pi) beta a/R", "unlike_bodies_creepage"},
       {"with next to no friction they creep as Bentall and Johnson (1967) say", "none", not_given,
        sliding / without_friction, "1", ours_if({between(0.999999, 1.000001)}),
        "creepage at beta/mu = 1e5 over 0.914771 beta a/R, by inversion", "unlike_bodies_creepage"},
       {"partial slip agrees with a Gauss-Chebyshev method", "none", not_given, from_known(found),
        "1", ours_if({below(4e-5)}),
        "largest relative difference of the creepage by inversion, free and with 3/4 of full "
        "sliding",
        "unlike_bodies_error"},
       {"calibrated elements are of second order", "none", 2, order("calibrated"), "1",
        ours_if({above(1.7)}), "free rolling", "unlike_bodies_error"},
       {"the scheme of CONTACT is of first order", "none", 1, order("standard"), "1",
        ours_if({between(0.8, 1.2)}), "free rolling", "unlike_bodies_error"},
       {"its creepage of aluminium on steel is what CONTACT prints", "none", not_given, printed,
        "1", ours_if({between(4.290e-4, 4.298e-4)}),
        "by leading_edge standard with N = 200; exact is 4.2816e-4, and CONTACT prints 4.294e-4",
        no_figure}});
}

}  // namespace

UnlikeBodiesParameters read_unlike_bodies(Scene& scene) {
  using P = UnlikeBodiesParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::elements, "grid.elements"},
       {&P::smallest, "free.smallest", "least beta/mu of free rolling", range(1e-3, 1)},
       {&P::largest, "free.largest", "largest", range(1.5, 1e5)},
       {&P::free_points, "free.points", "number of ratios, evenly spaced in their logarithms",
        range(2, 10000)},
       {&P::ratios, "tractive.beta_over_mu", "beta/mu of tractive rolling", range(1e-3, 1e5)},
       {&P::zones_ratio, "tractive.zones_of", "beta/mu of zones and errors, one of those",
        range(1e-3, 1e5)},
       {&P::tractive_points, "tractive.points", "forces from -0.95 to 0.95 of full sliding",
        range(2, 10000)},
       {&P::sizes, "error.sizes", "numbers N of nodes", range(11, 100000), two_or_more_rising}});
  P p = keys.read({.material = read_material(scene), .bound = read_hertz_bound(scene)});
  require(p.elements >= 11 && p.elements <= 1000000, "grid.elements",
          static_cast<double>(p.elements), "a whole number from 11 to 1000000");
  return p;
}

std::vector<Table> unlike_bodies(const UnlikeBodiesParameters& p, const Progress& progress) {
  const Curves curves = curves_of(p, progress);
  const Errors found = errors_of(p);
  return {curves.free,  curves.tractive, curves.zones,
          found.errors, found.orders,    claims_of(p, curves, found)};
}

}  // namespace microslip::experiments
