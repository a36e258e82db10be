// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/creep_force_laws.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

double CreepForceContact::size() const { return std::sqrt(half_width * lateral_half_width); }

Vector2d linear_creep_force(const CreepForceContact& contact, const Vector3d& motion) {
  const auto& [c11, c22, c23, c32, c33] = contact.coefficients;
  const double c = contact.size();
  return -contact.shear_modulus * c * c *
         Vector2d(c11 * motion[0], c22 * motion[1] + c23 * c * motion[2]);
}

Vector2d vermeulen_johnson(const CreepForceContact& contact, const Vector3d& motion) {
  const Vector2d linear = linear_creep_force(contact, motion);
  const double size = linear.norm();
  if (size == 0) return linear;
  const double left = 1 - std::min(1.0, size / (3 * contact.full_sliding));
  return contact.full_sliding * (1 - left * left * left) * linear / size;
}

namespace {

/// Polach's size of the force by spin, over 9/16 mu F_n; K_M of his paper with its sign turned.
/// \param epsilon  gradient of the stress by spin, >= 0
double spin_function(double epsilon) {
  const double delta = (epsilon * epsilon - 1) / (epsilon * epsilon + 1);
  const double falling = delta * delta * (0.5 - delta / 3) - 1.0 / 6;
  return epsilon * falling + std::pow(std::max(0.0, 1 - delta * delta), 1.5) / 3;
}

}  // namespace

Vector2d polach(const CreepForceContact& contact, const Vector3d& motion) {
  const auto& [c11, c22, c23, c32, c33] = contact.coefficients;
  const double a = contact.half_width, b = contact.lateral_half_width, c = contact.size();
  const double stiffness = contact.shear_modulus * c / contact.full_sliding;
  const double xi = motion[0], eta = motion[1], phi = motion[2];
  // Spin counts as lateral creepage of the leading edge where it adds to it.
  const double edge = eta + phi * a;
  const double lateral = std::abs(edge) > std::abs(eta) ? edge : eta;
  const double total = std::hypot(xi, lateral), creepage = std::hypot(xi, eta);
  if (total == 0) return Vector2d::Zero();
  Vector2d force = Vector2d::Zero();
  if (creepage > 0) {
    const double coefficient = std::hypot(c11 * xi, c22 * eta) / creepage;
    const double epsilon = pi / 4 * stiffness * c * coefficient * total;
    const double size = 2 / pi * (epsilon / (1 + epsilon * epsilon) + std::atan(epsilon));
    force = size / total * Vector2d(xi, eta);
  }
  const double slenderness = 1 + 6.3 * (1 - std::exp(-a / b));
  const double epsilon = 8.0 / 3 * stiffness * b * c23 * std::abs(lateral) / slenderness;
  force[1] += 9.0 / 16 * a * slenderness * spin_function(epsilon) * phi / total;
  return -contact.full_sliding * force;
}

namespace {

/// 1/L of the components of a motion, so that p grows by slip/L a length  [N/mm^3].
Vector3d stiffnesses(const CreepForceContact& contact, const Vector3d& motion,
                     Flexibilities flexibilities) {
  const auto& [c11, c22, c23, c32, c33] = contact.coefficients;
  const double a = contact.half_width, c = contact.size(), G = contact.shear_modulus;
  const Vector3d inverse(3 * G * c11 / (8 * a), 3 * G * c22 / (8 * a),
                         4 * G * c * c23 / (pi * a * a));
  const Vector3d weights = motion.cwiseProduct(Vector3d(1, 1, c)).cwiseAbs();
  if (flexibilities == Flexibilities::three || weights.isZero(0)) return inverse;
  return Vector3d::Constant(weights.norm() / weights.dot(inverse.cwiseInverse()));
}

}  // namespace

Vector3d fastsim(const CreepForceContact& contact, const Vector3d& motion,
                 Flexibilities flexibilities, Index cells) {
  require(cells >= 1, "cells", static_cast<double>(cells), "a whole number >= 1");
  const double a = contact.half_width, b = contact.lateral_half_width;
  const Vector3d growth = motion.cwiseProduct(stiffnesses(contact, motion, flexibilities));
  const double peak = 2 * contact.full_sliding / (pi * a * b);
  const double height = 2 * b / static_cast<double>(cells);
  Vector3d sum = Vector3d::Zero();
  for (Index k = 0; k < cells; ++k) {
    const double y = -b + (static_cast<double>(k) + 0.5) * height;
    const double square = 1 - y * y / (b * b), edge = a * std::sqrt(square);
    const double width = 2 * edge / static_cast<double>(cells);
    Vector2d traction = Vector2d::Zero();
    for (Index i = 0; i < cells; ++i) {
      // The traction at the trailing side of the element by the slip at its middle, and at the middle.
      const double middle = edge - (static_cast<double>(i) + 0.5) * width;
      const Vector2d rate(growth[0] - growth[2] * y, growth[1] + growth[2] * middle);
      const auto within = [&](const Vector2d& p, double x) {
        const double bound = std::max(0.0, peak * (square - x * x / (a * a)));
        return p.norm() > bound ? Vector2d(p * (bound / p.norm())) : p;
      };
      const Vector2d at_middle = within(traction - rate * (width / 2), middle);
      traction = within(traction - rate * width, middle - width / 2);
      sum += width * height *
             Vector3d(at_middle[0], at_middle[1], middle * at_middle[1] - y * at_middle[0]);
    }
  }
  return sum;
}

}  // namespace microslip
