// SPDX-License-Identifier: GPL-3.0-or-later
#include "hertz.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "microslip/halfspace/material_doubts.hpp"
#include "microslip/reference/line_contact.hpp"
#include "microslip/reference/point_contact.hpp"
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
  return {summed_curvature("contact.radius_1", one, "contact.radius_2", other),
          std::min(one, std::abs(other))};
}

void require_small(Scene& scene, double a, double radius, const char* name) {
  const double load = scene.number("contact.normal_load");
  require(a < radius, "contact.normal_load", load, [&] {
    return fmt::format(
        "a load under which the {}, {} mm by Hertz, is below the smaller radius, {} mm", name,
        format_short(a), format_short(radius));
  });
  if (a <= small_contact * radius) return;
  scene.warn(
      "contact.normal_load", load,
      fmt::format("the {}, {} mm, is more than a tenth of the smaller radius; Hertz's theory "
                  "is for less",
                  name, format_roughly(a)));
}

void warn_of_large_modulus(Scene& scene, const std::string& key, double shear_modulus,
                           double traction) {
  const std::string doubt = doubt_of_modulus(shear_modulus, traction);
  if (doubt.empty()) return;
  scene.warn(key, scene.text(key), doubt + "; moduli without a unit are in N/mm^2");
}

void warn_of_strain(Scene& scene, double peak, double shear_modulus) {
  const auto first_of = [&](std::initializer_list<const char*> keys) -> std::string {
    const auto* const found =
        std::ranges::find_if(keys, [&](const char* key) { return std::as_const(scene).has(key); });
    return found == keys.end() ? "" : *found;  // springs have no modulus
  };
  warn_of_large_modulus(scene, first_of({"material.shear_modulus", "material.youngs_modulus"}),
                        shear_modulus, peak);
  const std::string doubt = doubt_of_strain(peak, shear_modulus);
  if (doubt.empty()) return;
  const std::string key = first_of({"contact.peak_traction", "contact.bound_file",
                                    "contact.normal_load", "contact.bound_polynomial"});
  scene.warn(key, scene.text(key), doubt + "; numbers without a unit are in N, mm and N/mm^2");
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
