// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "command_line.hpp"
#include "microslip/program/commands.hpp"
#include "microslip/scene/contact_input.hpp"
#include "microslip/support/shown.hpp"
#include "microslip/support/text.hpp"
#include "outputs.hpp"
#include "process.hpp"

namespace microslip::program {

namespace {

namespace options = boost::program_options;
namespace fs = std::filesystem;

/// An input file with a distance for each of a million elements has fewer bytes.
constexpr std::size_t most_input = std::size_t{1} << 26;

bool takes_direct(const Given& given) {
  const std::string scheme = given["scheme"].as<std::string>();
  if (scheme == "direct") return true;
  if (scheme == "remembered") return false;
  throw std::invalid_argument(
      fmt::format("--scheme '{}': expected remembered or direct", shown(scheme)));
}

int number_of_case(const Given& given) {
  if (given.count("case") == 0) return 0;
  const int number = given["case"].as<int>();
  if (number > 0) return number;
  throw std::invalid_argument(fmt::format("--case {}: expected a number from 1 on", number));
}

std::string text_of_input(const std::string& path) {
  try {
    return file_text(path, most_input);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", shown(path), error.what()));
  }
}

void list_cases(const std::string& path, bool direct) {
  const InputList list = cases_of_input(text_of_input(path), path, direct);
  for (const std::string& line : list.lines) std::cout << line << '\n';
  if (!list.error.empty()) throw std::invalid_argument(list.error);
}

void write_scene(const std::string& name, const std::string& to, const std::string& text) {
  const fs::path path(to);
  const fs::path parent = path.parent_path();
  write_files(parent.empty() ? "." : parent, {{path.filename(), text}});
  std::cout << "wrote " << to << "; solve it with: " << name << ' ' << in_shell(to) << '\n';
}

}  // namespace

int import_case(const std::string& name, int argc, const char* const* argv) {
  return run_process(name, [&] {
    Options known("Options of import");
    known.add_options()("input", options::value<std::string>(),
                        "the first word: an input file of CONTACT, as case.inp")(
        "case", options::value<int>(), "its number in the file (default: the only one)")(
        "list", "describe all cases, or say why they have no scene")(
        "scheme", options::value<std::string>()->default_value("remembered"),
        "remembered, microslip's own; or direct, CONTACT's on its elements")(
        "to", options::value<std::string>(), "file of the scene (default: standard output)")(
        "version", "print version and revision")("help", "print this");
    const Given given = parse(known, argc - 1, argv + 1, "input");
    if (answers(given, known, name + " import",
                "makes a scene of a case of an input file of CONTACT")) {
      return 0;
    }
    if (given.count("input") == 0) {
      throw std::invalid_argument("missing an input file of CONTACT, as case.inp");
    }
    const std::string path = given["input"].as<std::string>();
    const bool direct = takes_direct(given);
    const int number = number_of_case(given);
    if (given.count("list") != 0) {
      list_cases(path, direct);
      return 0;
    }
    if (given.count("to") != 0) require_new_file("--to", given["to"].as<std::string>());
    const ImportedScene scene =
        scene_of_input(text_of_input(path), path, {.number = number, .direct = direct});
    for (const std::string& note : scene.notes) std::cerr << name << ": " << note << '\n';
    if (given.count("to") == 0) {
      std::cout << scene.text;
    } else {
      write_scene(name, given["to"].as<std::string>(), scene.text);
    }
    return 0;
  });
}

}  // namespace microslip::program
