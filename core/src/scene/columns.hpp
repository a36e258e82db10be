// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <iosfwd>
#include <optional>
#include <string>
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

/// \throws std::invalid_argument in one line, with the line's number; also for a column whose name
///         is nearly the name of an optional column
ReadColumns read_columns(std::istream& in, const std::vector<FileColumn>& wanted);

/// A column whose cells may be words.
struct TextColumn {
  std::string name;
  std::string unit;  ///< empty if there is none
  std::vector<std::string> cells;
};

/// All columns, each with at least one cell. Cells are separated by tabs if the names are, and may
/// then have blanks; else by blanks or tabs.
/// \throws std::invalid_argument as read_columns
std::vector<TextColumn> read_text_columns(std::istream& in);

}  // namespace microslip
