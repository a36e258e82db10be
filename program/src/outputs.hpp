// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace microslip::program {

struct OutputFile {
  std::string name;
  std::string content;
};

/// Writes all files under temporary names, then renames them in order; on a failure it removes what
/// it wrote. Makes the folder if needed.
/// \throws std::runtime_error that names the file
void write_files(const std::filesystem::path& folder, const std::vector<OutputFile>& files);

}  // namespace microslip::program
