// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>
#include <span>

#include "command_line.hpp"
#include "microslip/program/commands.hpp"
#include "microslip/program/memory.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/sweep.hpp"
#include "process.hpp"

namespace microslip::program {

namespace {

/// Median of the study speed_accuracy; nine of ten runs take 0.14 to 0.84  [s]
constexpr double seconds_per_operation = 3.5e-10;

struct Unit {
  double size;
  const char* name;
};

/// A value with two digits, in the largest unit in which it is at least 1.
/// \param units  from the largest to the least
std::string in_units(double value, std::span<const Unit> units) {
  const auto fits = [&](const Unit& unit) { return value >= unit.size; };
  const auto found = std::ranges::find_if(units, fits);
  const Unit& unit = found == units.end() ? units.back() : *found;
  const double number = value / unit.size;
  return number >= 100 ? fmt::format("{:.0f} {}", number, unit.name)
                       : fmt::format("{:.2g} {}", number, unit.name);
}

std::string bytes(double value) {
  constexpr std::array<Unit, 3> units{{{1e9, "GB"}, {1e6, "MB"}, {1e3, "kB"}}};
  return in_units(value, units);
}

std::string time(double seconds) {
  constexpr std::array<Unit, 4> units{{{3600, "h"}, {60, "min"}, {1, "s"}, {1e-3, "ms"}}};
  return in_units(seconds, units);
}

void print_keys(const Scene& scene) {
  const Parameters& parameters = scene.parameters();
  std::size_t names = 0, values = 0;
  const auto key_of = [](const std::string& name) {  // without the word "derived" before it
    return name.substr(name.rfind(' ') + 1);
  };
  const auto with_unit = [&](const auto& parameter) {
    const std::string unit = scene.unit_of(key_of(parameter.first));
    return parameter.second + (unit == "1" ? "" : " " + unit);
  };
  for (const auto& parameter : parameters) {
    names = std::max(names, parameter.first.size());
    values = std::max(values, with_unit(parameter).size());
  }
  for (const auto& parameter : parameters) {
    const Key* key = find_key(key_of(parameter.first));
    std::cout << "  " << std::left << std::setw(static_cast<int>(names)) << parameter.first << "  "
              << std::setw(static_cast<int>(values)) << with_unit(parameter);
    if (key != nullptr) std::cout << "  " << key->meaning;
    std::cout << '\n';
  }
}

void print_lines(const std::string& title, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  std::cout << '\n' << title << '\n';
  for (const std::string& line : lines) std::cout << "  " << line << '\n';
}

/// Costs and warnings of all cases of a sweep, or of a single scene.
struct Costs {
  std::size_t cases = 0;
  double work = 0;    ///< of all cases
  double memory = 0;  ///< largest of a case  [bytes]
  std::vector<std::string> warnings;
};

void print_scene(const Scene& scene, const Preview& preview, bool is_swept, std::size_t cases) {
  if (is_swept) std::cout << cases << " cases, the first is: ";
  std::cout << preview.explanation.title << "\n\n";
  print_keys(scene);
  print_lines("Consequences", preview.explanation.consequences);
  print_lines("Not modelled", preview.explanation.not_modelled);
}

/// Reads all cases, and prints the first one.
Costs preview_cases(const Scene& read, const std::function<Preview(Scene&)>& preview) {
  const std::vector<std::string> keys = read.keys();
  const bool is_swept =
      std::ranges::any_of(keys, [](const std::string& key) { return key.starts_with("sweep."); });
  const auto sweep =
      with_places(read, [&] { return is_swept ? std::make_optional<Sweep>(read) : std::nullopt; });
  Costs all;
  all.cases = sweep ? sweep->size() : 1;
  for (std::size_t i = 0; i < all.cases; ++i) {
    Scene scene = sweep ? sweep->scene(i) : read;
    const Preview seen = with_places(scene, [&] {
      const Preview of_scene = preview(scene);
      scene.reject_unread();
      return of_scene;
    });
    if (i == 0) print_scene(scene, seen, is_swept, all.cases);
    all.work += seen.work;
    all.memory = std::max(all.memory, seen.memory);
    for (const Warning& warning : scene.warnings()) {
      const std::string line = scene.place_of(warning.key) + warning.line;
      if (std::ranges::find(all.warnings, line) == all.warnings.end()) all.warnings.push_back(line);
    }
  }
  return all;
}

void print_cost(const Costs& all) {
  constexpr double program = 12e6;  // of memory, without a scene
  std::vector<std::string> lines;
  if (std::isfinite(all.work)) {
    lines.push_back(
        fmt::format("about {:.2g} operations, {} on one core{}; within a factor of five", all.work,
                    time(all.work * seconds_per_operation), all.cases > 1 ? " for all cases" : ""));
  } else {
    lines.push_back("as many operations as the target error needs; at least a millisecond");
  }
  lines.push_back(fmt::format("at most {} of memory{}; {} are available",
                              bytes(all.memory + program), all.cases > 1 ? " a case at once" : "",
                              bytes(available_memory())));
  print_lines("Cost", lines);
}

}  // namespace

int explain(const Program& program, const std::function<Preview(Scene&)>& preview, int argc,
            const char* const* argv) {
  return run_process(program.name, [&] {
    Options known("Options of explain");
    add_scene_options(known, program);
    known.add_options()("version", "print version and revision")("help", "print this");
    const Given given = parse(known, argc - 1, argv + 1, "scene");
    const std::string purpose =
        "describes the model of a scene, its limits and its cost, and solves nothing";
    if (answers(given, known, program.name + " explain", purpose)) return 0;
    const Costs all = preview_cases(read_scene(program, given), preview);
    print_cost(all);
    print_lines("Warnings", all.warnings);
    return 0;
  });
}

}  // namespace microslip::program
