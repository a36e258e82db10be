// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <iosfwd>
#include <string>
#include <vector>

namespace microslip {

/// \param names  of the columns wanted
/// \return       as many, each with at least one value
/// \throws std::invalid_argument in one line, with the line's number
std::vector<Eigen::VectorXd> read_columns(std::istream& in, const std::vector<std::string>& names);

}  // namespace microslip
