// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::program {

using Work = std::function<std::vector<Table>(const Progress&)>;

/// An executable: a scene in, tables out.
struct Program {
  std::string name;
  std::string command = "";  ///< the command's name, which is then argv[1]
  std::string question;      ///< one line for --help
  std::string scene;         ///< text of the default scene; empty if --scene is required
  std::string quick;         ///< changes by --quick; empty if there is no quick version
  std::string default_out;   ///< folder for the tables
  /// Options that abbreviate --set key=value.
  struct KeyOption {
    std::string name;
    std::string key;
    std::string help;
  };
  std::vector<KeyOption> key_options = {};
  /// Reads all keys it needs, and returns the work to do once the scene has been accepted.
  std::function<Work(Scene&)> prepare;
  /// For a program with --save: as prepare, and the work also fills a text to save.
  std::function<Work(Scene&, std::string&)> prepare_to_save = {};
  /// Refuses a scene with a sweep that makes no sense, before its cases are prepared.
  std::function<void(const Scene&)> check_sweep = {};
};

/// Parses the command line, runs the program and writes its tables, with provenance.txt last.
/// Returns the exit status: 0, 1 for bad input or a failed write, 2 for NotConverged; the last two
/// with one line on stderr, and no file written. SIGINT, SIGTERM and SIGHUP, until the tables are
/// being written, also end with one line and no file, with 130, 143 and 129; files of an earlier
/// run stay whole.
int run(const Program& program, int argc, const char* const* argv);

/// Makes a Program's `prepare` of two functions.
/// \param read     takes all parameters from a scene
/// \param measure  makes the tables with them
template <class Read, class Measure>
std::function<Work(Scene&)> prepare_by(Read read, Measure measure) {
  return [=](Scene& scene) -> Work {
    return [parameters = read(scene), measure](const Progress& progress) {
      return measure(parameters, progress);
    };
  };
}

}  // namespace microslip::program
