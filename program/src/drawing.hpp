// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "microslip/scene/table.hpp"
#include "outputs.hpp"

namespace microslip::program {

/// A result that is drawn.
struct Result {
  std::filesystem::path folder;
  std::string name;  ///< as it was typed
  std::string kind;  ///< steady, ellipse, transient, history (of an ellipse), instants, cylinder,
                     ///< response, converge, sweep or curve
};

/// That two results are not drawn over one another. \throws std::invalid_argument
[[noreturn]] void throw_other_kind(const Result& result, const Result& first);

/// A table of a result. \throws std::invalid_argument that names the file
WrittenTable table_in(const std::filesystem::path& folder, const std::string& name);

/// A number of a cell; nothing for nan and words.
std::optional<double> number_of(const Cell& cell);

/// A table of which some columns have 0 where their numbers are nothing but rounding.
Table without_rounding(Table table, const std::vector<std::string>& columns);

/// Numbers from the least to the largest; none if it is empty.
struct Extent {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  std::set<double> values = {};

  void include(double value);

  /// How many different numbers lie within a range.
  std::size_t count(double from, double to) const;
};

/// A line of a figure.
struct Line {
  std::string label;
  std::string color;  ///< "#rrggbb"
  int dash = 1;       ///< gnuplot's type of dashes
  bool is_exact = false;
};

/// Number `i` of `count` colours that differ, also for the colour-blind; more than six are colours
/// of a scale from dark to light.
std::string color_of(std::size_t i, std::size_t count);

/// The colour of exact solutions.
inline constexpr const char* black = "#000000";

/// Whether a result ends in a contact that carries nothing, because it is lost or has no friction.
bool ends_without_contact(const Result& result);

/// Whether the bodies roll back at the end of a result with a history.
bool ends_backward(const Result& result);

/// Letters of a label that have room in the key.
inline constexpr std::size_t label_letters = 60;

/// A text of a figure without the middle of it, if it is longer than so many letters.
std::string fitted(const std::string& text, std::size_t letters);

/// The data of a figure.
struct Drawing {
  std::string kind;              ///< of the script, PROGRAM_KIND.gp
  std::vector<Line> lines = {};  ///< in the order of their numbers, from 1
  /// Each has a column `line`; none where the script takes the tables of the result as they are.
  std::vector<Table> tables = {};
  Parameters axes = {};     ///< names of the axes and what else the script asks for
  Extent horizontal = {};   ///< of the horizontal axis, or of the positions in the contact
  Extent history = {};      ///< of distances rolled, or of times; empty without a history
  std::string over = "q";   ///< what the axis of the history has: q, or t
  std::string unit = "mm";  ///< of the horizontal axis
};

/// Tractions, slip and histories of one scene or more, over one another, with exact solutions.
/// \param over  horizontal axis of histories: "q", the distance rolled, or "t", the time; empty: q
/// \throws std::invalid_argument for kinds that do not go together, and for times that are not
///                               there
Drawing drawing_of_scenes(const std::vector<Result>& results, const std::string& over);

/// Selects what a figure shows of a sweep, or of curves of creepage and force; all may be empty.
struct SweepView {
  std::string over;               ///< column of the horizontal axis
  std::string value;              ///< of the vertical one
  std::string by;                 ///< key that colours tell apart
  std::vector<std::string> only;  ///< "key=value": rows with that
};

/// A quantity over a key, with a line for each combination of the other ones.
/// \throws std::invalid_argument for columns that are not there, and too many lines
Drawing drawing_of_sweeps(const std::vector<Result>& results, const SweepView& view);

/// Files of the script of instants: the table `panels`, and of each panel its line, or of a map its
/// cells, outline and arrows.
/// \param over_time  whether titles have times in the place of distances
/// \param animated   whether all instants are drawn; otherwise as many as have room
/// \throws std::invalid_argument for a run without times, or without contact at any instant
std::vector<OutputFile> files_of_instants(const Result& result, bool over_time, bool animated);

/// Refuses an axis of a run that is neither empty nor q or t. \throws std::invalid_argument
void require_axis_of_run(const std::string& over);

/// That a run has no times. \throws std::invalid_argument
[[noreturn]] void throw_no_times(const Result& result);

/// Files of a drawing, as output_of makes them, into a folder.
void write_drawing(const Drawing& drawing, const std::filesystem::path& folder);

}  // namespace microslip::program
