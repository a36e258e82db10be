// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "microslip/scene/table.hpp"

namespace microslip::program {

/// One line about a result, for a terminal: forces, motions, part of full sliding and method of a
/// summary; how many claims have which verdict; and the folder.
/// \param program  that made the tables
std::string result_line(const std::string& program, const std::vector<Table>& tables,
                        const std::string& folder);

}  // namespace microslip::program
