// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/rolling/steady.hpp"

namespace microslip {

/// The method `Calibrated` where there is more than one stick zone.
SteadySolution with_several_zones(const SteadyProblem& problem);

}  // namespace microslip
