// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/scene/scene.hpp"

namespace microslip {

/// Columns of a table.
struct ReadColumns {
  /// The wanted columns, in their units, each with at least one value; an optional column that is
  /// missing is empty.
  std::vector<std::optional<Eigen::VectorXd>> wanted;
  /// Names of columns that may be meant for an optional one: nobody wants them, and they do not
  /// begin with _. Empty if no column is optional.
  std::vector<std::string> unused = {};
};

/// Reads a table as TableText has it. A unit stands behind its name, in brackets or parentheses.
/// \throws std::invalid_argument in one line, with the line's number; also for a column whose name
///         is nearly the name of an optional column
ReadColumns read_columns(std::string_view text, const std::vector<FileColumn>& wanted);

/// The names of all columns, without units. \throws std::invalid_argument as read_columns
std::vector<std::string> column_names(std::string_view text);

/// A name and its unit, as "t [s]", "t[s]" and "t (s)" have it: empty if there is none, and 1 for
/// -.
struct NamedUnit {
  std::string name;
  std::string unit = "";
};

/// \param text  of which parentheses belong to the name if there is no unit in them
NamedUnit name_with_unit(const std::string& text);

/// A column whose cells may be words.
struct TextColumn {
  std::string name;
  std::string unit;  ///< empty if there is none
  std::vector<std::string> cells;
};

/// All columns, each with at least one cell. Numbers have a decimal point, also if the table has
/// decimal commas. \throws std::invalid_argument as read_columns
std::vector<TextColumn> read_text_columns(std::string_view text);

}  // namespace microslip
