// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "microslip/creep_table/creep_table_nodes.hpp"

namespace microslip {

/// A table as the bytes of a file in netCDF's classic format, with its layout, the formulas of
/// motions at its nodes, units, and its measured errors: docs/creep_tables.md.
/// \param history  what made it, for the attribute of that name
std::string file_of(const CreepTableNodes& nodes, const std::string& history);

/// \throws std::invalid_argument, in one line, for a file that is no table, is damaged, or has
///         numbers out of their ranges
CreepTableNodes read_creep_table(const std::string& bytes);

}  // namespace microslip
