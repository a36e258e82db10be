// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/experiments/frequency_response.hpp"

namespace microslip::experiments::frequency_response_study {

/// Marks full adhesion in the column stick_ratio.
inline constexpr double all_adheres = 1;

struct WaveTables {
  Table measured;
  Table errors;
  Table orders;
};

/// Rolls by each scheme with all waves at once, about full adhesion and about the states.
WaveTables wave_tables(const FrequencyResponseParameters& parameters, const Progress& progress);

}  // namespace microslip::experiments::frequency_response_study
