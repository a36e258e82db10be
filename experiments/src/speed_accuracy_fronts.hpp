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

/// Runs that succeeded and that no other of the same problem beats: none is both as cheap and as
/// accurate. By problem and quantity, from cheap to accurate.
Table fronts_table(const std::string& name, const Cost& cost, const std::vector<Run>& runs);

/// By problem and quantity, the cheapest run within each accuracy, "none" where there is none.
Table cheapest_table(const std::string& name, const Cost& cost, const std::vector<Run>& runs);

/// Columns and cells that say who a run is.
std::vector<Column> contestant_columns();
std::vector<Cell> contestant_cells(const Contestant& contestant);

}  // namespace microslip::experiments::speed_accuracy_study
