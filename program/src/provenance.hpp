// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

namespace microslip::program {

/// Version, and the revision that was built (from revision.txt beside the executable).
std::string version_line(const std::string& program);

/// What tables must not hold, because it differs from run to run: revision, compiler, libraries,
/// command line, wall time.
std::string provenance(const std::string& program, int argc, const char* const* argv,
                       std::chrono::duration<double> wall_time);

}  // namespace microslip::program
