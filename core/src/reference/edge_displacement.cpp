// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/edge_displacement.hpp"

#include <cmath>
#include <numbers>

#include "microslip/support/quadrature.hpp"

namespace microslip {

namespace {

/// Displacement at its leading edge under the ellipse slope * sqrt(r^2 - (x - centre)^2), with
/// x = centre + r cos(t): the root at the edge turns into sin^2, and the kernel's logarithm with it
/// into t^2 ln t.
double under_ellipse(const Kernel& kernel, double radius, double slope) {
  if (radius == 0) return 0;
  const auto integrand = [&](double t) {
    const double half_sine = std::sin(t / 2);
    const double distance = 2 * radius * half_sine * half_sine;
    const double sine = std::sin(t);
    if (distance == 0) return 0.0;
    return sine * sine *
           std::visit([&](const auto& k) { return k.displacement(distance); }, kernel);
  };
  return slope * radius * radius * integrate(integrand, 0, std::numbers::pi, 1e-13);
}

}  // namespace

double edge_displacement(const Kernel& kernel, const Carter& carter) {
  const double a = carter.bound().half_width();
  const double slope = carter.bound().peak() / a;
  return -carter.direction() *
         (under_ellipse(kernel, a, slope) - under_ellipse(kernel, carter.stick_ratio() * a, slope));
}

}  // namespace microslip
