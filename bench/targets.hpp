// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "growth.hpp"
#include "microslip/scene/table.hpp"

namespace microslip::bench {

/// Targets and measured values; targets without a measurement are left out.
/// \param memory  see memory_table
Table targets_table(const std::vector<Series>& series, const Table& memory);

}  // namespace microslip::bench
