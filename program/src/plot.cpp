// SPDX-License-Identifier: GPL-3.0-or-later
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "microslip/program/commands.hpp"
#include "microslip/support/shown.hpp"
#include "process.hpp"
#include "provenance.hpp"

extern char** environ;

namespace microslip::program {

namespace {

namespace options = boost::program_options;
namespace fs = std::filesystem;

/// The line of column names of a table; empty if there is none.
std::string header_of(const fs::path& table) {
  std::ifstream in(table);
  std::string line;
  while (std::getline(in, line) && line.starts_with('#')) continue;
  return line;
}

std::string kind_of(const fs::path& folder) {
  const auto reject = [&](const std::string& why) {
    throw std::invalid_argument("'" + shown(folder.string()) +
                                "': expected the folder of a result; " + why);
  };
  if (!fs::is_directory(folder)) reject("there is no such folder");
  if (!fs::exists(folder / "provenance.txt")) reject("it has no provenance.txt");
  if (fs::exists(folder / "sweep.tsv")) {
    reject("it is that of a sweep, the columns of sweep.tsv are for plots of your own");
  }
  if (!fs::exists(folder / "traction.tsv")) reject("it has no traction.tsv");
  const std::string history = header_of(folder / "history.tsv");
  if (history.empty()) return "steady";
  return history.starts_with("q\t") ? "transient" : "cylinder";
}

/// Runs a program of this machine. Returns its exit status, 127 if it cannot be started.
int run_tool(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0)
    return 127;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

void draw(const std::string& name, const fs::path& folder, const fs::path& figure) {
  const fs::path plots = share_folder() / "plots";
  const fs::path script = plots / (name + "_" + kind_of(folder) + ".gp");
  if (!fs::exists(script)) {
    throw std::runtime_error("cannot read " + shown(script.string()) +
                             ": expected the scripts of the installation there");
  }
  if (run_tool({plots / "draw.sh", script, folder, figure}) != 0) {
    throw std::runtime_error("cannot draw " + shown(figure.string()));
  }
}

}  // namespace

int plot(const std::string& name, int argc, const char* const* argv) {
  return run_process(name, [&] {
    Options known("Options of plot");
    known.add_options()("result", options::value<std::string>()->default_value("out"),
                        "the first word: folder of the result")("to", options::value<std::string>(),
                                                                "SVG file (default: RESULT.svg)")(
        "version", "print version and revision")("help", "print this");
    const Given given = parse(known, argc - 1, argv + 1, "result");
    if (answers(given, known, name + " plot", "draws the figure of a result, with gnuplot"))
      return 0;
    fs::path folder = given["result"].as<std::string>();
    if (!folder.has_filename()) folder = folder.parent_path();  // out/
    const fs::path figure =
        given.count("to") != 0 ? given["to"].as<std::string>() : folder.string() + ".svg";
    draw(name, folder, figure);
    std::cout << "drew " << figure.string() << '\n';
    return 0;
  });
}

}  // namespace microslip::program
