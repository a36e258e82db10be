// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// How a case of an input file of CONTACT becomes a scene.
struct InputImport {
  int number = 0;       ///< of the case, from 1 in the order of the file; 0 for the only one
  bool direct = false;  ///< CONTACT's own scheme on its elements, not microslip's
};

/// A scene of a case.
struct ImportedScene {
  std::string text;                ///< in INFO format; read_model() accepts it
  std::vector<std::string> notes;  ///< on what it leaves out or changes, with file and line
};

/// A scene of a case of an input file of CONTACT (E. Vollebregt's program, open source version of
/// 2025): of its module 3, a contact of Hertz, an ellipse or a strip, of quasi-identical elastic
/// bodies with Coulomb's friction; a shift, steps that begin with a shift or at rest, or steady
/// rolling. Steps that continue a case (P = 0) are a run with all cases before them.
/// Source of the format: user guide of CONTACT, version of 2025, appendix on the input file.
/// \param text  of the file, with line ends LF
/// \param name  of the file, for messages
/// \throws std::invalid_argument in one line, with file, line, name and value and what is accepted,
///         if the file is not of this format, the case is not there or no scene can say it
ImportedScene scene_of_input(std::string_view text, const std::string& name,
                             const InputImport& import);

/// The cases of an input file of CONTACT.
struct InputList {
  std::vector<std::string> lines;  ///< for each case what it is, or why it has no scene
  std::string error = "";          ///< where the file is not of this format; empty if all of it is
};

/// Describes all cases of an input file of CONTACT, up to an error of the format.
/// \param text, name, direct  as above
InputList cases_of_input(std::string_view text, const std::string& name, bool direct);

}  // namespace microslip
