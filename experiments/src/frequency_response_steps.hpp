// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/experiments/frequency_response.hpp"

namespace microslip::experiments::frequency_response_study {

struct MotionTables {
  Table steps;
  Table errors;
};

/// Rolls after small steps of the creepage and of the force by each scheme.
MotionTables motion_tables(const FrequencyResponseParameters& parameters, const Progress& progress);

}  // namespace microslip::experiments::frequency_response_study
