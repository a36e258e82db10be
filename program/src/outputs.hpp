// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "microslip/scene/table.hpp"

namespace microslip::program {

struct OutputFile {
  std::string name;
  std::string content;
};

/// <name of the table>.tsv
OutputFile output_of(const Table& table, const std::string& program, const Parameters& parameters);

/// Writes all files under temporary names, which are this process's own, then renames them in
/// order; on a failure it removes what it wrote. Makes the folder if needed.
/// \throws std::runtime_error that names the file
void write_files(const std::filesystem::path& folder, const std::vector<OutputFile>& files);

/// A folder that is there with all files or not at all. Replaces one of that name.
/// \throws std::runtime_error that names the file
void write_folder(const std::filesystem::path& folder, const std::vector<OutputFile>& files);

}  // namespace microslip::program
