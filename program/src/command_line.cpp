// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "microslip/program/memory.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/shown.hpp"
#include "microslip/support/text.hpp"
#include "provenance.hpp"

namespace microslip::program {

namespace {

namespace options = boost::program_options;

/// Number of bytes; a list of all keys of a model takes some hundred.
constexpr std::size_t longest_message = 900;

Scene parse_text(const std::string& text, const std::string& name) {
  std::istringstream in(text);
  return Scene::parse(in, name);
}

/// Whether a line consists of numbers and the word MODULE, or of names of control digits, as input
/// files of CONTACT have them.
bool is_of_contact(std::string_view text) {
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.size(), rest.find('\n'));
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(rest.size(), end + 1));
    if (line.find("P-B-T-N-F-S") != std::string_view::npos) return true;
    const std::size_t word = line.find_first_not_of(" \t0123456789");
    if (word != std::string_view::npos && line.find_first_of("0123456789") < word &&
        line.substr(word).starts_with("MODULE")) {
      return true;
    }
  }
  return false;
}

Scene parse_file(const std::string& path) {
  const std::string text = [&] {
    try {
      return file_text(path, Scene::most_text);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("--scene {}: {}", shown(path), error.what()));
    }
  }();
  if (is_of_contact(text)) {
    throw std::invalid_argument(
        fmt::format("--scene {}: expected a scene of microslip, found an input file of CONTACT; "
                    "'microslip import {}' makes one of it",
                    shown(path), shown(in_shell(path))));
  }
  std::istringstream in(text);
  return Scene::parse(in, path, path.substr(0, path.find_last_of('/') + 1));
}

/// The first word behind those that a command takes.
/// \param words  number of those
std::string stray_word(const Options& options, int argc, const char* const* argv, int words) {
  const auto parsed = options::command_line_parser(argc, argv)
                          .options(options)
                          .style(options::command_line_style::default_style ^
                                 options::command_line_style::allow_guessing)
                          .run();
  for (const auto& option : parsed.options) {
    if (option.position_key >= words) return option.value.front();
  }
  return "";
}

}  // namespace

void add_scene_options(Options& options, const Program& program) {
  const std::string scene_default = program.scene.empty() ? " (required)" : " (default: built in)";
  options.add_options()(
      "scene", options::value<std::string>(),
      ("file of the scene: keys and values, in INFO format" + scene_default).c_str())(
      "set", options::value<std::vector<std::string>>()->default_value({}, ""),
      "section.key=value, overrides the scene; an empty value removes the key; repeatable");
  for (const auto& [name, key, help] : program.key_options) {
    options.add_options()(name.c_str(), options::value<std::string>(), help.c_str());
  }
}

void add_common_options(Options& options, const std::string& default_out, const std::string& out) {
  options.add_options()("out", options::value<std::string>()->default_value(default_out),
                        out.c_str())("quiet", "no progress, and no line about the result")(
      "version", "print version and revision")("help", "print this");
}

Given parse(const Options& options, int argc, const char* const* argv, const std::string& word,
            int words) {
  Given given;
  options::positional_options_description positional;
  if (!word.empty()) positional.add(word.c_str(), words);
  try {
    options::store(options::command_line_parser(argc, argv)
                       .options(options)
                       .positional(positional)
                       .style(options::command_line_style::default_style ^
                              options::command_line_style::allow_guessing)
                       .run(),
                   given);
    options::notify(given);
  } catch (const options::too_many_positional_options_error&) {
    const std::string stray = stray_word(options, argc, argv, word.empty() ? 0 : words);
    throw std::invalid_argument(
        fmt::format("'{}': expected no further word; a value with blanks is in quotes, as in "
                    "--set 'load.creepage=2 %'",
                    shown(stray)));
  } catch (const options::error_with_option_name& error) {
    // Boost's message is a template, and filling in a name that is a placeholder never ends.
    const std::string name = error.get_option_name();
    if (name.find('%') == std::string::npos) throw;
    throw std::invalid_argument(
        fmt::format("option '{}': expected one that --help lists", shown(name)));
  }
  return given;
}

bool answers(const Given& given, const Options& options, const std::string& name,
             const std::string& purpose) {
  const bool help = given.count("help") != 0;
  if (help) {
    std::cout << name << ": " << purpose << "\n\n" << options;
  } else if (given.count("version") != 0) {
    std::cout << version_line(name) << '\n';
  }
  return help || given.count("version") != 0;
}

Scene built_in_scene(const Program& program) {
  return parse_text(program.scene, "built-in study.info");
}

Scene read_scene(const Program& program, const Given& given) {
  if (program.scene.empty() && given.count("scene") == 0) {
    throw std::invalid_argument(fmt::format(
        "missing a scene: expected its file, as in '{} scene.info'; see --help", program.name));
  }
  Scene scene = given.count("scene") != 0 ? parse_file(given["scene"].as<std::string>())
                                          : built_in_scene(program);
  if (given.count("quick") != 0) scene.overlay(parse_text(program.quick, "built-in quick.info"));
  for (const std::string& assignment : given["set"].as<std::vector<std::string>>()) {
    scene.set(assignment);
  }
  for (const auto& [name, key, help] : program.key_options) {
    if (given.count(name) != 0) scene.set(fmt::format("{}={}", key, given[name].as<std::string>()));
  }
  scene.read_files_by([](const std::string& path) { return file_text(path); });
  return scene;
}

std::string in_shell(const std::string& name) {
  const auto is_plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("-._/").find(c) != std::string_view::npos;
  };
  if (!name.starts_with('-') && std::ranges::all_of(name, is_plain)) return name;
  std::string quoted = name.starts_with('-') ? "'./" : "'";
  for (const char c : name) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

void require_new_file(const std::string& option, const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return;
  throw std::invalid_argument(
      fmt::format("{} '{}': expected a file that is not there yet", option, shown(path.string())));
}

std::string one_line(const std::exception& error) {
  std::string text = error.what();
  if (text.find("expected only one of '") != std::string::npos)
    text += "; --set KEY= takes one away";
  return shown(text, longest_message);
}

int status_of(const std::string& name, const std::function<int()>& action) {
  const auto fail = [&](const std::exception& error, int status) {
    std::cerr << name << ": " << one_line(error) << '\n';
    return status;
  };
  try {
    limit_memory();
    return action();
  } catch (const NotConverged& error) {
    return fail(error, 2);
  } catch (const std::bad_alloc&) {
    return fail(std::runtime_error("not enough memory"), 1);
  } catch (const std::exception& error) {
    return fail(error, 1);
  }
}

}  // namespace microslip::program
