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

/// Values at the nodes, in vectors of equal length; for the units see SteadySolution.
struct NodeValues {
  const Eigen::VectorXd& x;
  const Eigen::VectorXd& bound;
  const Eigen::VectorXd& traction;
  const Eigen::VectorXd& slip;
  const Eigen::VectorXd& displacement;
  const std::vector<Zone>& zones;
};

/// The table `traction`: one row per node, except for nodes outside the contact, which have neither
/// bound nor traction.
Table traction_table(const std::string& description, const NodeValues& values);

/// An empty table `summary`, for one row per quantity.
Table empty_summary(const std::string& description);

/// The worst evidence of many steps.
struct WorstOfSteps {
  Evidence evidence;
  int iterations = 0;  ///< partitions tried in a step

  void include(const TransientState& state);
};

/// Data by which the evidence of a result is judged.
struct Judged {
  std::optional<double> condition;  ///< of the equations in adhesion, estimate; none if unknown
  int iterations;                   ///< iterations of the result
  Acceptance accepted;
  bool steady = false;
  std::optional<std::string> doubt = std::nullopt;  ///< a further doubt, in a sentence; it comes
                                                    ///< first
};

/// Adds a result's evidence to the table `summary`, if the evidence is accepted. The last row,
/// `warning`, names the doubtful quantities, or "none".
/// \throws as require_evidence
void add_evidence(Table& summary, const Evidence& evidence, const Judged& judged);

/// Warns of a solution beside the one that is given, where friction depends on slip.
std::string second_solution(SlipBranch branch);

/// The same doubt in so many steps.
std::string second_solution_in_steps(std::size_t steps, SlipBranch branch);

/// Two warnings as one, or the one that is there.
std::optional<std::string> both(const std::optional<std::string>& first,
                                const std::optional<std::string>& second);

/// The column of a table that says whether there is one.
Column second_solution_column();

}  // namespace microslip::experiments
