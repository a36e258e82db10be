// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "microslip/program/commands.hpp"
#include "microslip/support/nearest.hpp"
#include "microslip/support/shown.hpp"
#include "process.hpp"

namespace microslip::program {

namespace {

std::string list_of(const std::string& name, const std::vector<Command>& commands) {
  std::string text = "\n\nCommands; each has its own --help:";
  for (const Command& command : commands) {
    text += fmt::format("\n  {} {:<9} {}", name, command.name, command.purpose);
  }
  return text;
}

/// `help` and `help COMMAND`, as --help behind them.
int help(const Program& program, const std::vector<Command>& commands, int argc,
         const char* const* argv) {
  const char* option = "--help";
  const char* words[] = {argv[0], argc > 2 ? argv[2] : option, option};
  return dispatch(program, commands, argc > 2 ? 3 : 2, words);
}

}  // namespace

int dispatch(const Program& program, const std::vector<Command>& commands, int argc,
             const char* const* argv) {
  const std::string word = argc > 1 ? argv[1] : "";
  if (word == "help") return help(program, commands, argc, argv);
  const auto found = std::ranges::find(commands, word, &Command::name);
  if (found != commands.end()) return found->run(argc, argv);
  std::error_code unreadable;
  if (word.empty() || word.starts_with('-') || std::filesystem::exists(word, unreadable)) {
    Program listing = program;
    listing.question += list_of(program.name, commands);
    return run(listing, argc, argv);
  }
  return run_process(program.name, [&]() -> int {
    const std::vector<std::string> names = names_of(commands);
    throw std::invalid_argument(
        fmt::format("'{}': expected a scene's file that is there or a command{}; commands: {}",
                    shown(word), suggestion(nearest(word, names)), joined(names, ", ")));
  });
}

}  // namespace microslip::program
