// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "suite.hpp"

namespace microslip::bench {

/// Times of CONTACT on the same problems.
const std::vector<Measurement>& peer_times();

/// With what they were measured.
const char* peer_machine();

}  // namespace microslip::bench
