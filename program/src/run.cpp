// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/program/run.hpp"

#include <unistd.h>

#include <boost/program_options.hpp>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "microslip/support/not_converged.hpp"
#include "outputs.hpp"
#include "provenance.hpp"

namespace microslip::program {

namespace {

namespace options = boost::program_options;

options::options_description described(const Program& program) {
  options::options_description all("Options");
  auto add = all.add_options();
  const std::string scene_default = program.scene.empty() ? " (required)" : " (default: built in)";
  add("scene", options::value<std::string>(),
      ("property tree in INFO format" + scene_default).c_str());
  add("set", options::value<std::vector<std::string>>()->default_value({}, ""),
      "key.sub=value, over the scene; an empty value removes the key; repeatable");
  add("out", options::value<std::string>()->default_value(program.default_out),
      "folder for the tables");
  if (!program.quick.empty()) add("quick", "a coarser version, in seconds");
  if (!program.scene.empty()) add("print-scene", "print the default scene and exit");
  add("quiet", "no progress");
  add("version", "print version and revision");
  add("help", "print this");
  return all;
}

Scene parse_text(const std::string& text, const std::string& name) {
  std::istringstream in(text);
  return Scene::parse(in, name);
}

/// \throws std::invalid_argument if it cannot be read
std::string file_text(const std::string& path) {
  std::ifstream in(path);
  std::ostringstream text;
  if (in && in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
  if (in.bad() || !in.is_open() || text.fail()) {
    throw std::invalid_argument(std::string("cannot read it: ") + std::strerror(errno));
  }
  return text.str();
}

Scene parse_file(const std::string& path) {
  const std::string text = [&] {
    try {
      return file_text(path);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("--scene " + path + ": " + error.what());
    }
  }();
  std::istringstream in(text);
  return Scene::parse(in, path, path.substr(0, path.find_last_of('/') + 1));
}

Scene read_scene(const Program& program, const options::variables_map& given) {
  if (program.scene.empty() && given.count("scene") == 0) {
    throw std::invalid_argument("missing option --scene FILE");
  }
  Scene scene = given.count("scene") != 0 ? parse_file(given["scene"].as<std::string>())
                                          : parse_text(program.scene, "built-in scene");
  if (given.count("quick") != 0) scene.overlay(parse_text(program.quick, "built-in quick scene"));
  for (const std::string& assignment : given["set"].as<std::vector<std::string>>()) {
    scene.set(assignment);
  }
  scene.read_files_by(file_text);
  return scene;
}

Progress progress_on_terminal(const Program& program, bool quiet) {
  if (quiet || isatty(STDERR_FILENO) == 0) return [](std::size_t, std::size_t) {};
  return [&program](std::size_t done, std::size_t total) {
    if (done < total && 100 * done / total == 100 * (done - 1) / total) return;
    std::cerr << '\r' << program.name << ": " << done << " of " << total
              << (done == total ? "\n" : "") << std::flush;
  };
}

void run_scene(const Program& program, Scene& scene, const options::variables_map& given, int argc,
               const char* const* argv) {
  const auto start = std::chrono::steady_clock::now();
  const auto work = program.prepare(scene);
  scene.reject_unread();
  const std::vector<Table> tables = work(progress_on_terminal(program, given.count("quiet") != 0));
  std::vector<OutputFile> files;
  for (const Table& table : tables) {
    std::ostringstream text;
    table.write(text, program.name, scene.parameters());
    files.push_back({table.name() + ".tsv", text.str()});
  }
  files.push_back({"provenance.txt",
                   provenance(program.name, argc, argv, std::chrono::steady_clock::now() - start)});
  write_files(given["out"].as<std::string>(), files);
}

int run_or_throw(const Program& program, int argc, const char* const* argv) {
  const options::options_description known = described(program);
  options::variables_map given;
  options::store(options::command_line_parser(argc, argv)
                     .options(known)
                     .positional({})
                     .style(options::command_line_style::default_style ^
                            options::command_line_style::allow_guessing)
                     .run(),
                 given);
  options::notify(given);
  if (given.count("help") != 0) {
    std::cout << program.name << ": " << program.question << "\n\n" << known;
    return 0;
  }
  if (given.count("version") != 0) {
    std::cout << version_line(program.name) << '\n';
    return 0;
  }
  if (given.count("print-scene") != 0) {
    std::cout << program.scene;
    return 0;
  }
  Scene scene = read_scene(program, given);
  run_scene(program, scene, given, argc, argv);
  return 0;
}

}  // namespace

int run(const Program& program, int argc, const char* const* argv) {
  const auto fail = [&](const std::exception& error, int status) {
    std::cerr << program.name << ": " << error.what() << '\n';
    return status;
  };
  try {
    return run_or_throw(program, argc, argv);
  } catch (const NotConverged& error) {
    return fail(error, 2);
  } catch (const std::exception& error) {
    return fail(error, 1);
  }
}

}  // namespace microslip::program
