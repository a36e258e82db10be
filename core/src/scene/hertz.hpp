// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/material.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip {

/// The bound of a contact from contact.normal_load, radius_1, radius_2 (a plane) and friction, by
/// Hertz. Its half-width and peak are derived parameters of the scene.
/// \throws BadParameter for keys and values that do not go together
HertzBound read_loaded_contact(Scene& scene, const Material& material);

}  // namespace microslip
