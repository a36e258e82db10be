// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace microslip::program {

/// A folder for temporary files, which is removed with them.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Draws a figure by a script of gnuplot, and says so. The file is written as a whole or not at
/// all.
/// \param settings  commands of gnuplot, before the commands of the script
/// \throws std::exception with one line if it cannot be drawn or written
void draw(const std::filesystem::path& script, const std::filesystem::path& tables,
          const std::filesystem::path& figure, const std::string& settings = "");

}  // namespace microslip::program
