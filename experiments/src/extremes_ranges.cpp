// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include "extremes_cases.hpp"

namespace microslip::experiments::extremes_study {

namespace {

/// Compares coordinates with a tolerance, because a row's place may have been computed.
bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); }

/// Selects the outcomes of one scheme along one coordinate, where all other coordinates are
/// ordinary.
std::vector<Outcome> along(const Map& map, const std::vector<Outcome>& outcomes,
                           const std::string& scheme, std::size_t coordinate) {
  std::vector<Outcome> found;
  for (const Outcome& outcome : outcomes) {
    bool on_line = outcome.at.scheme == scheme && outcome.verdict != "not_run";
    for (std::size_t k = 0; k < map.ordinary.size(); ++k) {
      const double ordinary = map.ordinary[k];
      if (k == coordinate || std::isnan(ordinary)) continue;
      on_line = on_line && same(outcome.at.place[k], ordinary);
    }
    if (on_line) found.push_back(outcome);
  }
  std::ranges::sort(found, {}, [=](const Outcome& o) { return o.at.place[coordinate]; });
  return found;
}

struct End {
  double value;
  std::string beyond;  ///< verdict on the next case; none was tried if "-"
};

/// Goes from a safe place, in steps of +-1, to the last safe place.
End end_of(const std::vector<Outcome>& line, std::ptrdiff_t from, int step,
           std::size_t coordinate) {
  const auto size = static_cast<std::ptrdiff_t>(line.size());
  for (std::ptrdiff_t k = from;; k += step) {
    const double value = line[static_cast<std::size_t>(k)].at.place[coordinate];
    if (k + step < 0 || k + step >= size) return {value, "-"};
    const std::string& next = line[static_cast<std::size_t>(k + step)].verdict;
    if (next != "ok") return {value, next};
  }
}

}  // namespace

Table empty_ranges() {
  return {"ranges",
          "where a scheme is safe: around an ordinary place, all others being ordinary",
          {{"map", "1", "table of the cases"},
           {"scheme", "1", "how the cases are solved"},
           {"parameter", "1", "what varies"},
           {"ordinary", "see there", "value from which the range is looked for"},
           {"least", "see there", "value that is safe, nan if the ordinary one is not"},
           {"most", "see there", "likewise"},
           {"below", "1", "verdict on the next lower value; - if none was tried"},
           {"above", "1", "verdict on the next higher value; likewise"}}};
}

void add_ranges(Table& ranges, const Map& map, const std::vector<Outcome>& outcomes) {
  std::set<std::string> schemes;
  for (const Outcome& outcome : outcomes) {
    if (!schemes.insert(outcome.at.scheme).second) continue;
    for (std::size_t k = 0; k < map.ordinary.size(); ++k) {
      const double ordinary = map.ordinary[k];
      const std::vector<Outcome> line = along(map, outcomes, outcome.at.scheme, k);
      const auto place = std::ranges::find_if(
          line, [&](const Outcome& o) { return same(o.at.place[k], ordinary); });
      if (line.size() < 2 || place == line.end()) continue;
      const auto at = place - line.begin();
      const bool safe = place->verdict == "ok";
      const End least = safe ? end_of(line, at, -1, k) : End{not_given, place->verdict};
      const End most = safe ? end_of(line, at, 1, k) : least;
      ranges.add({map.name, outcome.at.scheme, map.coordinates[k].name, ordinary, least.value,
                  most.value, least.beyond, most.beyond});
    }
  }
}

}  // namespace microslip::experiments::extremes_study
