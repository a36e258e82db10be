// SPDX-License-Identifier: GPL-3.0-or-later
#include "outputs.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "folder_lock.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/shown.hpp"
#include "microslip/support/writable_target.hpp"

namespace microslip::program {

namespace {

namespace fs = std::filesystem;

/// Processes on several machines may write to one folder, so that a process number would not do.
fs::path part_of(const fs::path& target) {
  static const unsigned own = std::random_device{}();
  return target.parent_path() / fmt::format(".{}.{}.part", target.filename().string(), own);
}

std::runtime_error cannot_write(const fs::path& path, const std::string& why) {
  return std::runtime_error(fmt::format("cannot write {}: {}", shown(path.string()), why));
}

/// There is no fsync: close reports a full disk and a quota, also on NFS, and what is lost with the
/// power is computed again, by a sweep as soon as it finds a case's file damaged.
void write_part(const fs::path& target, const std::string& content) {
  std::ofstream out(part_of(target), std::ios::binary);
  out << content;
  out.close();
  if (!out) throw cannot_write(target, std::strerror(errno));
}

constexpr const char* provenance_name = "provenance.txt";
constexpr const char* tables_line = "tables:";

/// Tables of the previous run in a folder that the new run does not write. What stands in their
/// place and is no file, such as a device, is none.
std::vector<fs::path> outdated(const fs::path& folder, const std::vector<OutputFile>& files) {
  std::vector<fs::path> tables;
  if (files.empty() || files.back().name != provenance_name) return tables;
  std::ifstream in(folder / provenance_name);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(tables_line)) continue;
    std::istringstream names(line.substr(std::strlen(tables_line)));
    for (std::string name; names >> name;) {
      const fs::path table = folder / fs::path(name).filename();
      const bool is_written =
          std::ranges::find(files, table.filename().string(), &OutputFile::name) != files.end();
      if (!is_written && fs::is_regular_file(fs::symlink_status(table))) tables.push_back(table);
    }
  }
  return tables;
}

/// Renames the temporary files, each of which replaces a previous file atomically. The last one of
/// several is removed first and put in place last, so that a folder with the last file has all
/// files of the same run, even if the process is killed in between.
/// \param removed  files to remove
void put_in_place(const std::vector<fs::path>& targets, const std::vector<fs::path>& removed) {
  if (targets.size() > 1) fs::remove(targets.back());
  for (const fs::path& table : removed) fs::remove(table);
  for (const fs::path& target : targets) {
    std::error_code error;
    fs::rename(part_of(target), target, error);
    if (error) throw cannot_write(target, error.message());
  }
}

/// Makes a folder, and removes it again, together with parents that were made, if the folder
/// remains empty.
class Folder {
 public:
  explicit Folder(const fs::path& path) {
    // Without the separator at its end, which would count as one more name.
    const fs::path whole = path.has_filename() ? path : path.parent_path();
    for (fs::path at = whole; !at.empty() && !fs::exists(fs::symlink_status(at));
         at = at.parent_path()) {
      made_.push_back(at);
    }
    fs::create_directories(path);
  }
  ~Folder() {
    std::error_code ignored;
    for (const fs::path& path : made_) fs::remove(path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

 private:
  std::vector<fs::path> made_;
};

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

/// Errors of the file system in the words of the others.
[[noreturn]] void rethrow(const fs::path& folder) {
  try {
    throw;
  } catch (const fs::filesystem_error& error) {
    throw cannot_write(folder, error.code().message());
  }
}

}  // namespace

OutputFile output_of(const Table& table, const std::string& program, const Parameters& parameters) {
  std::ostringstream text;
  table.write(text, program, parameters);
  return {table.name() + ".tsv", text.str()};
}

OutputFile csv_of(const Table& table) {
  std::string text;
  for (const Column& column : table.columns()) {
    text += (text.empty() ? "" : ",") +
            csv_cell(column.unit == "1" ? column.name
                                        : fmt::format("{} [{}]", column.name, column.unit));
  }
  text += '\n';
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const char* separator = "";
    for (const Column& column : table.columns()) {
      const Cell& cell = table.at(i, column.name);
      const auto* number = std::get_if<double>(&cell);
      text += separator;
      text += number != nullptr ? format_short(*number) : csv_cell(std::get<std::string>(cell));
      separator = ",";
    }
    text += '\n';
  }
  return {table.name() + ".csv", text};
}

OutputFile provenance_of(const std::string& text, const std::vector<OutputFile>& tables) {
  std::string line = tables_line;
  for (const OutputFile& table : tables) line += " " + table.name;
  return {provenance_name, fmt::format("{}{}\n", text, line)};
}

void require_writable(const fs::path& folder) {
  if (folder.empty()) throw std::invalid_argument("--out '': expected the name of a folder");
  try {
    fs::path there = fs::absolute(folder);
    while (!fs::exists(fs::symlink_status(there)) && there.has_relative_path()) {
      there = there.parent_path();
    }
    if (!fs::is_directory(there)) throw cannot_write(folder, there.string() + " is not a folder");
    if (access(there.c_str(), W_OK | X_OK) != 0) throw cannot_write(folder, std::strerror(errno));
  } catch (const fs::filesystem_error&) {
    rethrow(folder);
  }
}

void write_files(const fs::path& folder, const std::vector<OutputFile>& files) {
  std::vector<fs::path> targets;
  for (const OutputFile& file : files) targets.push_back(writable_target(folder / file.name));
  try {
    const Folder made(folder);
    const FolderLock lock(folder);
    try {
      for (std::size_t i = 0; i < files.size(); ++i) write_part(targets[i], files[i].content);
      put_in_place(targets, outdated(folder, files));
    } catch (const std::exception&) {
      std::error_code ignored;
      for (const fs::path& target : targets) fs::remove(part_of(target), ignored);
      throw;
    }
  } catch (const fs::filesystem_error&) {
    rethrow(folder);
  }
}

void write_folder(const fs::path& folder, const std::vector<OutputFile>& files) {
  const fs::path part = part_of(folder);
  try {
    write_files(part, files);
    const FolderLock lock(folder.parent_path());
    fs::remove_all(folder);
    fs::rename(part, folder);
  } catch (const std::exception&) {
    std::error_code ignored;
    fs::remove_all(part, ignored);
    rethrow(folder);
  }
}

}  // namespace microslip::program
