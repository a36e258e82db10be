// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/experiments/open_problems.hpp"

namespace microslip::experiments::open_problems_study {

/// Cattaneo to Carter by several schemes and step ratios, compared with a finer grid.
struct StepTables {
  Table steps;
  Table traction;
};

StepTables step_tables(const OpenProblemsParameters& p, const Progress& progress);

}  // namespace microslip::experiments::open_problems_study
