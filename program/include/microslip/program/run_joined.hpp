// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/program/run.hpp"

namespace microslip::program {

/// run(), except that a section `sweep` gives tables of all cases in one, with columns of what is
/// swept.
int run_joined(const Program& program, int argc, const char* const* argv);

}  // namespace microslip::program
