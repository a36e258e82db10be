// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "microslip/program/run.hpp"

namespace microslip::program {

/// A case whose scene has been read and accepted.
struct Case {
  Parameters parameters;  ///< and warnings
  Work work;
};

/// The cases that a sweep is going to solve.
struct SweepPlan {
  Table table;        ///< `plan`: a row a case, its number from 1 and the swept values
  Parameters common;  ///< parameters that are the same in all cases, and checksums of files
  std::vector<Case> cases;
};

/// Reads the scenes of all cases.
/// \throws std::invalid_argument for what Sweep rejects, and for a case whose scene is rejected
SweepPlan plan_of(const Program& program, Scene scene);

/// "case 7 of 64 (load.creepage = 0.1, grid.elements = 50)"
std::string case_label(const Table& plan, std::size_t index);

}  // namespace microslip::program
