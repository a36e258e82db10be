// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "suite.hpp"

namespace microslip::bench {

/// Times of CONTACT on the same problems.
const std::vector<Measurement>& peer_times();

/// The program version, machine and settings of these times.
const char* peer_machine();

}  // namespace microslip::bench
