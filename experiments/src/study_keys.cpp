// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_keys.hpp"

#include <string>

namespace microslip::experiments {

void demand(const Scene& scene, const std::string& key, const Demand& demanded,
            const std::vector<double>& values) {
  scene.demand(key, values[0], values.size() >= demanded.least);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const bool follows = k == 0 || !demanded.follows || demanded.follows(values[k], values[k - 1]);
    scene.demand(key, values[k], follows && (!demanded.holds || demanded.holds(values[k])));
  }
}

std::vector<double> read_values(Scene& scene, const Key& key, const Demand& demanded) {
  const std::string name(key.name);
  std::vector<double> values;
  if (key.type == Key::Type::list) {
    values = scene.numbers(name);
  } else if (key.type == Key::Type::wholes) {
    const std::vector<Eigen::Index> wholes = scene.wholes(name);
    values.assign(wholes.begin(), wholes.end());
  } else if (key.type == Key::Type::whole) {
    values = {static_cast<double>(scene.whole(name))};
  } else {
    const Range range = scene.known(name)->range;
    values = {range.open && range.least == 0 ? scene.positive(name) : scene.number(name)};
  }
  demand(scene, name, demanded, values);
  return values;
}

}  // namespace microslip::experiments
