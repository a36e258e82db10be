// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "microslip/scene/scene.hpp"

namespace microslip {

/// The keys, in their order, to which two runs resolved other values, and those that only one of
/// them has. Lists are compared word by word, and numbers by their value: "1.0  2" is "1 2".
std::vector<std::string> changed_keys(const Parameters& before, const Parameters& after);

}  // namespace microslip
