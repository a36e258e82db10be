// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/rolling/load_history.hpp"

namespace microslip {

/// \throws std::invalid_argument unless the columns are as LoadHistory takes them, on their own
void require_rows(const RunRows& rows);

/// A column of the contact divided by the problem's value; empty without the column.
/// \throws std::invalid_argument for another number of rows, and for numbers < 0
std::vector<double> sizes(const std::optional<Eigen::VectorXd>& column, Eigen::Index rows,
                          const std::string& name, double of_problem);

/// Rows of a run, with one more wherever v changes its sign between two of them.
struct TurningRows {
  RunRows rows;
  std::vector<std::size_t> of_file;  ///< those that the run has had before
};

TurningRows with_turns(const RunRows& rows);

}  // namespace microslip
