// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "speed_accuracy_runs.hpp"

namespace microslip::experiments::speed_accuracy_study {

/// Cost of a run: counted or measured.
struct Cost {
  std::string name;  ///< of the column
  std::string unit;
  std::string meaning;
  double Run::*value;
};

/// Lists the runs that succeeded and that no other run of the same problem beats: no other run is
/// both as cheap and as accurate; among all runs, among runs by elements, and among the runs of
/// each scheme. Rows go by problem and quantity, from cheap to accurate.
Table fronts_table(const std::string& name, const Cost& cost, const std::vector<Run>& runs);

/// Lists, by problem and quantity, the cheapest run within each accuracy, and the cost of the
/// thesis's scheme for the same accuracy; "none" where no run reaches the accuracy.
Table cheapest_table(const std::string& name, const Cost& cost, const std::vector<Run>& runs);

/// These columns and cells identify a run.
std::vector<Column> contestant_columns();
std::vector<Cell> contestant_cells(const Contestant& contestant);

}  // namespace microslip::experiments::speed_accuracy_study
