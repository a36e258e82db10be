// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "microslip/reference/carter.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip::program {

/// Carter's solution of the scene that a table was made of: steady rolling of like bodies in plane
/// strain under Hertz's bound. Nothing of any other scene.
/// \param parameters  of the table; names that are no keys of scenes are left out
std::optional<Carter> exact_solution(const Parameters& parameters);

}  // namespace microslip::program
