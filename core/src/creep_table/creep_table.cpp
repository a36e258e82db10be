// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/creep_table/creep_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "microslip/linalg/matrix_product.hpp"
#include "microslip/support/require.hpp"
#include "tensor_spline.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr std::size_t components = 3;

/// Fx is odd under a change of the sign of xi, the others are even.
constexpr std::array<double, components> parities{-1, 1, 1};

std::size_t size_of(Index nodes) { return static_cast<std::size_t>(nodes); }

/// The part of the forces that the spline has: D = [F - (1 - t)^2 F_linear]/t, and 0 at rest.
std::vector<double> remainder_of(const CreepTableNodes& nodes) {
  const CreepTableLayout& of = nodes.layout;
  std::vector<double> remainder(nodes.forces.size());
  for (Index i = 0; i < of.ratios; ++i) {
    const CreepCoefficients& coefficients = nodes.coefficients[size_of(i)];
    const MotionScales scales(of.ratio(i), coefficients);
    const Matrix3d linear = linear_creep_forces(coefficients);
    for (Index j = 0; j < of.polar; ++j) {
      for (Index k = 0; k < of.azimuths; ++k) {
        // (1 - t)^2 r = K t (1 - t)
        const Vector3d at_rest =
            half_step_size * (linear * scales.unit_motion(of.angle(j), of.azimuth(k)));
        for (Index s = 1; s < of.steps; ++s) {
          const double t = of.step(s);
          const std::size_t at = nodes.at(i, s, j, k);
          const Vector3d forces = Eigen::Map<const Vector3d>(nodes.forces.data() + at);
          Eigen::Map<Vector3d>(remainder.data() + at) = forces / t - (1 - t) * at_rest;
        }
      }
    }
  }
  return remainder;
}

/// Splines along the polar angle and the azimuth, which depend on the parity of a component.
std::vector<double> spline_over_directions(const std::vector<double>& values,
                                           const CreepTableLayout& of) {
  const MeridianSpline meridian = spline_over_pole(of.polar);
  const std::array<MatrixXd, 2> mirrored{spline_between_mirrors(of.azimuths, -1),
                                         spline_between_mirrors(of.azimuths, 1)};
  const Index polar = of.polar, azimuths = of.azimuths;
  const auto before = size_of(of.ratios * of.steps);
  std::vector<double> result(before * size_of((polar + 2) * (azimuths + 2)) * components);
  MatrixXd nodes(polar, azimuths);
  for (std::size_t i = 0; i < before; ++i) {
    for (std::size_t c = 0; c < components; ++c) {
      for (Index j = 0; j < polar; ++j) {
        for (Index k = 0; k < azimuths; ++k) {
          nodes(j, k) =
              values[((i * size_of(polar) + size_of(j)) * size_of(azimuths) + size_of(k)) *
                         components +
                     c];
        }
      }
      const MatrixXd turned = parities[c] * nodes.rowwise().reverse();
      const MatrixXd along =
          matrix_product(meridian.own, nodes) + matrix_product(meridian.opposite, turned);
      const MatrixXd found = matrix_product(along, mirrored[parities[c] > 0 ? 1 : 0].transpose());
      for (Index j = 0; j < polar + 2; ++j) {
        for (Index k = 0; k < azimuths + 2; ++k) {
          result[((i * size_of(polar + 2) + size_of(j)) * size_of(azimuths + 2) + size_of(k)) *
                     components +
                 c] = found(j, k);
        }
      }
    }
  }
  return result;
}

/// From 0 to 1 with slopes 0.
double smooth_step(double u) { return u * u * (3 - 2 * u); }
double slope_of_smooth_step(double u) { return 6 * u * (1 - u); }

}  // namespace

/// Values of D, and its derivatives by the place among steps, by the polar angle, and by the azimuth
/// over the polar angle, which has a limit at pure spin.
struct CreepTable::Slopes {
  Vector3d value = Vector3d::Zero();
  Eigen::Matrix<double, 3, 3> by = Matrix3d::Zero();
};

CreepTable::CreepTable(const CreepTableNodes& nodes) : layout_(nodes.layout) {
  validate(layout_);
  if (nodes.coefficients.size() != size_of(layout_.ratios) ||
      nodes.forces.size() != layout_.nodes() * components) {
    throw std::invalid_argument("nodes of a table: expected as many as in its layout");
  }
  const MatrixXd by_ratio = spline_between_ends(layout_.ratios);
  for (std::size_t c = 0; c < coefficients_.size(); ++c) {
    VectorXd values(layout_.ratios);
    for (Index i = 0; i < layout_.ratios; ++i) {
      values[i] = nodes.coefficients[size_of(i)].values()[c];
    }
    coefficients_[c] = by_ratio * values;
  }
  const std::size_t directions = size_of((layout_.polar + 2) * (layout_.azimuths + 2));
  std::vector<double> spline = spline_over_directions(remainder_of(nodes), layout_);
  spline = along_axis(spline, spline_between_ends(layout_.steps), size_of(layout_.ratios),
                      directions * components);
  spline = along_axis(spline, by_ratio, 1, size_of(layout_.steps + 2) * directions * components);
  spline_.assign(spline.begin(), spline.end());
  prepare_cap();
}

/// At pure spin, Fy and Mz have values; and all have one slope each, Fx by theta sin(psi), and the
/// others by theta cos(psi), which are means over the azimuth.
void CreepTable::prepare_cap() {
  cap_angle_ = layout_.angle(1);
  const auto rows = size_of(layout_.polar + 2), columns = size_of(layout_.azimuths + 2);
  const std::size_t planes = size_of(layout_.ratios + 2) * size_of(layout_.steps + 2);
  const double by_angle = layout_.slope_of_place(0) / 2;
  cap_.assign(planes * 2 * components, 0);
  const auto last = size_of(layout_.azimuths - 1);
  for (std::size_t i = 0; i < planes; ++i) {
    const auto at = [&](std::size_t j, std::size_t k, std::size_t c) {
      const auto knot = [&](std::size_t place) {
        return static_cast<double>(spline_[((i * rows + j) * columns + place) * components + c]);
      };
      return (knot(k) + 4 * knot(k + 1) + knot(k + 2)) / 6;
    };
    for (std::size_t k = 0; k <= last; ++k) {
      const double psi = layout_.azimuth(static_cast<Index>(k));
      const double weight = (k == 0 || k == last ? 0.5 : 1) / static_cast<double>(last);
      for (std::size_t c = 0; c < components; ++c) {
        const double value = (at(0, k, c) + 4 * at(1, k, c) + at(2, k, c)) / 6;
        const double slope = (at(2, k, c) - at(0, k, c)) * by_angle;
        if (c > 0) cap_[(i * 2) * components + c] += weight * value;
        cap_[(i * 2 + 1) * components + c] +=
            2 * weight * slope * (c == 0 ? std::sin(psi) : std::cos(psi));
      }
    }
  }
}

CreepCoefficients CreepTable::coefficients_at(double ratio_place) const {
  const SplinePlace at(ratio_place, size_of(layout_.ratios));
  std::array<double, 5> found{};
  for (std::size_t c = 0; c < found.size(); ++c) {
    for (std::size_t i = 0; i < 4; ++i) {
      found[c] += at.value[i] * coefficients_[c][static_cast<Index>(at.first + i)];
    }
  }
  return CreepCoefficients::of(found);
}

CreepTable::Slopes CreepTable::spline_at(double ratio_place, double step_place, double polar,
                                         double azimuth) const {
  const SplinePlace ratio(ratio_place, size_of(layout_.ratios));
  const SplinePlace step(step_place, size_of(layout_.steps));
  const SplinePlace angle(layout_.place_of_angle(polar), size_of(layout_.polar));
  const double per_radian = static_cast<double>(layout_.azimuths - 1) / std::numbers::pi;
  const SplinePlace turn(azimuth * per_radian, size_of(layout_.azimuths));
  const auto steps = size_of(layout_.steps + 2), rows = size_of(layout_.polar + 2),
             columns = size_of(layout_.azimuths + 2);
  Eigen::Array3d value = Eigen::Array3d::Zero(), by_step = value, by_angle = value, by_turn = value;
  for (std::size_t s = 0; s < 4; ++s) {
    Eigen::Array3d value_s = Eigen::Array3d::Zero(), angle_s = value_s, turn_s = value_s;
    for (std::size_t j = 0; j < 4; ++j) {
      // The sum over the ratio comes first, for four azimuths at once.
      Eigen::Array<double, 12, 1> line = Eigen::Array<double, 12, 1>::Zero();
      for (std::size_t i = 0; i < 4; ++i) {
        const float* from =
            spline_.data() +
            ((((ratio.first + i) * steps + step.first + s) * rows + angle.first + j) * columns +
             turn.first) *
                components;
        line += ratio.value[i] * Eigen::Map<const Eigen::Array<float, 12, 1>>(from).cast<double>();
      }
      Eigen::Array3d value_j = Eigen::Array3d::Zero(), turn_j = value_j;
      for (std::size_t k = 0; k < 4; ++k) {
        const auto part = line.segment<3>(static_cast<Index>(3 * k));
        value_j += turn.value[k] * part;
        turn_j += turn.slope[k] * part;
      }
      value_s += angle.value[j] * value_j;
      angle_s += angle.slope[j] * value_j;
      turn_s += angle.value[j] * turn_j;
    }
    value += step.value[s] * value_s;
    by_step += step.slope[s] * value_s;
    by_angle += step.value[s] * angle_s;
    by_turn += step.value[s] * turn_s;
  }
  Slopes found;
  found.value = value;
  found.by.col(0) = by_step;
  found.by.col(1) = by_angle * layout_.slope_of_place(polar);
  if (polar > 0) found.by.col(2) = by_turn * per_radian / polar;
  return found;
}

/// The linear function of the direction about pure spin.
CreepTable::Slopes CreepTable::cap_at(double ratio_place, double step_place, double polar,
                                      double azimuth) const {
  const SplinePlace ratio(ratio_place, size_of(layout_.ratios));
  const SplinePlace step(step_place, size_of(layout_.steps));
  const auto steps = size_of(layout_.steps + 2);
  Eigen::Array<double, 6, 1> value = Eigen::Array<double, 6, 1>::Zero(), by_step = value;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t s = 0; s < 4; ++s) {
      const Eigen::Map<const Eigen::Array<double, 6, 1>> from(
          cap_.data() + ((ratio.first + i) * steps + step.first + s) * 2 * components);
      value += ratio.value[i] * step.value[s] * from;
      by_step += ratio.value[i] * step.slope[s] * from;
    }
  }
  const double sine = std::sin(azimuth), cosine = std::cos(azimuth);
  const Eigen::Array3d wave(sine, cosine, cosine), turned(cosine, -sine, -sine);
  Slopes found;
  found.value = value.head<3>() + polar * wave * value.tail<3>();
  found.by.col(0) = by_step.head<3>() + polar * wave * by_step.tail<3>();
  found.by.col(1) = wave * value.tail<3>();
  found.by.col(2) = turned * value.tail<3>();
  return found;
}

/// \param motion  xi and phi >= 0, not all 0
Vector3d CreepTable::forces_of_octant(double ratio, const Vector3d& motion,
                                      Matrix3d* jacobian) const {
  const double ratio_place = layout_.place_of_ratio(ratio);
  const CreepCoefficients coefficients = coefficients_at(ratio_place);
  const MotionScales scales(ratio, coefficients);
  const Matrix3d linear = linear_creep_forces(coefficients);
  const Vector3d sized = motion.cwiseProduct(scales.sizes);
  const double r = sized.norm(), t = r / (r + half_step_size),
               rest = half_step_size / (r + half_step_size);
  const double intervals = static_cast<double>(layout_.steps - 1);
  const Vector3d direction = motion.cwiseQuotient(scales.directions);
  const double across = direction.head<2>().norm();
  const double polar = std::atan2(across, direction[2]);
  // At pure spin, the direction along eta has the azimuth 0, and the polar angle is a length.
  const bool is_pure_spin = across < 1e-12 * direction[2];
  const double azimuth = is_pure_spin ? 0 : std::atan2(std::abs(direction[0]), direction[1]);

  Slopes at;
  if (polar < cap_angle_) {
    const double u = polar / cap_angle_, weight = smooth_step(u);
    const Slopes cap = cap_at(ratio_place, t * intervals, polar, azimuth);
    at = spline_at(ratio_place, t * intervals, polar, azimuth);
    const Vector3d difference = at.value - cap.value;
    at.value = cap.value + weight * difference;
    at.by = cap.by + weight * (at.by - cap.by);
    at.by.col(1) += slope_of_smooth_step(u) / cap_angle_ * difference;
  } else {
    at = spline_at(ratio_place, t * intervals, polar, azimuth);
  }
  const Vector3d creep = linear * motion;
  if (jacobian != nullptr) {
    const Vector3d size_slope = sized.cwiseProduct(scales.sizes) / r;
    const Vector3d step_slope = rest / (r + half_step_size) * size_slope;
    const double square = direction.squaredNorm();
    Eigen::Vector2d away(0, 1);
    if (!is_pure_spin) away = direction.head<2>() / across;
    const double turned = is_pure_spin ? 1 / direction[2] : polar / across;
    const Vector3d polar_slope(direction[2] / square * away.x(), direction[2] / square * away.y(),
                               -across / square);
    const Vector3d azimuth_slope(turned * away.y(), -turned * away.x(), 0);
    const Matrix3d by_direction =
        at.by.col(1) * polar_slope.transpose() + at.by.col(2) * azimuth_slope.transpose();
    *jacobian =
        (at.value + t * intervals * at.by.col(0) - 2 * rest * creep) * step_slope.transpose() +
        t * by_direction * scales.directions.cwiseInverse().asDiagonal() + rest * rest * linear;
  }
  return t * at.value + rest * rest * creep;
}

Vector3d CreepTable::forces(double ratio, const Vector3d& motion, Matrix3d* jacobian) const {
  constexpr double rounding = 1e-12;
  require(ratio >= layout_.least_ratio * (1 - rounding) &&
              ratio <= layout_.largest_ratio * (1 + rounding),
          "ratio", ratio, [&] {
            return fmt::format("a/b of the table, {} to {}", layout_.least_ratio,
                               layout_.largest_ratio);
          });
  const double largest = motion.cwiseAbs().maxCoeff();
  require(motion.allFinite() && largest <= 1e100, "motion", largest, "at most 1e100");
  if (largest < 1e-100) {
    const Matrix3d linear = linear_creep_forces(coefficients_at(layout_.place_of_ratio(ratio)));
    if (jacobian != nullptr) *jacobian = linear;
    return linear * motion;
  }
  // All results change their signs with the motion; a mirror changes those of xi and Fx.
  const double inversion = motion[2] < 0 ? -1 : 1;
  const double mirror = inversion * motion[0] < 0 ? -1 : 1;
  const Vector3d signs(mirror, 1, 1);
  // Without -0, of which the azimuth would be half a turn.
  const Vector3d mirrored = (inversion * motion.cwiseProduct(signs)).array() + 0.0;
  const Vector3d found = forces_of_octant(ratio, mirrored, jacobian);
  if (jacobian != nullptr) *jacobian = signs.asDiagonal() * *jacobian * signs.asDiagonal();
  return inversion * found.cwiseProduct(signs);
}

Vector3d CreepTable::resultants(double shear_modulus, const EllipticBound& bound,
                                const Vector3d& motion, Matrix3d* jacobian) const {
  require_positive("shear_modulus", shear_modulus);
  const double strain = bound.peak() / shear_modulus, c = bound.size(), full = bound.total();
  const Vector3d motions(strain, strain, strain / c), sizes(full, full, full * c);
  const Vector3d found = forces(bound.ratio(), motion.cwiseQuotient(motions), jacobian);
  if (jacobian != nullptr) {
    *jacobian = sizes.asDiagonal() * *jacobian * motions.cwiseInverse().asDiagonal();
  }
  return found.cwiseProduct(sizes);
}

}  // namespace microslip
