// SPDX-License-Identifier: GPL-3.0-or-later
// A command line of `microslip sweep`, an argument a line. No file is read, so that --scene may
// name any.
#include <sstream>
#include <vector>

#include "reader.hpp"
#include "sweep_options.hpp"

MICROSLIP_READER(arguments) {
  using namespace microslip;
  std::istringstream lines(fuzz::text_of(data, size));
  std::vector<std::string> arguments{"sweep"};
  for (std::string line; std::getline(lines, line);) arguments.push_back(line);
  std::vector<const char*> argv;
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  const program::Program none{.name = "microslip",
                              .question = "",
                              .scene = "",
                              .quick = "",
                              .default_out = "out",
                              .key_options = {{"target-error", "target_error", ""}},
                              .prepare = {}};
  fuzz::accepts_or_rejects([&] {
    try {
      const program::Given given =
          program::parse(program::sweep_options(none), static_cast<int>(argv.size()), argv.data());
      Scene scene;
      for (const auto& one : given["set"].as<std::vector<std::string>>()) scene.set(one);
      program::sweep_settings(given);
    } catch (const boost::program_options::error& error) {
      throw std::invalid_argument(program::one_line(error));
    }
  });
  return 0;
}
