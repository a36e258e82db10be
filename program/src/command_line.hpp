// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/program_options.hpp>
#include <functional>
#include <string>

#include "microslip/program/run.hpp"

namespace microslip::program {

using Options = boost::program_options::options_description;
using Given = boost::program_options::variables_map;

/// Adds --scene and --set.
void add_scene_options(Options& options, const Program& program);

/// Adds --out, --quiet, --version and --help.
void add_common_options(Options& options, const std::string& default_out);

/// \param argv  without the program's name, or with it as its first
/// \throws boost::program_options::error in one line
Given parse(const Options& options, int argc, const char* const* argv);

/// Prints what --help or --version asks for; false if neither is given.
bool answers(const Given& given, const Options& options, const std::string& name,
             const std::string& purpose);

/// The scene of --scene, or the built-in one, with what --quick and --set change in it.
Scene read_scene(const Program& program, const Given& given);

/// \throws std::invalid_argument if it cannot be read
std::string file_text(const std::string& path);

/// Shows progress on a terminal, unless told to be quiet.
Progress progress_on_terminal(const std::string& name, bool quiet);

/// The exit status of an action: what it returns; 2 for NotConverged and 1 for other exceptions,
/// with one line on stderr.
int status_of(const std::string& name, const std::function<int()>& action);

}  // namespace microslip::program
