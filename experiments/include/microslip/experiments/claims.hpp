// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "microslip/experiments/rule.hpp"
#include "microslip/scene/table.hpp"

namespace microslip::experiments {

inline constexpr const char* no_figure = "none";

/// A statement of the thesis, held against a measurement.
struct Claim {
  std::string claim;
  std::string section;
  double thesis_value;  ///< or not_given
  double measured_value;
  std::string unit;
  Rule rule;           ///< from which the verdict follows
  std::string note;    ///< what the number is; nothing that only holds for the study's parameters
  std::string figure;  ///< stem of the plot script that shows it, or no_figure
  /// A measured value of this size or less is nothing but rounding, besides what rounding_of(rule)
  /// says.
  double rounding = 0;
};

/// A number in a note: its digits, or "below" the bound where it is nothing but rounding.
std::string text_above_rounding(double value, double bound);

/// The table that every study writes as claims.tsv, with the verdicts by the claims' rules:
/// reproduced, corrected, refuted, not_comparable or ours.
/// \throws std::logic_error for another verdict, a rule that says nothing, or an empty name of a
///         figure
Table claims_table(const std::vector<Claim>& claims);

/// The same tables with all verdicts of the claims replaced by "not_judged", and the reason in the
/// table's description: verdicts on the thesis belong to the parameters that were chosen for it.
/// \param changed  keys whose values are others than those of the study; without any, all stays
std::vector<Table> judged_unless_changed(std::vector<Table> tables,
                                         const std::vector<std::string>& changed);

}  // namespace microslip::experiments
