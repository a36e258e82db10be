// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "microslip/experiments/rule.hpp"
#include "microslip/scene/table.hpp"

namespace microslip::experiments {

inline constexpr const char* no_figure = "none";

/// A statement of the thesis, compared with a measurement.
struct Claim {
  std::string claim;
  std::string section;
  double thesis_value;  ///< or not_given
  double measured_value;
  std::string unit;
  Rule rule;           ///< from which the verdict follows
  std::string note;    ///< meaning of the number; no statement that depends on the study's
                       ///< parameters
  std::string figure;  ///< stem of the plot script that shows it, or no_figure
  /// A measured value up to this size is a rounding error, in addition to the limit
  /// rounding_of(rule).
  double rounding = 0;
};

/// A number in a note: its digits; "below" the bound if the number is only a rounding error.
std::string text_above_rounding(double value, double bound);

/// The table that every study writes as claims.tsv, with the verdicts by the claims' rules:
/// reproduced, corrected, refuted, not_comparable or ours.
/// \throws std::logic_error for another verdict, a rule that says nothing, or an empty name of a
///         figure
Table claims_table(const std::vector<Claim>& claims);

/// The tables with all verdicts of claims replaced by "not_judged", and with the reason in the
/// description: verdicts on the thesis are only valid for the parameters chosen for them.
/// \param changed  keys whose values differ from the study's defaults; without such keys nothing is
///                 changed
std::vector<Table> judged_unless_changed(std::vector<Table> tables,
                                         const std::vector<std::string>& changed);

}  // namespace microslip::experiments
