// SPDX-License-Identifier: GPL-3.0-or-later
#include "instants.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "microslip/rolling/transient.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

const std::string number_of_instants = "motion.instants", places_of_instants = "motion.instants_at";

/// Distances that divide a run into equal parts, without its start.
std::vector<double> even_places(Scene& scene, const RunSteps& steps) {
  const auto count = static_cast<double>(scene.whole(number_of_instants));
  scene.demand_in_range(number_of_instants, count);
  std::vector<double> places;
  for (double k = 1; k <= count; ++k) {
    places.push_back(steps.from + (steps.distance - steps.from) * k / count);
  }
  return places;
}

std::vector<double> given_places(Scene& scene, const RunSteps& steps) {
  constexpr double printed = 1e-9;  // the distance of load.file may be a rounded one
  const std::string text = scene.text(places_of_instants);  // before ranges are expanded
  std::vector<double> places = scene.numbers(places_of_instants);
  const double most = find_key(number_of_instants)->range.most;
  if (static_cast<double>(places.size()) > most) {
    reject(places_of_instants, text,
           fmt::format("at most {} distances, not {}", format_short(most), places.size()));
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    const bool is_within = places[k] >= steps.from && places[k] <= (1 + printed) * steps.distance;
    const bool rises = k == 0 || places[k] > places[k - 1];
    require(is_within && rises, places_of_instants, places[k], [&] {
      return fmt::format("distances in rising order, from {} to {}, of the run",
                         format_short(steps.from), format_short(steps.distance));
    });
  }
  return places;
}

/// Distances at the start and at the ends of all steps.
std::vector<double> ends_of(const RunSteps& steps) {
  std::vector<double> ends{steps.from};
  for_steps(steps.distance, steps.lengths, steps.from, steps.ends,
            [&](double, double to, double) { ends.push_back(to); });
  return ends;
}

std::size_t nearest_to(double place, const std::vector<double>& ends) {
  const auto behind = std::ranges::lower_bound(ends, place);
  if (behind == ends.begin()) return 0;
  const auto found =
      behind == ends.end() || place - behind[-1] <= *behind - place ? behind - 1 : behind;
  return static_cast<std::size_t>(found - ends.begin());
}

}  // namespace

std::vector<std::size_t> read_instants(Scene& scene, const RunSteps& steps) {
  const std::string given = scene.at_most_one_of({number_of_instants, places_of_instants});
  if (given.empty()) return {};
  const std::vector<double> places =
      given == number_of_instants ? even_places(scene, steps) : given_places(scene, steps);
  const std::vector<double> ends = ends_of(steps);
  std::vector<std::size_t> instants;
  for (const double place : places) instants.push_back(nearest_to(place, ends));
  instants.erase(std::unique(instants.begin(), instants.end()), instants.end());
  if (instants.size() < places.size()) {
    scene.warn(given, scene.text(given),
               fmt::format("an instant is the end of a step, the nearest one, and {} of {} places "
                           "have the same as others: there are {} instants",
                           places.size() - instants.size(), places.size(), instants.size()));
  }
  return instants;
}

}  // namespace microslip
