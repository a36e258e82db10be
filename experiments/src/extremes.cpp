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
  const double least = std::ranges::min(p.steps.ratios);
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
  using enum Key::Type;
  static constexpr auto keys = std::to_array<Key>(
      {{"grid.elements", whole, "1", "N of the ordinary case", range(3, most_elements), "odd"},
       {"load.stick_ratio", number, "1", "a' of the ordinary case", inner_fraction},
       {"limits.error", number, "1", "of force or creepage, beyond which a result has failed",
        above_zero},
       {"limits.wiggle", number, "1", "amplitude over the peak of the bound, likewise", above_zero},
       {"limits.operations", number, "1", "of a case; one that is expected to take more is not run",
        above_zero},
       {"steps.step_ratios", list, "1", "c of steady rolling", range(1e-15, 1e6)},
       {"steps.sizes", wholes, "1", "N of steady rolling", range(1, most_elements)},
       {"steps.large_step_ratios", list, "1", "c with large N", range(1e-2, 1e6)},
       {"steps.large_sizes", wholes, "1", "large N, run whatever they take",
        range(1, most_elements)},
       {"widths.strip_widths", list, "1", "Dy/dx", range(1e-12, 1e12)},
       {"widths.poisson_ratios", list, "1", "Poisson ratios of these", range(0, 0.5)},
       {"loads.stick_ratios", list, "1", "a', from full sliding up", fraction},
       {"loads.sliding", list, "1", "1 - a', from full stick up", fraction},
       {"bounds.force_ratios", list, "1",
        "forces over full sliding, under bounds that are not smooth", range(1e-12, 0.999999)},
       {"kernels.layers", list, "1", "compliance of a layer of springs over 2 (1 - nu) a/G",
        range(1e-12, 1e12)},
       {"kernels.beta_over_mu", list, "1", "beta/mu of bodies of different material",
        range(1e-12, 1e6)},
       {"kernels.force_ratios", list, "1", "forces over full sliding of both",
        range(1e-12, 0.999999)},
       {"offsets", list, "1", "leading and trailing offsets", fraction},
       {"transient.step_ratios", list, "1", "c of a shift that rolls on", range(1e-15, 1e6)},
       {"transient.sizes", wholes, "1", "N of that", range(1, most_elements)},
       {"transient.elements_rolled", number, "1",
        "distance, in elements, or as far as transient.most_steps go", above_zero},
       {"transient.most_steps", whole, "1", "steps of that", range(1, 1e9)},
       {"endurance.step_ratios", list, "1", "c of very many steps", range(1e-15, 1e6)},
       {"endurance.states", wholes, "1", "steps after which the state is taken", range(1, 1e7),
        "in rising order"},
       {"cylinder.force_ratios", list, "1", "slope force over full sliding", range(1e-12, 1e6)},
       {"cylinder.step_ratios", list, "1", "c of a cylinder", range(1e-3, 1e6)},
       {"scales", list, "1", "factors of G, a and the bound, one at a time and all at once",
        range(1e-100, 1e100)}});
  scene.declare(keys);

  ExtremesParameters p{.material = read_material(scene),
                       .bound = read_hertz_bound(scene),
                       .length = scene.positive("kernel.length"),
                       .elements = scene.whole("grid.elements"),
                       .stick_ratio = scene.number("load.stick_ratio"),
                       .limits = {.error = scene.number("limits.error"),
                                  .wiggle = scene.number("limits.wiggle"),
                                  .operations = scene.number("limits.operations")},
                       .steps = {.ratios = scene.numbers("steps.step_ratios"),
                                 .sizes = scene.wholes("steps.sizes"),
                                 .ratios_of_large = scene.numbers("steps.large_step_ratios"),
                                 .large = scene.wholes("steps.large_sizes")},
                       .widths = {.ratios = scene.numbers("widths.strip_widths"),
                                  .poisson_ratios = scene.numbers("widths.poisson_ratios")},
                       .loads = {.stuck = scene.numbers("loads.stick_ratios"),
                                 .sliding = scene.numbers("loads.sliding")},
                       .bounds = scene.numbers("bounds.force_ratios"),
                       .kernels = {.layers = scene.numbers("kernels.layers"),
                                   .strains = scene.numbers("kernels.beta_over_mu"),
                                   .loads = scene.numbers("kernels.force_ratios")},
                       .offsets = scene.numbers("offsets"),
                       .transient = {.ratios = scene.numbers("transient.step_ratios"),
                                     .sizes = scene.wholes("transient.sizes"),
                                     .distance = scene.number("transient.elements_rolled"),
                                     .most_steps = scene.whole("transient.most_steps")},
                       .endurance = {.ratios = scene.numbers("endurance.step_ratios"),
                                     .states = scene.wholes("endurance.states")},
                       .cylinder = {.force_ratios = scene.numbers("cylinder.force_ratios"),
                                    .ratios = scene.numbers("cylinder.step_ratios")},
                       .scales = scene.numbers("scales")};
  demand_odd(scene, "grid.elements", {p.elements});
  demand_rising(scene, "endurance.states", p.endurance.states);
  return p;
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
