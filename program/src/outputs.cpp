// SPDX-License-Identifier: GPL-3.0-or-later
#include "outputs.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace microslip::program {

namespace {

namespace fs = std::filesystem;

fs::path temporary(const fs::path& folder, const OutputFile& file) {
  return folder / ("." + file.name + ".part");
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

void write_files(const fs::path& folder, const std::vector<OutputFile>& files) {
  try {
    fs::create_directories(folder);
    for (const OutputFile& file : files) write(temporary(folder, file), file.content);
    for (const OutputFile& file : files) fs::rename(temporary(folder, file), folder / file.name);
  } catch (const std::exception& error) {
    std::error_code ignored;
    for (const OutputFile& file : files) fs::remove(temporary(folder, file), ignored);
    throw std::runtime_error(error.what());
  }
}

}  // namespace microslip::program
