// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/extremes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "extremes_cases.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "study_keys.hpp"

namespace microslip::experiments {

using namespace extremes_study;

namespace {

/// Judges the claims.
/// \param steps  the table of the map of steps
Table claims_of(const Table& steps, const ExtremesParameters& p) {
  const auto wiggle = [&](double step_ratio) {
    return steps.latest({{"scheme", "standard"},
                         {"step_ratio", step_ratio},
                         {"elements", static_cast<double>(p.elements)}},
                        "wiggle");
  };
  const double least = std::ranges::min(p.step_ratios);
  return claims_table(
      {{"the solution wiggles when the step is small against the element", "5", not_given,
        wiggle(least), "1",
        holds_if({{"its ratio to the one for c = 1", wiggle(least) / wiggle(1), above(10)}}),
        fmt::format("standard, c = {}: amplitude of the error that alternates from node to node "
                    "over the peak of the bound",
                    format_short(least)),
        "extremes_steps"},
       {"the solution does not wiggle for c = 1", "5", not_given, wiggle(1), "1",
        holds_if({below(p.limits.wiggle)}), "the same for c = 1", "extremes_steps"}});
}

}  // namespace

ExtremesParameters read_extremes(Scene& scene) {
  constexpr double most_elements = 1000001;
  using P = ExtremesParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::length, "kernel.length"},
       {&P::elements, "grid.elements", "N of the ordinary case", range(3, most_elements), odd},
       {&P::stick_ratio, "load.stick_ratio", "a' of the ordinary case", inner_fraction},
       {in(&P::limits, &P::Limits::error), "limits.error",
        "of force or creepage, beyond which a result has failed", above_zero},
       {in(&P::limits, &P::Limits::wiggle), "limits.wiggle",
        "amplitude over the peak of the bound, likewise", above_zero},
       {in(&P::limits, &P::Limits::operations), "limits.operations",
        "of a case; one that is expected to take more is not run", above_zero},
       {&P::step_ratios, "steps.step_ratios", "c of steady rolling", range(1e-15, 1e6)},
       {&P::sizes, "steps.sizes", "N of steady rolling", range(1, most_elements)},
       {&P::large_step_ratios, "steps.large_step_ratios", "c with large N", range(1e-2, 1e6)},
       {&P::large_sizes, "steps.large_sizes", "large N, run whatever they take",
        range(1, most_elements)},
       {&P::strip_widths, "widths.strip_widths", "Dy/dx", range(1e-12, 1e12)},
       {&P::poisson_ratios, "widths.poisson_ratios", "Poisson ratios of these", range(0, 0.5)},
       {&P::stick_ratios, "loads.stick_ratios", "a', from full sliding up", fraction},
       {&P::sliding, "loads.sliding", "1 - a', from full stick up", fraction},
       {&P::bound_loads, "bounds.force_ratios",
        "forces over full sliding, under bounds that are not smooth", range(1e-12, 0.999999)},
       {&P::layers, "kernels.layers", "compliance of a layer of springs over 2 (1 - nu) a/G",
        range(1e-12, 1e12)},
       {&P::strains, "kernels.beta_over_mu", "beta/mu of bodies of different material",
        range(1e-12, 1e6)},
       {&P::kernel_loads, "kernels.force_ratios", "forces over full sliding of both",
        range(1e-12, 0.999999)},
       {&P::offsets, "offsets", "leading and trailing offsets", fraction},
       {&P::transient_ratios, "transient.step_ratios", "c of a shift that rolls on",
        range(1e-15, 1e6)},
       {&P::transient_sizes, "transient.sizes", "N of that", range(1, most_elements)},
       {&P::distance, "transient.elements_rolled",
        "distance, in elements, or as far as transient.most_steps go", above_zero},
       {&P::most_steps, "transient.most_steps", "steps of that", range(1, 1e9)},
       {&P::endurance_ratios, "endurance.step_ratios", "c of very many steps", range(1e-15, 1e6)},
       {&P::states, "endurance.states", "steps after which the state is taken", range(1, 1e7),
        rising},
       {&P::slope_ratios, "cylinder.force_ratios", "slope force over full sliding",
        range(1e-12, 1e6)},
       {&P::cylinder_ratios, "cylinder.step_ratios", "c of a cylinder", range(1e-3, 1e6)},
       {&P::scales, "scales", "factors of G, a and the bound, one at a time and all at once",
        range(1e-100, 1e100)}});
  return keys.read({.material = read_material(scene), .bound = read_hertz_bound(scene)});
}

std::vector<Table> extremes(const ExtremesParameters& p, const Progress& progress) {
  const std::vector<Map> maps{steps_map(p),     widths_map(p),  loads_map(p),   bounds_map(p),
                              kernels_map(p),   bodies_map(p),  offsets_map(p), transient_map(p),
                              endurance_map(p), cylinder_map(p)};
  std::size_t total = 0;
  for (const Map& map : maps) total += map.cases.size();
  std::size_t done = 0;
  std::vector<Table> tables;
  Table ranges = empty_ranges();
  for (const Map& map : maps) {
    std::vector<Outcome> outcomes;
    Runs runs({.operations = p.limits.operations});
    for (const Case& at : map.cases) {
      if (!at.goes_on) runs = Runs({.operations = p.limits.operations});
      outcomes.push_back(outcome_of(runs, at, p.limits));
      progress(++done, total);
    }
    tables.push_back(table_of(map, outcomes));
    add_ranges(ranges, map, outcomes);
  }
  tables.push_back(scales_table(p));
  tables.push_back(ranges);
  tables.push_back(claims_of(tables.front(), p));
  return tables;
}

}  // namespace microslip::experiments
