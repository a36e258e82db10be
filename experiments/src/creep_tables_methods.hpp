// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "creep_tables_states.hpp"

namespace microslip::experiments {

/// A method for creep forces, in the states of a study.
struct ComparedMethod {
  std::string name;
  bool has_moment = true;
  /// By state: results over mu F_n and mu F_n c; none where the method has none.
  std::vector<std::optional<Eigen::Vector3d>> forces{};
  /// Times of a motion, and of what comes first for each a/b; nan where not measured  [s]
  double time = std::numeric_limits<double>::quiet_NaN();
  double setup = 0;
};

/// All methods, with measured times. Direct solutions use all cores before times are measured.
std::vector<ComparedMethod> compared_methods(const CreepTablesParameters& parameters,
                                             const std::vector<ComparedState>& states);

}  // namespace microslip::experiments
