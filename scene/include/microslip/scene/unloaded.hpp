// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/scene/model.hpp"

namespace microslip {

/// read_steady() without a load: one that is given has no part in it, and none has to be.
/// \return under a creepage of zero
SteadyProblem read_unloaded_steady(Scene& scene);

}  // namespace microslip
