// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <functional>
#include <string>

#include "microslip/program/run.hpp"

namespace microslip::program {

using Options = boost::program_options::options_description;
using Given = boost::program_options::variables_map;

/// Adds --scene and --set.
void add_scene_options(Options& options, const Program& program);

/// Adds --out, --quiet, --version and --help.
/// \param out  what it is
void add_common_options(Options& options, const std::string& default_out,
                        const std::string& out = "folder for the tables");

/// For parse: as many words as there are.
inline constexpr int any_number = -1;

/// \param argv   without the program's name, or with it as its first
/// \param word   the option that words without -- before them are for; with none, words are
///              rejected
/// \param words  how many of them there may be
/// \throws boost::program_options::error or std::invalid_argument
Given parse(const Options& options, int argc, const char* const* argv, const std::string& word = "",
            int words = 1);

/// Prints the output of --help or --version; false if neither is given.
bool answers(const Given& given, const Options& options, const std::string& name,
             const std::string& purpose);

Scene built_in_scene(const Program& program);

/// The scene of --scene, or the built-in scene, with the changes by --quick and --set.
Scene read_scene(const Program& program, const Given& given);

/// Shows progress on a terminal after two seconds, with rate and remaining time, unless told to be
/// quiet. The line ends when the last copy is gone.
Progress progress_on_terminal(const std::string& name, bool quiet);

/// A name as a shell takes it: in quotes if it has more than letters, digits and -._/.
std::string in_shell(const std::string& name);

/// Refuses a file that is there, which the option names.
/// \throws std::invalid_argument in one line
void require_new_file(const std::string& option, const std::filesystem::path& path);

/// The message of an exception, from microslip or a library, as one line of bounded length.
std::string one_line(const std::exception& error);

/// The exit status of an action: its return value; 2 for NotConverged and 1 for other exceptions,
/// with one line on stderr. Allocating too much memory is such an exception, see limit_memory().
int status_of(const std::string& name, const std::function<int()>& action);

}  // namespace microslip::program
