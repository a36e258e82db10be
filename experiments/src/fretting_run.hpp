// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/experiments/fretting.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::experiments::fretting_study {

/// Largest error of the energy balance due to rounding, over the total work.
inline constexpr double run_rounding = 1e-11;

/// Runs a cycle at standstill, rolls, runs another cycle, rolls, and takes the force off.
/// \param rolling  at rest
Table run_table(const FrettingParameters& parameters, TransientRolling rolling);

}  // namespace microslip::experiments::fretting_study
