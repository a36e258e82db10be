// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "microslip/program/commands.hpp"
#include "microslip/support/nearest.hpp"
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

[[noreturn]] void reject(const fs::path& folder, const std::string& why) {
  throw std::invalid_argument(
      fmt::format("'{}': expected the folder of a result; {}", shown(folder.string()), why));
}

/// Which program wrote a result: the first word of its provenance.
std::string program_of(const fs::path& folder) {
  if (!fs::is_directory(folder)) reject(folder, "there is no such folder");
  std::ifstream in(folder / "provenance.txt");
  std::string program;
  if (!(in >> program)) reject(folder, "it has no provenance.txt");
  return program;
}

/// Of those that have a figure of their own.
std::string kind_of(const fs::path& folder) {
  if (fs::exists(folder / "sweep.tsv")) {
    reject(folder, "it is that of a sweep, the columns of sweep.tsv are for plots of your own");
  }
  for (const char* kind : {"response", "converge"}) {
    if (fs::exists(folder / fmt::format("{}.tsv", kind))) return kind;
  }
  if (!fs::exists(folder / "traction.tsv")) reject(folder, "it has no traction.tsv");
  const std::string history = header_of(folder / "history.tsv");
  if (history.empty()) return "steady";
  return history.starts_with("q\t") ? "transient" : "cylinder";
}

struct Figure {
  std::string name;
  fs::path script;
  std::string ending;  ///< behind the name of the result
};

/// Whether there are enough shifts for a loop of the force.
bool has_loop(const fs::path& folder) {
  constexpr int least = 3;
  std::ifstream in(folder / "shifts.tsv");
  int rows = -2;  // the first two lines are the names and the start
  for (std::string line; std::getline(in, line);) rows += line.starts_with('#') ? 0 : 1;
  return rows >= least;
}

std::vector<Figure> figures_of_scene(const fs::path& plots, const std::string& program,
                                     const fs::path& folder) {
  const auto script = [&](const std::string& kind) {
    return plots / fmt::format("{}_{}.gp", program, kind);
  };
  const std::string kind = kind_of(folder);
  std::vector<Figure> figures{{kind, script(kind), ""}};
  if (kind == "transient" && has_loop(folder)) {
    figures.push_back({"shifts", script("shifts"), "_shifts"});
  }
  return figures;
}

/// All that the scripts know of a study, in the order of their names.
std::vector<Figure> figures_of_study(const fs::path& plots, const std::string& study) {
  std::vector<Figure> figures;
  for (const auto& entry : fs::directory_iterator(plots)) {
    const std::string name = entry.path().stem();
    if (entry.path().extension() != ".gp" || !name.starts_with(study + "_")) continue;
    const std::string figure = name.substr(study.size() + 1);
    figures.push_back({figure, entry.path(), "_" + figure});
  }
  std::ranges::sort(figures, {}, &Figure::name);
  return figures;
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

void draw(const fs::path& plots, const fs::path& script, const fs::path& folder,
          const fs::path& figure) {
  if (run_tool({plots / "draw.sh", script, folder, figure}) != 0) {
    throw std::runtime_error("cannot draw " + shown(figure.string()));
  }
  std::cout << "drew " << figure.string() << '\n';
}

/// The figures of a result, or the one of them that is asked for.
std::vector<Figure> chosen(const std::vector<Figure>& figures, const Given& given) {
  if (given.count("figure") == 0) return figures;
  const std::string wanted = given["figure"].as<std::string>();
  const auto found = std::ranges::find(figures, wanted, &Figure::name);
  if (found != figures.end()) return {*found};
  const std::vector<std::string> names = names_of(figures);
  throw std::invalid_argument(fmt::format("--figure '{}': expected {}{}", shown(wanted),
                                          joined(names, ", "), question(nearest(wanted, names))));
}

/// The folder of a result, which may be named by one of its tables, too; with a name of its own,
/// after which figures are named.
fs::path folder_of(const fs::path& result) {
  const fs::path folder = fs::is_regular_file(result) ? fs::absolute(result).parent_path() : result;
  const fs::path whole = (fs::absolute(folder) / "").lexically_normal().parent_path();
  const fs::path relative = whole.lexically_relative(fs::current_path());
  return relative.string().starts_with('.') ? whole : relative;
}

/// Where --to wants a figure; draw.sh knows three formats.
fs::path target_of(const Given& given) {
  const std::string name = given["to"].as<std::string>();
  const std::string ending = fs::path(name).extension();
  if (ending == ".svg" || ending == ".png" || ending == ".pdf") return name;
  throw std::invalid_argument(
      fmt::format("--to '{}': expected a name that ends in .svg, .png or .pdf", shown(name)));
}

/// \param name  of the program of scenes; the others are studies
void draw_all(const std::string& name, const fs::path& folder, const Given& given) {
  const std::string program = program_of(folder);
  const fs::path plots = share_folder() / "plots";
  if (!fs::is_directory(plots)) {
    throw std::runtime_error(fmt::format("cannot read {}: expected the scripts of figures there",
                                         shown(plots.string())));
  }
  const std::vector<Figure> all =
      program == name ? figures_of_scene(plots, program, folder) : figures_of_study(plots, program);
  if (all.empty()) reject(folder, fmt::format("that of {} has no figures", shown(program)));
  const std::vector<Figure> figures = chosen(all, given);
  if (given.count("to") != 0) {
    if (figures.size() > 1) throw std::invalid_argument("--to: expected --figure with it here");
    return draw(plots, figures.front().script, folder, target_of(given));
  }
  for (const Figure& figure : figures) {
    draw(plots, figure.script, folder, folder.string() + figure.ending + ".svg");
  }
}

}  // namespace

int plot(const std::string& name, int argc, const char* const* argv) {
  return run_process(name, [&] {
    Options known("Options of plot");
    known.add_options()("result", options::value<std::string>()->default_value("out"),
                        "the first word: folder of a result, or of a study, or a table there")(
        "figure", options::value<std::string>(), "this one instead of all")(
        "to", options::value<std::string>(),
        "file that ends in .svg, .png or .pdf (default: RESULT.svg, or RESULT_FIGURE.svg of one "
        "figure of several)")("version", "print version and revision")("help", "print this");
    const Given given = parse(known, argc - 1, argv + 1, "result");
    if (answers(given, known, name + " plot", "draws the figures of a result, with gnuplot")) {
      return 0;
    }
    draw_all(name, folder_of(given["result"].as<std::string>()), given);
    return 0;
  });
}

}  // namespace microslip::program
