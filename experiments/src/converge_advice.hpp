// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "microslip/scene/table.hpp"

namespace microslip::experiments {

/// A run that may be recommended.
struct Candidate {
  std::string scheme;
  Eigen::Index elements;
  double error;  ///< of the answer, relative
  double time;   ///< [s]
  double steps;
  double longest_step;  ///< [s]
};

struct Wanted {
  double error;                     ///< relative
  std::optional<double> step_time;  ///< that the longest step may last  [s]
  std::string quantity;             ///< that the error is of
  bool steady;
  double reference_error;
};

/// A line of text for each wish. Each scheme enters with the least N from which on its errors are
/// small enough.
Table advice(const std::vector<Candidate>& candidates, const Wanted& wanted);

}  // namespace microslip::experiments
