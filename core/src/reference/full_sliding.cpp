// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/full_sliding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/support/gauss_points.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

/// Beyond this distance of the pole, over the half-widths, all slip has one direction.
constexpr double farthest_pole = 1e6;

/// The sums over rays from the pole. Lengths across and along are over the half-widths, so that the
/// ellipse is the unit circle, and a b = 1.
class Rays {
 public:
  Rays(double ratio, const Vector2d& pole, double sense)
      : half_widths_(std::sqrt(ratio), 1 / std::sqrt(ratio)), pole_(pole), sense_(sense) {}

  /// Adds the rays at an angle.
  /// \param first, second  integrals of the bound, and of it times the distance from the pole, over
  ///                       the area of the rays
  void add(double angle, double first, double second) {
    const Vector2d ray(std::cos(angle), std::sin(angle));
    const Vector2d there = ray.cwiseProduct(half_widths_);
    const Vector2d slip = sense_ * Vector2d(-there.y(), there.x()).normalized();
    sum_.head<2>() -= first * slip;
    sum_[2] -= first * cross(pole_.cwiseProduct(half_widths_), slip) + second * cross(there, slip);
  }

  /// Over full sliding.
  Vector3d sum() const { return sum_ / (2 * pi / 3); }

 private:
  static double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  }

  Vector2d half_widths_, pole_;
  double sense_;
  Vector3d sum_ = Vector3d::Zero();
};

/// With u = p + rho along a ray, the bound is (q^2 - u^2)^(1/2), from u = p to q.
void add_from_inside(Rays& rays, const Vector2d& pole) {
  constexpr int angles = 512;
  for (int k = 0; k < angles; ++k) {
    const double angle = 2 * pi * k / angles;
    const double p = pole.dot(Vector2d(std::cos(angle), std::sin(angle)));
    const double height = std::max(0.0, 1 - pole.squaredNorm()), root = std::sqrt(height);
    const double square = height + p * p;  // q^2
    const double rest = pi / 2 - std::asin(std::clamp(p / std::sqrt(square), -1.0, 1.0));
    const double zeroth = square / 2 * rest - p / 2 * root;
    const double first = root * height / 3;
    const double second = square * square / 8 * rest - p / 8 * (2 * p * p - square) * root;
    const double weight = 2 * pi / angles;
    rays.add(angle, weight * (first - p * zeroth),
             weight * (second - 2 * p * first + p * p * zeroth));
  }
}

/// Rays that pass the centre at the distance sin(beta) go through the whole ellipse.
void add_from_outside(Rays& rays, const Vector2d& pole) {
  const double distance = pole.norm(), to_centre = std::atan2(-pole.y(), -pole.x());
  for_gauss_points<64>(-pi / 2, pi / 2, [&](double beta, double weight) {
    const double sine = std::sin(beta), square = std::cos(beta) * std::cos(beta);
    const double p = std::sqrt(distance * distance - sine * sine);
    const double width = weight * std::cos(beta);  // p times the angle
    rays.add(to_centre + std::asin(sine / distance), width * pi / 2 * square,
             width * pi * (square * square / 8 / p + p * square / 2));
  });
}

}  // namespace

Vector3d full_sliding(double ratio, const Vector3d& motion) {
  require_positive("ratio", ratio);
  const double largest = motion.cwiseAbs().maxCoeff();
  require(largest > 0, "motion", largest, "a motion that is not 0");
  const Vector3d w = motion / largest;
  const double a = std::sqrt(ratio), phi = w[2];
  const Vector2d pole = Vector2d(-w[1] / a, w[0] * a) / phi;
  const double distance = pole.norm();
  if (phi == 0 || !(distance < farthest_pole)) {
    const Vector2d force = -w.head<2>().normalized();
    return {force.x(), force.y(), 0};
  }
  Rays rays(ratio, pole, phi > 0 ? 1 : -1);
  distance < 1 ? add_from_inside(rays, pole) : add_from_outside(rays, pole);
  return rays.sum();
}

}  // namespace microslip
