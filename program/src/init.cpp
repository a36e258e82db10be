// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "command_line.hpp"
#include "microslip/program/commands.hpp"
#include "microslip/support/nearest.hpp"
#include "microslip/support/shown.hpp"
#include "outputs.hpp"
#include "process.hpp"

namespace microslip::program {

namespace {

namespace options = boost::program_options;
namespace fs = std::filesystem;

const Template& chosen(const std::vector<Template>& templates, const Given& given) {
  const std::vector<std::string> names = names_of(templates);
  const std::string known = "; expected " + joined(names, ", ");
  if (given.count("kind") == 0) throw std::invalid_argument("missing the kind of scene" + known);
  const std::string kind = given["kind"].as<std::string>();
  const auto found = std::ranges::find(templates, kind, &Template::name);
  if (found != templates.end()) return *found;
  throw std::invalid_argument(
      fmt::format("no scene '{}'{}{}", shown(kind), suggestion(nearest(kind, names)), known));
}

}  // namespace

int init(const std::string& name, const std::vector<Template>& templates, int argc,
         const char* const* argv) {
  return run_process(name, [&] {
    Options known("Options of init");
    known.add_options()("kind", options::value<std::string>(),
                        ("the first word: " + joined(names_of(templates), ", ")).c_str())(
        "out", options::value<std::string>(), "file (default: KIND.info); - for standard output")(
        "version", "print version and revision")("help", "print this");
    const Given given = parse(known, argc - 1, argv + 1, "kind");
    if (answers(given, known, name + " init", "writes a commented scene to start from")) return 0;
    const Template& scene = chosen(templates, given);
    const std::string out =
        given.count("out") != 0 ? given["out"].as<std::string>() : scene.name + ".info";
    if (out == "-") {
      std::cout << scene.text;
      return 0;
    }
    const fs::path parent = fs::path(out).parent_path();
    const fs::path folder = parent.empty() ? "." : parent;
    std::vector<OutputFile> files{{fs::path(out).filename(), scene.text}};
    if (!scene.table.empty()) files.push_back({scene.name + ".tsv", scene.table});
    for (const OutputFile& file : files) {
      require_new_file("--out", parent / file.name);
    }
    write_files(folder, files);
    const std::string command = scene.name == "sweep" ? name + " sweep " : name + " ";
    const std::string table =
        scene.table.empty() ? "" : " and " + (parent / files[1].name).string();
    std::cout << "wrote " << out << table << "; solve it with: " << command << in_shell(out)
              << '\n';
    return 0;
  });
}

}  // namespace microslip::program
