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

/// Radii of both bodies in the plane of rolling.
struct Radii {
  double curvature;  ///< reciprocal of the relative radius  [1/mm]
  double smaller;    ///< [mm]
};

/// Reads contact.radius_1 and contact.radius_2.
Radii read_radii(Scene& scene);

/// Warns of a shear modulus that no solid has, as of one in pascals.
/// \param key       that gives it
/// \param traction  largest one, see doubt_of_modulus()
void warn_of_large_modulus(Scene& scene, const std::string& key, double shear_modulus,
                           double traction = 0);

/// Warns of a bound that is large beside the shear modulus, by the key that gives it, or of a modulus
/// that no solid has, where the bound is small beside it. Normalised contacts have a modulus that no
/// solid has, and a bound of its size.
/// \param peak  of the bound  [N/mm^2]
void warn_of_strain(Scene& scene, double peak, double shear_modulus);

/// Refuses a half-width above a radius, and warns of one above a tenth of it.
/// \param a  half-width  [mm]
void require_small(Scene& scene, double a, double radius, const char* name = "half-width");

}  // namespace microslip
