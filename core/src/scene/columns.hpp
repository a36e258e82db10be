// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <iosfwd>
#include <optional>
#include <vector>

#include "microslip/scene/scene.hpp"

namespace microslip {

/// \return  the wanted columns, in their units, each with at least one value; an optional column
///          that is missing is empty
/// \throws std::invalid_argument in one line, with the line's number
std::vector<std::optional<Eigen::VectorXd>> read_columns(std::istream& in,
                                                         const std::vector<FileColumn>& wanted);

}  // namespace microslip
