// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/program/run.hpp"

namespace microslip::program {

/// All cases of a sweep as one piece of work.
struct JoinedSweep {
  Parameters parameters;  ///< that are the same in all cases, and checksums of files
  Work work;  ///< its tables have the rows of all cases, behind columns of the swept values
};

/// Whether a scene has a section `sweep`.
bool has_sweep(const Scene& scene);

/// \throws std::invalid_argument as plan_of
JoinedSweep joined_sweep(const Program& program, const Scene& scene);

}  // namespace microslip::program
