// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "microslip/scene/scene.hpp"

namespace microslip {

/// The keys, in their order, whose values differ between two runs, and the keys that only one run
/// has. Lists are compared word by word, and numbers by value: "1.0  2" equals "1 2".
std::vector<std::string> changed_keys(const Parameters& before, const Parameters& after);

}  // namespace microslip
