// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/thesis/edge_displacement.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "microslip/support/quadrature.hpp"

namespace microslip {

namespace {

using std::numbers::pi;

/// K(z - by) - K(z), without the cancellation of the difference next to full adhesion
double rise(const StripKernel& kernel, double z, double by) {
  if (by > z / 2) return kernel.displacement(z - by) - kernel.displacement(z);
  const auto decay = [&](double part) { return kernel.decay(z - part * by); };
  return by * boost::math::quadrature::gauss<double, 15>::integrate(decay, 0.0, 1.0);
}

// Displacement at the leading edge under sqrt(a^2 - x^2) less the same over the stick zone. With
// x = a cos(t), and likewise in the stick zone, the root at the edge turns into sin^2, and the
// kernel's logarithm with it into t^2 ln t.

double under_ellipses(const StripKernel& kernel, double half_width, const Carter& carter) {
  const double stick = carter.stick_ratio();
  const double sliding = carter.slip_ratio() * (1 + stick);
  const auto integrand = [&](double t) {
    const double half_sine = std::sin(t / 2);
    const double distance = 2 * half_width * half_sine * half_sine;
    const double sine = std::sin(t);
    if (distance == 0) return 0.0;
    const double to_stick = carter.slip_ratio() * distance;
    const double removed = stick > 0 ? stick * stick * rise(kernel, distance, to_stick) : 0;
    return sine * sine * (sliding * kernel.displacement(distance) - removed);
  };
  return half_width * half_width * integrate(integrand, 0, pi, 1e-13);
}

/// The integral of sin^2(t) ln(1 - cos(t)) over [0, pi] is (pi/2) (1/2 - ln 2).
double under_ellipses(const PlaneKernel& kernel, double half_width, const Carter& carter) {
  const double stick = carter.stick_ratio();
  const double factor = kernel.log_factor();
  const double whole = kernel.displacement(half_width / 2) - factor / 2;
  const double removed = stick > 0 ? stick * stick * std::log1p(-carter.slip_ratio()) : 0;
  return half_width * half_width * pi / 2 *
         (carter.slip_ratio() * (1 + stick) * whole + factor * removed);
}

}  // namespace

double edge_displacement(const Kernel& kernel, const Carter& carter) {
  const double a = carter.bound().half_width();
  const double slope = carter.bound().peak() / a;
  const auto under = [&](const auto& k) { return under_ellipses(k, a, carter); };
  return -carter.direction() * slope * visit_half_space(under, kernel);
}

}  // namespace microslip
