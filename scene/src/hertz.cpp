// SPDX-License-Identifier: GPL-3.0-or-later
#include "hertz.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "microslip/reference/line_contact.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

/// Largest half-width, as a fraction of the smaller radius, at which Hertz's theory holds.
constexpr double small_contact = 0.1;

}  // namespace

Radii read_radii(Scene& scene) {
  const double one = scene.positive("contact.radius_1");
  if (!scene.has("contact.radius_2")) return {1 / one, one};
  const double other = scene.number("contact.radius_2");
  require_positive("contact.radius_2", std::abs(other));
  require(other > 0 || -other > one, "contact.radius_2", other, [&] {
    return fmt::format(
        "a number > 0, or for a concave body one below -{}, as its radius is larger than "
        "contact.radius_1",
        format_short(one));
  });
  return {1 / one + 1 / other, std::min(one, std::abs(other))};
}

void require_small(Scene& scene, double a, double radius) {
  const double load = scene.number("contact.normal_load");
  require(a < radius, "contact.normal_load", load, [&] {
    return fmt::format(
        "a load under which the half-width, {} mm by Hertz, is below the smaller radius, {} mm",
        format_short(a), format_short(radius));
  });
  if (a <= small_contact * radius) return;
  scene.warn("contact.normal_load", load,
             fmt::format("the half-width, {} mm, is more than a tenth of the smaller radius; "
                         "Hertz's theory is for less",
                         format_roughly(a)));
}

void warn_of_large_bound(Scene& scene, double peak, double shear_modulus) {
  constexpr double most_strain = 0.05;
  // N/mm^2; of rubber 1, and of diamond 5e5; normalised contacts may have any outside
  constexpr double least_modulus = 100, most_modulus = 1e6;
  const bool is_of_solid = shear_modulus >= least_modulus && shear_modulus <= most_modulus;
  if (!is_of_solid || peak <= most_strain * shear_modulus) return;
  const std::string key =
      scene.one_of({"contact.peak_traction", "contact.bound_file", "contact.normal_load"});
  scene.warn(key, scene.text(key),
             fmt::format("the largest traction, {} N/mm^2, is {} of the shear modulus, and strains "
                         "have to be small; numbers without a unit are in N, mm and N/mm^2",
                         format_roughly(peak), format_roughly(peak / shear_modulus)));
}

HertzBound read_loaded_contact(Scene& scene, const Material& material) {
  for (const char* other :
       {"contact.peak_traction", "contact.bound_polynomial", "contact.bound_file"}) {
    scene.at_most_one_of({"contact.normal_load", other});
  }
  const double load = scene.positive("contact.normal_load");
  const Radii radii = read_radii(scene);
  const double friction = read_friction(scene);
  const LineContact contact(material, load, radii.curvature);
  const double a = contact.half_width();
  require_small(scene, a, radii.smaller);
  const HertzBound bound(a, friction * contact.peak_pressure());
  scene.derive("contact.half_width", a);
  scene.derive("contact.peak_traction", bound.peak());
  return bound;
}

}  // namespace microslip
