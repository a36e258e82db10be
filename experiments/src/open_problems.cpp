// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/open_problems.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "campaign.hpp"
#include "microslip/experiments/claims.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "open_problems_steady.hpp"
#include "open_problems_steps.hpp"
#include "study_keys.hpp"
#include "table_values.hpp"

namespace microslip::experiments {

using namespace open_problems_study;

namespace {

/// Recommends a scheme for each need, with its measured errors.
Table schemes_table(const OpenProblemsParameters& p, const SteadyTables& steady,
                    const CurveTables& curve, const StepTables& steps) {
  Table table("schemes", "which scheme for which need",
              {{"need", "1", "what is wanted"},
               {"keys", "1", "of the scene"},
               {"force_error", "1",
                "steady: median over the cases at the largest N; chebyshev: "
                "the largest of the curves with the most unknowns",
                chebyshev_rounding},
               {"force_order", "1", "steady: fitted to the medians"},
               {"traction_error", "N/mm", "transient: sum of |p - reference| dx over the nodes"},
               {"limits", "1", "what it does not do"}});
  const auto steady_row = [&](const char* need, const char* scheme) {
    table.add({need, std::string("leading_edge ") + scheme,
               steady.errors.latest({{"scheme", scheme}}, "force_median"),
               steady.orders.latest({{"scheme", scheme}}, "force_order"), not_given,
               std::string(steady_scheme(scheme).limits)});
  };
  const auto transient_row = [&](const char* need, const char* scheme, double c) {
    table.add({need, std::string("step.scheme ") + scheme, not_given, not_given,
               steps.steps.latest({{"scheme", scheme}, {"step_ratio", c}}, "error"),
               std::string(advection_scheme(scheme).limits)});
  };
  double chebyshev = 0;
  for (const double width : p.widths) {
    chebyshev = std::max(chebyshev, curve.digits.latest({{"width", width}}, "largest_error"));
  }
  const double smallest = *std::min_element(p.motion_ratios.begin(), p.motion_ratios.end());
  table.add({"steady, smooth bound: a reference, a creepage-force curve", "method chebyshev",
             chebyshev, not_given, not_given, std::string(steady_scheme("chebyshev").limits)});
  steady_row("steady, one stick zone: any bound", "inversion");
  steady_row("steady, any bound", "calibrated");
  steady_row("steady, as CONTACT", "standard");
  steady_row("steady, as thesis 10.3", "known_edge");
  transient_row("transient, any step", "remembered", smallest);
  transient_row("transient, small steps as thesis 7.1", "relaxed", smallest);
  transient_row("transient, c = 1, as CONTACT", "direct", 1);
  return table;
}

Table claims_of(const OpenProblemsParameters& p, const SteadyTables& steady,
                const StepTables& steps) {
  const double order = steady.orders.latest({{"scheme", "calibrated"}}, "force_order");
  const double gain = steady.errors.latest({{"scheme", "standard"}}, "force_median") /
                      steady.errors.latest({{"scheme", "calibrated"}}, "force_median");
  const double between = most(steps.steps, "from_unit_step", {{"scheme", "remembered"}});
  const double remembered = most(steps.steps, "error", {{"scheme", "remembered"}});
  const double direct = most(steps.steps, "error", {{"scheme", "direct"}});
  return claims_table(
      {{"second order is expected in theory, but not observed", "11", 2, order, "1",
        corrected_if({within(0.1, 2)}, "reproduced"),
        "order of the force by elements with calibrated edges; by inversion it is exact to " +
            format_short(inversion_rounding),
        "open_problems_convergence"},
       {"a better leading edge will decrease the cost of a given accuracy drastically", "11",
        not_given, gain, "1", holds_if({above(100)}),
        fmt::format(
            "median error of the standard scheme over the error of calibrated elements, N = {}",
            p.sizes.back()),
        "open_problems_convergence"},
       {"further tests show odd behaviour in a world-fixed frame in certain cases", "11", not_given,
        between, "N/mm", corrected_if({below(1e-3)}, "reproduced"),
        "largest integral of the difference to c = 1, over all c", "open_problems_steps", 1e-12},
       {"smoothing can be stopped in a world-fixed frame", "11", not_given, direct / remembered,
        "1", holds_if({above(10)}),
        "largest error of the direct scheme over the error of the remembered scheme, over all c",
        "open_problems_steps"}});
}

}  // namespace

namespace {}  // namespace

OpenProblemsParameters read_open_problems(Scene& scene) {
  using P = OpenProblemsParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::length, "kernel.length"},
       {&P::stick_ratios, "cases.stick_ratios", "least and largest a' of the cases", inner_fraction,
        Demand("two, in rising order", nullptr, is_above, 2)},
       {&P::sizes, "grid.sizes", "numbers N of nodes", range(3, 2000), two_or_more_doubling},
       {&P::cases, "cases.number", "of random parts of adhesion and alignments of the grid",
        range(1, 1000)},
       {&P::steady_elements, "steady.elements", "N of the case for all steps",
        range(1, Grid::max_elements)},
       {&P::steady_stick_ratio, "steady.stick_ratio", "a' of that", inner_fraction},
       {&P::steady_ratios, "steady.step_ratios", "c of that", range_from(min_step_ratio)},
       {&P::motion_elements, "motion.elements", "N of the transient", range(1, Grid::max_elements)},
       {&P::force, "load.force"},
       {&P::distance, "motion.elements_rolled", "distance, in elements", range(1, 1000)},
       {&P::refinement, "motion.refinement", "elements of the reference for each one",
        range(2, 32)},
       {&P::motion_ratios, "motion.step_ratios", "c of the transient", range(1e-4, 5)},
       {&P::widths, "curve.widths", "of strips, in half-widths", range_from(1)},
       {&P::curve_points, "curve.points", "of a curve of creepage and force", range(2, 10000)},
       {&P::unknowns, "curve.unknowns", "of the Chebyshev collocation", range(1, 63)}});
  P p = keys.read({.material = read_material(scene), .bound = read_polynomial_bound(scene)});
  scene.demand("cases.stick_ratios", p.stick_ratios.back(), p.stick_ratios.size() == 2);
  return p;
}

std::vector<Table> open_problems(const OpenProblemsParameters& p, const Progress& progress) {
  const CurveTables curve = curve_tables(p);
  const SteadyTables steady = steady_tables(p, progress);
  const StepTables steps = step_tables(p, progress);
  return {steady.cases,
          steady.errors,
          steady.orders,
          steady.steps,
          steps.steps,
          steps.traction,
          curve.curve,
          curve.digits,
          schemes_table(p, steady, curve, steps),
          claims_of(p, steady, steps)};
}

}  // namespace microslip::experiments
