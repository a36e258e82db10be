// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "microslip/rolling/transient.hpp"
#include "microslip/scene/table.hpp"

namespace microslip::experiments {

/// "A" in adhesion, "S" in slip.
std::string region(Zone zone);

/// Values at the nodes, all of one length; for the units see SteadySolution.
struct NodeValues {
  const Eigen::VectorXd& x;
  const Eigen::VectorXd& bound;
  const Eigen::VectorXd& traction;
  const Eigen::VectorXd& slip;
  const Eigen::VectorXd& displacement;
  const std::vector<Zone>& zones;
};

/// The table `traction`: a row a node, but those outside the contact, without bound and traction.
Table traction_table(const std::string& description, const NodeValues& values);

/// The table `summary`, a row a quantity, without rows.
Table empty_summary(const std::string& description);

/// What many steps show of their own correctness: the worst of each.
struct WorstOfSteps {
  Evidence evidence;
  int iterations = 0;  ///< partitions tried in a step

  void include(const TransientState& state);
};

/// What evidence is judged by, and what the result is of.
struct Judged {
  double condition;  ///< of the equations in adhesion, estimate
  int iterations;    ///< that the result took
  Acceptance accepted;
  bool steady = false;
  std::optional<std::string> doubt = std::nullopt;  ///< another one, in a sentence; goes first
};

/// Adds what a result shows of its own correctness to such a table, if that is accepted; the
/// last row, `warning`, says what is doubtful, or "none".
/// \throws as require_evidence
void add_evidence(Table& summary, const Evidence& evidence, const Judged& judged);

}  // namespace microslip::experiments
