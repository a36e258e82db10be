// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>

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

/// With two digits, in the largest unit of which there is one at least.
template <std::size_t count>
std::string in_units(double value, const std::array<Unit, count>& units) {
  std::ostringstream text;
  const auto fits = [&](const Unit& unit) { return value >= unit.size; };
  auto unit = std::find_if(units.begin(), units.end(), fits);
  if (unit == units.end()) --unit;
  const double shown = value / unit->size;
  text << (shown < 100 ? std::setprecision(2) : std::setprecision(0))
       << (shown < 100 ? std::defaultfloat : std::fixed) << shown << ' ' << unit->name;
  return text.str();
}

std::string bytes(double value) {
  constexpr std::array<Unit, 3> units{{{1e9, "GB"}, {1e6, "MB"}, {1e3, "kB"}}};
  return in_units(value, units);
}

std::string time(double seconds) {
  constexpr std::array<Unit, 4> units{{{3600, "h"}, {60, "min"}, {1, "s"}, {1e-3, "ms"}}};
  return in_units(seconds, units);
}

std::string operations(double value) {
  std::ostringstream text;
  text << std::setprecision(2) << value;
  return text.str();
}

void print_keys(const Parameters& parameters) {
  std::size_t names = 0, values = 0;
  const auto with_unit = [](const auto& parameter) {
    const std::string unit = unit_of_key(parameter.first);
    return parameter.second + (unit == "1" ? "" : " " + unit);
  };
  for (const auto& parameter : parameters) {
    names = std::max(names, parameter.first.size());
    values = std::max(values, with_unit(parameter).size());
  }
  for (const auto& parameter : parameters) {
    const auto key = std::ranges::find(keys_of_scenes(), parameter.first, &Key::name);
    std::cout << "  " << std::left << std::setw(static_cast<int>(names)) << parameter.first << "  "
              << std::setw(static_cast<int>(values)) << with_unit(parameter);
    if (key != keys_of_scenes().end()) std::cout << "  " << key->meaning;
    std::cout << '\n';
  }
}

void print_lines(const std::string& title, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  std::cout << '\n' << title << '\n';
  for (const std::string& line : lines) std::cout << "  " << line << '\n';
}

/// \param cases  how many scenes of that work there are, and the most memory that one takes
void print_cost(double work, double memory, std::size_t cases) {
  std::vector<std::string> lines;
  if (std::isfinite(work)) {
    lines.push_back("about " + operations(work) + " operations, " +
                    time(work * seconds_per_operation) + " on one core" +
                    (cases > 1 ? " for all cases" : "") + "; within a factor of five");
  } else {
    lines.push_back("as many operations as the error needs: from a millisecond on");
  }
  lines.push_back("at most " + bytes(memory + 12e6) + " of memory" +
                  (cases > 1 ? " a case at once" : "") + "; " + bytes(available_memory()) +
                  " are available");
  print_lines("Cost", lines);
}

void print(const Scene& scene, const Preview& preview, std::size_t cases) {
  std::cout << preview.explanation.title << (cases > 1 ? ", the first case:" : "") << "\n\n";
  print_keys(scene.parameters());
  print_lines("What follows", preview.explanation.consequences);
  print_lines("Not modelled", preview.explanation.not_modelled);
}

}  // namespace

int explain(const Program& program, const std::function<Preview(Scene&)>& preview, int argc,
            const char* const* argv) {
  return run_process(program.name, [&] {
    Options known("Options of explain");
    add_scene_options(known, program);
    known.add_options()("version", "print version and revision")("help", "print this");
    const Given given = parse(known, argc - 1, argv + 1, "scene");
    if (answers(
            given, known, program.name + " explain",
            "says what a scene models, what it does not, and at which cost, and solves nothing")) {
      return 0;
    }
    const Scene read = read_scene(program, given);
    const auto is_swept = [](const std::string& key) { return key.starts_with("sweep."); };
    const std::vector<std::string> keys = read.keys();
    const bool has_sweep = std::any_of(keys.begin(), keys.end(), is_swept);
    const std::optional<Sweep> sweep = has_sweep ? std::optional<Sweep>(read) : std::nullopt;
    const std::size_t cases = sweep ? sweep->size() : 1;
    double work = 0, memory = 0;
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < cases; ++i) {
      Scene scene = sweep ? sweep->scene(i) : read;
      const Preview seen = preview(scene);
      scene.reject_unread();
      if (i == 0) {
        if (sweep) std::cout << cases << " cases of: ";
        print(scene, seen, cases);
      }
      work += seen.work;
      memory = std::max(memory, seen.memory);
      for (const std::string& line : scene.warnings()) {
        if (std::find(warnings.begin(), warnings.end(), line) == warnings.end()) {
          warnings.push_back(line);
        }
      }
    }
    print_cost(work, memory, cases);
    print_lines("Warnings", warnings);
    return 0;
  });
}

}  // namespace microslip::program
