// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "microslip/scene/keys.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip::experiments {

/// \file
/// Further conditions on lists of a study's keys, besides the range. The message prints the values
/// that the key accepts, so the key's note must state the condition.

template <class Number>
void demand_count(const Scene& scene, const std::string& key, const std::vector<Number>& values,
                  std::size_t least) {
  scene.demand(key, static_cast<double>(values.size()), values.size() >= least);
}

template <class Number>
void demand_rising(const Scene& scene, const std::string& key, const std::vector<Number>& values) {
  for (std::size_t k = 1; k < values.size(); ++k) {
    scene.demand(key, static_cast<double>(values[k]), values[k] > values[k - 1]);
  }
}

/// Demands two or more values, each twice the one before.
inline void demand_doubling(const Scene& scene, const std::string& key,
                            const std::vector<Eigen::Index>& values) {
  demand_count(scene, key, values, 2);
  for (std::size_t k = 1; k < values.size(); ++k) {
    scene.demand(key, static_cast<double>(values[k]), values[k] == 2 * values[k - 1]);
  }
}

inline void demand_odd(const Scene& scene, const std::string& key,
                       const std::vector<Eigen::Index>& values) {
  for (const Eigen::Index value : values) {
    scene.demand(key, static_cast<double>(value), value % 2 == 1);
  }
}

}  // namespace microslip::experiments
