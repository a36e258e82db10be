// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "microslip/support/shown.hpp"
#include "microslip/support/writable_target.hpp"
#include "outputs.hpp"

extern char** environ;

namespace microslip::program {

namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

/// Runs a program of this machine, which takes the signals that this one holds back. Returns its
/// exit status, 127 if it cannot be started.
/// \param log  file for what it says on standard error
int run_tool(std::vector<std::string> words, const fs::path& log) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   0600);
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, arguments[0], &files, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) return 127;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

/// Why draw.sh failed, from what it and gnuplot said: its last line, "draw: SCRIPT: why", and the
/// first line of gnuplot if there is one.
std::string reason_in(const std::string& log) {
  const std::string_view full = "No space left on device";
  if (log.find(full) != std::string::npos) return std::string(full);
  std::vector<std::string> lines;
  std::istringstream in(log);
  for (std::string line; std::getline(in, line);) {
    if (line.find_first_not_of(" \t^") != std::string::npos) lines.push_back(line);
  }
  if (lines.empty()) return "draw.sh failed";
  const std::string& last = lines.back();
  const std::size_t colon = last.rfind(": ");
  const std::string why = colon == std::string::npos ? last : last.substr(colon + 2);
  return lines.size() == 1 ? why : fmt::format("{}: {}", why, lines.front());
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::string name = fs::temp_directory_path() / "microslip_XXXXXX";
  if (mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error(fmt::format("cannot write {}: {}", shown(name), std::strerror(errno)));
  }
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void draw(const fs::path& script, const fs::path& tables, const fs::path& figure,
          const std::string& settings) {
  const fs::path target = writable_target(fs::absolute(figure));
  require_writable(target.parent_path());
  const ScratchFolder scratch;
  const fs::path drawn = scratch.path() / ("figure" + figure.extension().string());
  const fs::path log = scratch.path() / "log";
  const std::string tool = script.parent_path() / "draw.sh";
  if (run_tool({tool, script, tables, drawn, settings}, log) != 0) {
    throw std::runtime_error(
        fmt::format("cannot draw {}: {}", shown(figure.string()), shown(reason_in(bytes_of(log)))));
  }
  write_files(target.parent_path(), {{target.filename(), bytes_of(drawn)}});
  std::cout << "drew " << figure.string() << '\n';
}

}  // namespace microslip::program
