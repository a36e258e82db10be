// SPDX-License-Identifier: GPL-3.0-or-later
#include "hertz.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/reference/line_contact.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

/// A half-width above this part of the smaller radius is not small, as Hertz's theory wants it.
constexpr double small_contact = 0.1;

constexpr double most_friction = 10;

/// Reciprocal of the relative radius; 0 for a plane.
double read_curvature(Scene& scene, double radius) {
  if (!scene.has("contact.radius_2")) return 1 / radius;
  const double other = scene.number("contact.radius_2");
  require_positive("contact.radius_2", other == 0 ? 0 : std::abs(other));
  require(other > 0 || -other > radius, "contact.radius_2", other, [&] {
    return "a number > 0, or for a concave body one below -" + format_short(radius) +
           ", as its radius is larger than contact.radius_1";
  });
  return 1 / radius + 1 / other;
}

double smaller_radius(const Scene& scene, double radius, double curvature) {
  if (!scene.has("contact.radius_2")) return radius;
  return std::min(radius, std::abs(1 / (curvature - 1 / radius)));
}

}  // namespace

HertzBound read_loaded_contact(Scene& scene, const Material& material) {
  for (const char* other :
       {"contact.peak_traction", "contact.bound_polynomial", "contact.bound_file"}) {
    scene.at_most_one_of({"contact.normal_load", other});
  }
  const double load = scene.positive("contact.normal_load");
  const double radius = scene.positive("contact.radius_1");
  const double curvature = read_curvature(scene, radius);
  const double friction = scene.positive("contact.friction");
  require(friction <= most_friction, "contact.friction", friction,
          "a number above 0, at most " + format_short(most_friction));
  const LineContact contact(material, load, curvature);
  const double a = contact.half_width();
  const double least = smaller_radius(scene, radius, curvature);
  require(a < least, "contact.normal_load", load, [&] {
    return "a load under which the half-width, " + format_short(a) +
           " mm by Hertz, is below the smaller radius, " + format_short(least) + " mm";
  });
  if (a > small_contact * least) {
    scene.warn("contact.normal_load = " + format_short(load) + ": the half-width, " +
               format_roughly(a) +
               " mm, is more than a tenth of the smaller radius; Hertz's theory is for less");
  }
  const HertzBound bound(a, friction * contact.peak_pressure());
  scene.derive("contact.half_width", a);
  scene.derive("contact.peak_traction", bound.peak());
  return bound;
}

}  // namespace microslip
