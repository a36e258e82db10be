// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/program/run.hpp"

#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>

#include "command_line.hpp"
#include "interrupts.hpp"
#include "joined_sweep.hpp"
#include "key_list.hpp"
#include "microslip/program/run_joined.hpp"
#include "microslip/support/shown.hpp"
#include "microslip/support/writable_target.hpp"
#include "outputs.hpp"
#include "process.hpp"
#include "provenance.hpp"
#include "result_line.hpp"

namespace microslip::program {

namespace {

namespace fs = std::filesystem;
namespace options = boost::program_options;

Options options_of(const Program& program) {
  Options known("Options");
  add_scene_options(known, program);
  auto add = known.add_options();
  if (!program.quick.empty()) add("quick", "a coarser version, in seconds");
  if (!program.scene.empty()) {
    add("print-scene", "print the default scene and exit");
    add("print-keys", options::value<std::string>()->implicit_value("text"),
        "print its keys and exit, as text, markdown, man or completion");
  }
  if (program.prepare_to_save) {
    add("save", options::value<std::string>(),
        "file for the final state of a transient; start.state continues from it");
  }
  known.add_options()("format", options::value<std::string>()->default_value("tsv"),
                      "csv: each table as comma-separated NAME.csv, too, without comments");
  add_common_options(known, program.default_out);
  return known;
}

/// The first doubt that a summary names, if it does.
std::optional<std::string> warning_of(const Table& table) {
  if (table.name() != "summary" || !table.has("quantity")) return std::nullopt;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto* quantity = std::get_if<std::string>(&table.at(i, "quantity"));
    if (quantity == nullptr || *quantity != "warning") continue;
    const auto& line = std::get<std::string>(table.at(i, "value"));
    if (line != "none") return line;
  }
  return std::nullopt;
}

/// The advice in a result; empty if there is none.
std::string advice_in(const Table& table) {
  std::string lines;
  if (table.columns().front().name != "advice") return lines;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    lines += std::get<std::string>(table.at(i, "advice")) + '\n';
  }
  return lines;
}

/// Prints the advice in a result, or one line about it. The tables are written: nobody who reads
/// the line is no error.
void print_result(const Program& program, const std::vector<Table>& tables, const std::string& out,
                  bool quiet) {
  std::string advice;
  for (const Table& table : tables) advice += advice_in(table);
  std::cout << advice << std::flush;
  if (!advice.empty() || quiet) return;
  std::cout << result_line(program.name, tables, out) << std::endl;
  std::cout.clear();
}

/// Where --save writes: an absolute path, which is no table of the run.
/// \throws std::invalid_argument or std::runtime_error if nothing can be written there
fs::path place_to_save(const std::string& name) {
  const fs::path file = name.empty() ? fs::path() : fs::absolute(name);
  if (!file.has_filename() || fs::is_directory(file)) {
    throw std::invalid_argument(
        fmt::format("--save '{}': expected the name of a file", shown(name)));
  }
  if (file.extension() == ".tsv" || file.filename() == "provenance.txt") {
    throw std::invalid_argument(
        fmt::format("--save '{}': expected a name that differs from the tables", shown(name)));
  }
  if (!fs::is_directory(file.parent_path())) {
    throw std::invalid_argument(
        fmt::format("--save '{}': expected a folder that is there", shown(name)));
  }
  const fs::path target = writable_target(file);
  require_writable(target.parent_path());
  return target;
}

/// Whether --format asks for CSV, too.
bool wants_csv(const Given& given) {
  const std::string format = given["format"].as<std::string>();
  if (format == "csv") return true;
  if (format == "tsv") return false;
  throw std::invalid_argument(fmt::format("--format '{}': expected tsv or csv", shown(format)));
}

/// A run is written when all of it is done: the longest study takes a minute, and tables of half a
/// study would need parameters of their own. Many cases that must not be lost are a sweep.
/// \param joins  whether there may be a sweep
void run_scene(const Program& program, bool joins, Scene& scene, const Given& given, int argc,
               const char* const* argv) {
  const auto start = std::chrono::steady_clock::now();
  Interrupts interrupts(program.name + ": interrupted, nothing is written");
  const std::string out = given["out"].as<std::string>();
  const bool with_csv = wants_csv(given);
  std::string state;
  const bool saves = given.count("save") != 0;
  std::optional<JoinedSweep> sweep;
  if (joins && has_sweep(scene)) sweep = joined_sweep(program, scene);
  const auto work = sweep ? sweep->work : with_places(scene, [&] {
    Work prepared = saves ? program.prepare_to_save(scene, state) : program.prepare(scene);
    scene.reject_unread();
    return prepared;
  });
  require_writable(out);
  const fs::path saved = saves ? place_to_save(given["save"].as<std::string>()) : fs::path();
  const std::vector<Table> tables = with_places(
      scene, [&] { return work(progress_on_terminal(program.name, given.count("quiet") != 0)); });
  std::vector<OutputFile> files;
  const Parameters origin = sweep ? sweep->parameters : scene.origin();
  for (const Table& table : tables) {
    files.push_back(output_of(table, program.name, origin));
    if (with_csv) files.push_back(csv_of(table));
  }
  files.push_back(provenance_of(
      provenance(program.name, argc, argv, std::chrono::steady_clock::now() - start), files));
  if (saves) files.insert(files.begin(), {saved, state});
  interrupts.last([&] { write_files(out, files); });
  print_result(program, tables, out, given.count("quiet") != 0);
  const auto warn = [&](const std::string& place, const std::string& line) {
    std::cerr << program.name << ": " << place << "warning: " << line << '\n';
  };
  for (const auto& [key, line] : scene.warnings()) warn(scene.place_of(key), line);
  for (const Table& table : tables) {
    if (const auto line = warning_of(table)) warn("", *line);
  }
}

int run(const Program& program, bool joins, int argc, const char* const* argv) {
  return run_process(program.name, [&] {
    const Options known = options_of(program);
    const int word = program.command.empty() ? 0 : 1;
    const Given given = parse(known, argc - word, argv + word, "scene");
    const std::string name = program.name + (word == 0 ? "" : " " + program.command);
    if (answers(given, known, name, program.question)) return 0;
    if (given.count("print-scene") != 0) {
      std::cout << program.scene;
      return 0;
    }
    if (given.count("print-keys") != 0) {
      print_keys_of_study(program, given["print-keys"].as<std::string>());
      return 0;
    }
    Scene scene = read_scene(program, given);
    run_scene(program, joins, scene, given, argc, argv);
    return 0;
  });
}

}  // namespace

int run(const Program& program, int argc, const char* const* argv) {
  return run(program, false, argc, argv);
}

int run_joined(const Program& program, int argc, const char* const* argv) {
  return run(program, true, argc, argv);
}

}  // namespace microslip::program
