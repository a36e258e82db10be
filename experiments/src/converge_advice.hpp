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
  double longest_step;    ///< [s]
  Eigen::Index rows = 0;  ///< of an ellipse; 0 of a line contact
};

struct Wanted {
  double error;                     ///< relative
  std::optional<double> step_time;  ///< the longest step may last so long  [s]
  std::string quantity;             ///< whose error is meant
  bool steady;
  double reference_error;
};

/// Writes a line of text for each wish. Each scheme enters with the least N from which on its
/// errors are small enough.
Table advice(const std::vector<Candidate>& candidates, const Wanted& wanted);

}  // namespace microslip::experiments
