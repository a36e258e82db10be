// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/program/run.hpp"

#include <chrono>
#include <iostream>
#include <optional>
#include <sstream>

#include "command_line.hpp"
#include "interrupts.hpp"
#include "outputs.hpp"
#include "process.hpp"
#include "provenance.hpp"

namespace microslip::program {

namespace {

Options options_of(const Program& program) {
  Options options("Options");
  add_scene_options(options, program);
  auto add = options.add_options();
  if (!program.quick.empty()) add("quick", "a coarser version, in seconds");
  if (!program.scene.empty()) add("print-scene", "print the default scene and exit");
  add_common_options(options, program.default_out);
  return options;
}

/// The doubt that a summary names, if it does.
std::optional<std::string> warning_of(const Table& table) {
  if (table.name() != "summary" || table.columns().front().name != "quantity") return std::nullopt;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto* quantity = std::get_if<std::string>(&table.at(i, "quantity"));
    if (quantity == nullptr || *quantity != "warning") continue;
    const auto& line = std::get<std::string>(table.at(i, "value"));
    if (line != "none") return line;
  }
  return std::nullopt;
}

/// A run is written when all of it is done: the longest study takes a minute, and tables of half a
/// study would need parameters of their own. Many cases that must not be lost are a sweep.
void run_scene(const Program& program, Scene& scene, const Given& given, int argc,
               const char* const* argv) {
  const auto start = std::chrono::steady_clock::now();
  Interrupts interrupts(program.name + ": interrupted, nothing is written");
  const std::string out = given["out"].as<std::string>();
  const auto work = with_places(scene, [&] {
    Work prepared = program.prepare(scene);
    scene.reject_unread();
    return prepared;
  });
  require_writable(out);
  const std::vector<Table> tables = with_places(
      scene, [&] { return work(progress_on_terminal(program.name, given.count("quiet") != 0)); });
  std::vector<OutputFile> files;
  for (const Table& table : tables) {
    files.push_back(output_of(table, program.name, scene.origin()));
  }
  files.push_back(provenance_of(
      provenance(program.name, argc, argv, std::chrono::steady_clock::now() - start), files));
  interrupts.last([&] { write_files(out, files); });
  const auto warn = [&](const std::string& line) {
    std::cerr << program.name << ": warning: " << line << '\n';
  };
  for (const std::string& line : scene.warnings()) warn(line);
  for (const Table& table : tables) {
    if (const auto line = warning_of(table)) warn(*line);
  }
}

}  // namespace

int run(const Program& program, int argc, const char* const* argv) {
  return run_process(program.name, [&] {
    const Options options = options_of(program);
    const int word = program.command.empty() ? 0 : 1;
    const Given given = parse(options, argc - word, argv + word, "scene");
    const std::string name = program.name + (word == 0 ? "" : " " + program.command);
    if (answers(given, options, name, program.question)) return 0;
    if (given.count("print-scene") != 0) {
      std::cout << program.scene;
      return 0;
    }
    Scene scene = read_scene(program, given);
    run_scene(program, scene, given, argc, argv);
    return 0;
  });
}

}  // namespace microslip::program
