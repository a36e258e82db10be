// SPDX-License-Identifier: GPL-3.0-or-later
#include "outputs.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace microslip::program {

namespace {

namespace fs = std::filesystem;

/// Processes on several machines may write to one folder, so that a process number would not do.
std::string temporary(const std::string& name) {
  static const std::string own = std::to_string(std::random_device{}());
  return "." + name + "." + own + ".part";
}

void write(const fs::path& path, const std::string& content) {
  std::ofstream out(path, std::ios::binary);
  out << content;
  out.close();
  if (!out) {
    throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(errno));
  }
}

}  // namespace

OutputFile output_of(const Table& table, const std::string& program, const Parameters& parameters) {
  std::ostringstream text;
  table.write(text, program, parameters);
  return {table.name() + ".tsv", text.str()};
}

void write_files(const fs::path& folder, const std::vector<OutputFile>& files) {
  const auto part = [&](const OutputFile& file) { return folder / temporary(file.name); };
  try {
    fs::create_directories(folder);
    for (const OutputFile& file : files) write(part(file), file.content);
    for (const OutputFile& file : files) fs::rename(part(file), folder / file.name);
  } catch (const std::exception& error) {
    std::error_code ignored;
    for (const OutputFile& file : files) fs::remove(part(file), ignored);
    throw std::runtime_error(error.what());
  }
}

void write_folder(const fs::path& folder, const std::vector<OutputFile>& files) {
  const fs::path part = folder.parent_path() / temporary(folder.filename());
  try {
    write_files(part, files);
    fs::remove_all(folder);
    fs::rename(part, folder);
  } catch (const std::exception& error) {
    std::error_code ignored;
    fs::remove_all(part, ignored);
    throw std::runtime_error(error.what());
  }
}

}  // namespace microslip::program
