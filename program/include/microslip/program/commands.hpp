// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "microslip/program/run.hpp"
#include "microslip/scene/explanation.hpp"

namespace microslip::program {

/// A word after the program's name, for what is not a run.
struct Command {
  std::string name;
  std::string purpose;  ///< a line of --help
  std::function<int(int argc, const char* const* argv)> run;
};

/// Runs the command that argv[1] names; runs the program itself if argv[1] is an option, a file, or
/// missing. The program's --help lists the commands. Returns the exit status; 1 for an unknown
/// word, with one line on stderr that names the nearest command.
int dispatch(const Program& program, const std::vector<Command>& commands, int argc,
             const char* const* argv);

/// \file
/// In all following functions, argv[1] is the command's name.

/// A scene to start from.
struct Template {
  std::string name;
  std::string text;
  std::string table = "";  ///< that it reads, as NAME.tsv beside it; empty if it reads none
};

/// Writes a template as a file, with its table beside it; neither file may exist before. The option
/// `--out -` prints the scene instead. Returns the exit status: 0; 1 for bad input or a failed
/// write.
int init(const std::string& name, const std::vector<Template>& templates, int argc,
         const char* const* argv);

/// Makes a scene of a case of an input file of CONTACT, on standard output or in the file of `--to`,
/// which may not exist before; `--list` prints a line for each case instead. What a scene leaves out
/// is told on stderr. Returns the exit status: 0; 1 for bad input, a case without a scene or a
/// failed write.
int import_case(const std::string& name, int argc, const char* const* argv);

/// Prints all keys of scenes, with units, meanings and accepted values.
int keys(const std::string& name, int argc, const char* const* argv);

/// Forecasts for a scene before it is solved.
struct Preview {
  Explanation explanation;
  double work;    ///< operations, nan if not known
  double memory;  ///< [bytes]
};

/// Explains a scene, or a scene with a sweep, and prints its expected cost.
/// \param preview  as Program::prepare, without a check of the memory
int explain(const Program& program, const std::function<Preview(Scene&)>& preview, int argc,
            const char* const* argv);

/// Draws the figures of a result with the scripts in share/microslip/plots of the installation:
/// NAME_KIND.gp of this program, the kind by the tables that are there, or all STUDY_*.gp.
int plot(const std::string& name, int argc, const char* const* argv);

/// Makes a table of creep forces (CreepTable) as a file, with its measured errors, in parts that are
/// kept beside it until all are done. Returns the exit status as sweep().
int creep_table(const std::string& name, int argc, const char* const* argv);

}  // namespace microslip::program
