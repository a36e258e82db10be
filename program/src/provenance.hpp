// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace microslip::program {

/// Version, and the revision that was built (from revision.txt in share_folder).
std::string version_line(const std::string& program);

/// share/microslip of the installation, or of the build, that the executable is in.
std::filesystem::path share_folder();

/// The data of a run that differ from run to run, and so are not in tables: revision, command
/// line, compiler with its flags, libraries, processor, wall time, peak memory.
std::string provenance(const std::string& program, int argc, const char* const* argv,
                       std::chrono::duration<double> wall_time);

}  // namespace microslip::program
