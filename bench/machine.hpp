// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/scene/table.hpp"

namespace microslip::bench {

/// Keeps this process, and those that it starts, on the core on which it is.
void stay_on_one_core();

/// The machine, compiler and flags, on which times depend besides the program.
Table machine_table();

}  // namespace microslip::bench
