// SPDX-License-Identifier: GPL-3.0-or-later
#include "outputs.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "folder_lock.hpp"

namespace microslip::program {

namespace {

namespace fs = std::filesystem;

/// Processes on several machines may write to one folder, so that a process number would not do.
fs::path beside(const fs::path& target, const std::string& ending) {
  static const std::string own = std::to_string(std::random_device{}());
  const std::string name = target.filename();
  return target.parent_path() / ("." + name + "." + own + ending);
}
fs::path part_of(const fs::path& target) { return beside(target, ".part"); }
fs::path former_of(const fs::path& target) { return beside(target, ".former"); }

std::runtime_error cannot_write(const fs::path& path, const std::string& why) {
  return std::runtime_error("cannot write " + path.string() + ": " + why);
}

/// There is no fsync: close reports a full disk and a quota, also on NFS, and what is lost with the
/// power is computed again, by a sweep as soon as it finds a case's file damaged.
void write_part(const fs::path& target, const std::string& content) {
  std::ofstream out(part_of(target), std::ios::binary);
  out << content;
  out.close();
  if (!out) throw cannot_write(target, std::strerror(errno));
}

/// Renames the parts of all files, or of none: what was there before comes back. One file alone is
/// replaced at once. Of more, the last goes first and comes last, so that a folder that has it has
/// the others of the same run, even if the process is killed in between.
void put_in_place(const std::vector<fs::path>& targets) {
  std::vector<std::pair<fs::path, fs::path>> moved;
  const auto move = [&](const fs::path& from, const fs::path& to, const fs::path& target) {
    std::error_code error;
    fs::rename(from, to, error);
    if (error) throw cannot_write(target, error.message());
    moved.emplace_back(from, to);
  };
  std::error_code ignored;
  try {
    for (auto target = targets.rbegin(); target != targets.rend(); ++target) {
      if (fs::is_directory(*target)) throw cannot_write(*target, std::strerror(EISDIR));
      const bool replaced = fs::exists(fs::symlink_status(*target));
      if (targets.size() > 1 && replaced) move(*target, former_of(*target), *target);
    }
    for (const fs::path& target : targets) move(part_of(target), target, target);
  } catch (const std::exception&) {
    for (auto move = moved.rbegin(); move != moved.rend(); ++move) {
      fs::rename(move->second, move->first, ignored);
    }
    throw;
  }
  for (const fs::path& target : targets) fs::remove(former_of(target), ignored);
}

/// Makes a folder, and takes it away again, with the parents it made, if it remains empty.
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
  for (const OutputFile& file : files) targets.push_back(folder / file.name);
  try {
    const Folder made(folder);
    const FolderLock lock(folder);
    try {
      for (std::size_t i = 0; i < files.size(); ++i) write_part(targets[i], files[i].content);
      put_in_place(targets);
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
