// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/material.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip {

/// The bound of a contact from contact.normal_load, radius_1, radius_2 (by default a plane) and
/// friction, by Hertz's theory. The bound's half-width and peak become derived parameters of the
/// scene.
/// \throws BadParameter for keys or values that do not fit together
HertzBound read_loaded_contact(Scene& scene, const Material& material);

}  // namespace microslip
