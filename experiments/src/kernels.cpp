// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/kernels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "campaign.hpp"
#include "microslip/experiments/claims.hpp"
#include "microslip/halfspace/leading_edge.hpp"
#include "microslip/reference/brush.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/convergence.hpp"
#include "study_keys.hpp"
#include "table_values.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Parameters = KernelsParameters;

namespace {

constexpr double springs_alone = std::numeric_limits<double>::infinity();

/// A kernel and its name.
struct Yielding {
  std::string name;  ///< half-space, layer or brush
  double softness;   ///< 0 of the half-space, inf of the brush
  Kernel kernel;
};

Yielding yielding(const Parameters& p, double softness) {
  const double unit = compliance(p.material) * p.bound.half_width();
  if (softness == springs_alone) return {"brush", softness, WinklerKernel(unit)};
  const PlaneKernel plane(p.material, p.length);
  if (softness == 0) return {"half-space", 0, plane};
  return {"layer", softness, LayeredKernel(plane, softness * unit)};
}

std::vector<Yielding> all_kernels(const Parameters& p) {
  std::vector<Yielding> kernels{yielding(p, 0)};
  for (const double softness : p.softness) kernels.push_back(yielding(p, softness));
  kernels.push_back(yielding(p, springs_alone));
  return kernels;
}

double sliding_force(const Parameters& p) { return full_sliding_force(p.bound); }

SteadyProblem contact_of(const Parameters& p, const Kernel& kernel, Index elements,
                         const Load& load) {
  return {.contact = {kernel, p.bound},
          .grid = Grid({.half_width = p.bound.half_width(), .elements = elements}),
          .load = load};
}

SteadySolution rolled(const Parameters& p, const Kernel& kernel, Index elements, const Load& load,
                      const char* scheme = "calibrated", double step_ratio = 1) {
  return solve_steady(
      solved_by(steady_scheme(scheme), contact_of(p, kernel, elements, load), step_ratio));
}

/// |dF/dw| where next to nothing slips  [N/mm]
double slope_of(const Parameters& p, const Kernel& kernel) {
  const double creepage =
      1e-6 * (compliance(p.material) + kernel.layer_compliance() / p.bound.half_width()) *
      p.bound.peak();
  return -rolled(p, kernel, p.elements, PrescribedCreepage{creepage}).force / creepage;
}

struct Curves {
  Table curves{"curves",
               "force against creepage, over the creepage that would slide without slip before",
               {{"kernel", "1", "half-space, layer or brush"},
                {"softness", "1", "C over 2 (1 - nu)/G a; inf without the half-space"},
                {"creepage", "1", "w |dF/dw| at w = 0 over the force of full sliding"},
                {"force_ratio", "1", "-F over full sliding"},
                {"exact", "1", "by Carter or of a brush; nan of layers"}}};
  Table slopes{"slopes",
               "how soft contacts are",
               {{"kernel", "1", "half-space, layer or brush"},
                {"softness", "1", "C over 2 (1 - nu)/G a"},
                {"slope", "1", "|dF/dw| at w = 0 over the slope of the half-space"}}};
};

double exact_force_ratio(const Parameters& p, const Yielding& of, double creepage) {
  if (of.name == "layer") return not_given;
  const double force = of.name == "brush"
                           ? Brush(of.kernel.layer_compliance(), p.bound).force(creepage)
                           : Carter::from_creepage(p.material, p.bound, creepage).force();
  return -force / sliding_force(p);
}

Curves curves_of(const Parameters& p) {
  constexpr double largest = 4;
  Curves found;
  const std::vector<Yielding> kernels = all_kernels(p);
  const double stiffest = slope_of(p, kernels.front().kernel);
  for (const Yielding& of : kernels) {
    const double slope = slope_of(p, of.kernel);
    found.slopes.add({of.name, of.softness, slope / stiffest});
    for (int i = 1; i <= p.points; ++i) {
      const double creepage = largest * i / p.points;
      const double w = creepage * sliding_force(p) / slope;
      const double force = rolled(p, of.kernel, p.elements, PrescribedCreepage{w}).force;
      found.curves.add(
          {of.name, of.softness, creepage, -force / sliding_force(p), exact_force_ratio(p, of, w)});
    }
  }
  return found;
}

/// The larger amplitude of an even and of an odd number of elements.
double largest_wiggle(const Parameters& p, const Kernel& kernel, double step_ratio) {
  double largest = 0;
  for (Index more = 0; more < 4; ++more) {
    const SteadySolution solution =
        rolled(p, kernel, p.noise_elements + more,
               PrescribedForce{-p.force_ratio * sliding_force(p)}, "standard", step_ratio);
    largest = std::max(largest, wiggle_of(solution.traction / p.bound.peak()));
  }
  return largest;
}

Table noise_of(const Parameters& p) {
  Table noise("noise", "wiggles of the tractions by leading_edge standard against the step",
              {{"kernel", "1", "half-space, layer or brush"},
               {"softness", "1", "C over 2 (1 - nu)/G a"},
               {"element_softness", "1", "C over 2 (1 - nu)/G dx"},
               {"step_ratio", "1", "c"},
               {"wiggle", "1",
                "amplitude where tractions alternate over four nodes or more, over the peak of the "
                "bound; the largest of four numbers of elements",
                1e-12}});
  for (const Yielding& of : all_kernels(p)) {
    for (int i = 0; i < p.noise_points; ++i) {
      const double step_ratio = log_spaced(p.noise_step, 1.0, i, p.noise_points);
      noise.add({of.name, of.softness, of.softness * static_cast<double>(p.noise_elements) / 2,
                 step_ratio, largest_wiggle(p, of.kernel, step_ratio)});
    }
  }
  return noise;
}

/// Distance of the leading edge from the last node for which a contact without slip has this slope
/// of the force; the trailing edge is half an element nearer to the first one.
double measured_offset(const Parameters& p, const Kernel& kernel, Index elements, double slope) {
  const double creepage = 1e-9 * p.bound.peak() * compliance(p.material);
  const auto excess = [&](double offset) {
    SteadyProblem problem = contact_of(p, kernel, elements, PrescribedCreepage{creepage});
    problem.grid = Grid({.half_width = p.bound.half_width(),
                         .elements = elements,
                         .leading_offset = offset,
                         .trailing_offset = offset - 0.5});
    problem.method = Differences{.mean_bounds = true};
    return -solve_steady(problem).force / creepage - slope;
  };
  double before = 0.7, now = 1, excess_before = excess(before);
  for (int i = 0; i < 8; ++i) {
    const double excess_now = excess(now);
    if (excess_now == excess_before) break;
    const double next = now - excess_now * (now - before) / (excess_now - excess_before);
    before = std::exchange(now, std::clamp(next, 0.5, 1.0));
    excess_before = excess_now;
  }
  return now;
}

Table edges_of(const Parameters& p) {
  constexpr Index elements = 40, finer = 32;
  Table edges("edges", "where differences over one element feel the leading edge",
              {{"element_softness", "1", "C over 2 (1 - nu)/G dx"},
               {"offset", "1", "elements beyond the last node, by Wiener and Hopf"},
               {"measured", "1", "the same, for which the force in adhesion is exact"}});
  for (int i = 0; i < p.edge_points; ++i) {
    const double of_element = log_spaced(1e-3, 1e3, i, p.edge_points);
    const double dx = 2 * p.bound.half_width() / static_cast<double>(elements);
    const Kernel kernel = yielding(p, of_element * dx / p.bound.half_width()).kernel;
    const double creepage = 1e-9 * p.bound.peak() * compliance(p.material);
    const double slope =
        -rolled(p, kernel, finer * elements, PrescribedCreepage{creepage}).force / creepage;
    edges.add({of_element, leading_edge_constants(constant_basis(), of_element).offset,
               measured_offset(p, kernel, elements, slope)});
  }
  return edges;
}

struct Errors {
  Table errors{"errors",
               "error of the force against the number of elements",
               {{"scheme", "1", "leading_edge: calibrated or standard"},
                {"kernel", "1", "half-space, layer or brush"},
                {"softness", "1", "C over 2 (1 - nu)/G a"},
                {"elements", "1", "N"},
                {"error", "1", "root mean square over creepages, over full sliding", 1e-9}}};
  Table orders{"orders",
               "fitted orders in dx",
               {{"scheme", "1", "leading_edge"},
                {"kernel", "1", "half-space, layer or brush"},
                {"softness", "1", "C over 2 (1 - nu)/G a"},
                {"order", "1", "least-squares slope"}}};
};

/// Creepages around the creepage of the force ratio, so that stick-slip points lie anywhere in
/// elements.
std::vector<double> creepages_of(const Parameters& p, const Kernel& kernel) {
  constexpr int count = 8;
  const double middle =
      rolled(p, kernel, p.elements, PrescribedForce{-p.force_ratio * sliding_force(p)}).creepage;
  std::vector<double> creepages;
  for (int i = 0; i < count; ++i) creepages.push_back(middle * (1 + 0.05 * i / count));
  return creepages;
}

Errors errors_of(const Parameters& p) {
  constexpr Index finer = 8;
  Errors found;
  for (const Yielding& of : all_kernels(p)) {
    const std::vector<double> creepages = creepages_of(p, of.kernel);
    std::vector<double> truths;
    for (const double w : creepages) {
      const double exact = exact_force_ratio(p, of, w);
      truths.push_back(
          std::isfinite(exact)
              ? exact
              : -rolled(p, of.kernel, finer * p.sizes.back(), PrescribedCreepage{w}).force /
                    sliding_force(p));
    }
    for (const char* scheme : {"calibrated", "standard"}) {
      std::vector<double> sizes, errors;
      for (const Index n : p.sizes) {
        double squares = 0;
        for (std::size_t i = 0; i < creepages.size(); ++i) {
          const double force =
              rolled(p, of.kernel, n, PrescribedCreepage{creepages[i]}, scheme).force;
          squares += std::pow(-force / sliding_force(p) - truths[i], 2);
        }
        sizes.push_back(static_cast<double>(n));
        errors.push_back(std::sqrt(squares / static_cast<double>(creepages.size())));
        found.errors.add({scheme, of.name, of.softness, sizes.back(), errors.back()});
      }
      found.orders.add({scheme, of.name, of.softness, fitted_order(sizes, errors)});
    }
  }
  return found;
}

Table transients_of(const Parameters& p) {
  Table transients(
      "transients",
      "from a shift under a force to steady rolling under it, by step.scheme remembered",
      {{"kernel", "1", "half-space, layer or brush"},
       {"softness", "1", "C over 2 (1 - nu)/G a"},
       {"distance", "1", "rolled, over the width of the contact"},
       {"creepage", "1", "of a step of two elements, over the creepage of steady rolling"}});
  const double force = -p.force_ratio * sliding_force(p);
  const double a = p.bound.half_width();
  const double dx = 2 * a / static_cast<double>(p.elements);
  for (const Yielding& of : all_kernels(p)) {
    const double steady = rolled(p, of.kernel, p.elements, PrescribedForce{force}).creepage;
    TransientRolling rolling({.contact = {of.kernel, p.bound},
                              .grid = Grid({.half_width = a, .elements = p.elements}),
                              .basis = constant_basis(),
                              .scheme = Remembered{}},
                             CattaneoShift{force});
    for (double distance = 2 * dx; distance < 4 * a; distance += 2 * dx) {
      rolling.step(2 * dx, PrescribedForce{force});
      transients.add(
          {of.name, of.softness, (distance - dx) / (2 * a), rolling.state().creepage / steady});
    }
  }
  return transients;
}

Table claims_of(const Parameters& p, const Curves& curves, const Table& noise, const Table& edges,
                const Errors& found, const Table& transients) {
  const auto is = [](const Table& table, std::size_t i, const char* kernel) {
    return std::get<std::string>(table.at(i, "kernel")) == kernel;
  };
  double from_half_space = 0, from_brush = 0, alternating = 0, misplaced = 0;
  for (std::size_t i = 0; i < curves.curves.rows(); ++i) {
    const double force = curves.curves.number(i, "force_ratio");
    const auto at = i % static_cast<std::size_t>(p.points);
    from_half_space =
        std::max(from_half_space, std::abs(force - curves.curves.number(at, "force_ratio")));
    if (!is(curves.curves, i, "brush")) continue;
    from_brush = std::max(from_brush, std::abs(force - curves.curves.number(i, "exact")));
  }
  for (std::size_t i = 0; i < noise.rows(); ++i) {
    if (noise.number(i, "element_softness") < 1) continue;
    alternating = std::max(alternating, noise.number(i, "wiggle"));
  }
  for (std::size_t i = 0; i < edges.rows(); ++i) {
    misplaced =
        std::max(misplaced, std::abs(edges.number(i, "measured") - edges.number(i, "offset")));
  }
  const double of_half_space = most(noise, "wiggle", {{"kernel", "half-space"}});
  const Cells standard{{"scheme", "standard"}};
  const auto swing = [&](const char* kernel) {
    double largest = 0;
    for (std::size_t i = 0; i < transients.rows(); ++i) {
      if (!is(transients, i, kernel) || transients.number(i, "distance") < 1.5) continue;
      largest = std::max(largest, std::abs(transients.number(i, "creepage") - 1));
    }
    return largest;
  };
  return claims_table(
      {{"over their slope at no creepage, all curves of creepage and force are alike to a tenth",
        "none", not_given, from_half_space, "1", ours_if({below(0.1)}),
        "largest difference from the half-space's, over full sliding", "kernels_curves"},
       {"on springs alone the force is the closed form of the brush model", "none", not_given,
        from_brush, "1", ours_if({below(1e-4)}),
        "largest difference, over full sliding, by leading_edge calibrated", "kernels_curves"},
       {"wiggles at small steps need the half-space", "none", not_given, of_half_space, "1",
        ours_if({above(0.05), {"on layers softer than an element", alternating, below(1e-3)}}),
        "largest amplitude over the peak of the bound, by leading_edge standard", "kernels_noise"},
       {"the leading edge is felt where a layer's symbol says", "none", not_given, misplaced, "1",
        ours_if({below(2e-3)}),
        "largest difference of the measured offset from it, with 40 elements", "kernels_error"},
       {"with the edge where it is felt, the force is of second order on any kernel", "none", 2,
        least(found.orders, "order", {{"scheme", "calibrated"}}), "1", ours_if({above(1.6)}),
        "least fitted order", "kernels_error"},
       {"the scheme of CONTACT is of first order on any kernel", "none", 1,
        most(found.orders, "order", standard), "1",
        ours_if({between(0.8, 1.2),
                 {"the least", least(found.orders, "order", standard), between(0.8, 1.2)}}),
        "largest fitted order", "kernels_error"},
       {"under a force, springs alone come to steady rolling later than a half-space", "none",
        not_given, swing("brush"), "1",
        ours_if({above(0.01), {"on the half-space", swing("half-space"), below(0.005)}}),
        "largest relative difference from the steady creepage, from 1.5 contact widths after a "
        "shift on",
        "kernels_transients"}});
}

}  // namespace

KernelsParameters read_kernels(Scene& scene) {
  using P = KernelsParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::length, "kernel.length"},
       {&P::softness, "layers.softness", "C over 2 (1 - nu)/G a of the layers", range(1e-6, 1e6),
        rising},
       {&P::elements, "grid.elements"},
       {&P::points, "curve.points", "creepages of a curve", range(2, 10000)},
       {&P::noise_elements, "noise.elements", "least number N of wiggles", range(20, 1000)},
       {&P::noise_step, "noise.step", "least step c of wiggles", range(1e-12, 0.5)},
       {&P::noise_points, "noise.points", "steps, evenly spaced in their logarithm",
        range(2, 1000)},
       {&P::edge_points, "edge.points", "compliances of which the edge is measured",
        range(2, 1000)},
       {&P::force_ratio, "load.force_ratio", "of wiggles, errors and transients, over full sliding",
        range(0.05, 0.95)},
       {&P::sizes, "error.sizes", "numbers N of nodes", range(11, 10000), two_or_more_rising}});
  P p = keys.read({.material = read_material(scene), .bound = read_hertz_bound(scene)});
  require(p.elements >= 11 && p.elements <= 10000, "grid.elements", static_cast<double>(p.elements),
          "a whole number from 11 to 10000");
  require_definite(PlaneKernel(p.material, p.length), 2 * p.bound.half_width());
  return p;
}

std::vector<Table> kernels(const KernelsParameters& p, const Progress& progress) {
  constexpr std::size_t parts = 5;
  const Curves curves = curves_of(p);
  progress(1, parts);
  const Table noise = noise_of(p);
  progress(2, parts);
  const Table edges = edges_of(p);
  progress(3, parts);
  const Errors found = errors_of(p);
  progress(4, parts);
  const Table transients = transients_of(p);
  progress(5, parts);
  return {curves.curves, curves.slopes,
          noise,         edges,
          found.errors,  found.orders,
          transients,    claims_of(p, curves, noise, edges, found, transients)};
}

}  // namespace microslip::experiments
