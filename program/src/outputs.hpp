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

/// <name of the table>.csv, for programs that read no comments: columns as "force [N/mm]", commas
/// between them, quotes around texts that need them, numbers that read back as the same double.
OutputFile csv_of(const Table& table);

/// provenance.txt: a text that differs from run to run, and the names of the run's tables.
OutputFile provenance_of(const std::string& text, const std::vector<OutputFile>& tables);

/// Checks before a long computation that a folder, or the parent in which it would be made, can be
/// written. Makes nothing.
/// \throws std::invalid_argument if it has no name, std::runtime_error that names it
void require_writable(const std::filesystem::path& folder);

/// Writes all files under temporary names, which are this process's own, then renames them; if one
/// cannot be written, it removes what it wrote, and what was there before stays. A name that is a
/// link to a file stays a link; one of a device, a pipe or a folder is an error. Makes the folder
/// if needed. Processes that share a folder write one after the other. If provenance.txt is the
/// last of the files, tables are removed that the previous provenance.txt names and the new one
/// does not: the folder holds one run.
/// \throws std::exception that names the file
void write_files(const std::filesystem::path& folder, const std::vector<OutputFile>& files);

/// Writes a folder with all files or not at all. A folder of the same name is replaced.
/// \throws std::runtime_error that names the file
void write_folder(const std::filesystem::path& folder, const std::vector<OutputFile>& files);

}  // namespace microslip::program
