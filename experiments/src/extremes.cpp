// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/extremes.hpp"

#include <algorithm>
#include <cmath>

#include "extremes_cases.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip::experiments {

using namespace extremes_study;

namespace {

std::vector<double> numbers_within(Scene& scene, const char* key, double least, double most) {
  const std::vector<double> numbers = scene.numbers(key);
  for (const double value : numbers) {
    require(value >= least && value <= most, key, value,
            "numbers from " + format_short(least) + " to " + format_short(most));
  }
  return numbers;
}

/// \param steps  its table
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
        "standard, c = " + format_short(least) +
            ": amplitude of the error that alternates from node to node over the peak of "
            "the bound",
        "extremes_steps"},
       {"... and does not for c = 1", "5", not_given, wiggle(1), "1",
        holds_if({below(p.limits.wiggle)}), "the same for c = 1", "extremes_steps"}});
}

}  // namespace

ExtremesParameters read_extremes(Scene& scene) {
  constexpr Eigen::Index most_elements = 1000001;
  ExtremesParameters p{
      .material = read_material(scene),
      .bound = read_hertz_bound(scene),
      .length = scene.positive("kernel.length"),
      .elements = scene.whole("grid.elements"),
      .stick_ratio = scene.number("load.stick_ratio"),
      .limits = {.error = scene.positive("limits.error"),
                 .wiggle = scene.positive("limits.wiggle"),
                 .operations = scene.positive("limits.operations")},
      .steps = {.ratios = numbers_within(scene, "steps.ratios", 1e-15, 1e6),
                .sizes = scene.wholes("steps.sizes", 1, most_elements),
                .ratios_of_large = numbers_within(scene, "steps.ratios_of_large", 1e-2, 1e6),
                .large = scene.wholes("steps.large", 1, most_elements)},
      .widths = {.ratios = numbers_within(scene, "widths.ratios", 1e-12, 1e12),
                 .poisson_ratios = numbers_within(scene, "widths.poisson_ratios", 0, 0.5)},
      .loads = {.stuck = numbers_within(scene, "loads.stuck", 0, 1),
                .sliding = numbers_within(scene, "loads.sliding", 0, 1)},
      .bounds = numbers_within(scene, "bounds", 1e-12, 0.999999),
      .offsets = numbers_within(scene, "offsets", 0, 1),
      .transient = {.ratios = numbers_within(scene, "transient.ratios", 1e-15, 1e6),
                    .sizes = scene.wholes("transient.sizes", 1, most_elements),
                    .distance = scene.positive("transient.distance"),
                    .most_steps = scene.whole("transient.most_steps")},
      .endurance = {.ratios = numbers_within(scene, "endurance.ratios", 1e-15, 1e6),
                    .states = scene.wholes("endurance.states", 1, 10000000)},
      .scales = numbers_within(scene, "scales", 1e-100, 1e100)};
  require(p.elements >= 3 && p.elements % 2 == 1, "grid.elements", static_cast<double>(p.elements),
          "an odd number from 3 on");
  require(p.stick_ratio > 0 && p.stick_ratio < 1, "load.stick_ratio", p.stick_ratio,
          "a number between 0 and 1");
  return p;
}

std::vector<Table> extremes(const ExtremesParameters& p, const Progress& progress) {
  const std::vector<Map> maps{steps_map(p),   widths_map(p),    loads_map(p),    bounds_map(p),
                              offsets_map(p), transient_map(p), endurance_map(p)};
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
