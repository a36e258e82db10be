// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "microslip/scene/table.hpp"

namespace microslip::experiments {

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();
inline constexpr const char* no_figure = "none";

/// A statement of the thesis, held against a measurement.
struct Claim {
  std::string claim;
  std::string section;
  double thesis_value;  ///< or not_given
  double measured_value;
  std::string unit;
  std::string verdict;  ///< reproduced, corrected, refuted, not_comparable or ours
  std::string note;
  std::string figure;  ///< stem of the plot script that shows it, or no_figure
};

/// "reproduced" if it holds, else "refuted".
std::string verdict_of(bool holds);

/// The verdict on what is no claim of the thesis, but a finding of ours: "ours", or "refuted".
std::string finding_of(bool holds);

/// The table that every study writes as claims.tsv.
/// \throws std::logic_error for another verdict, or an empty name of a figure
Table claims_table(const std::vector<Claim>& claims);

}  // namespace microslip::experiments
