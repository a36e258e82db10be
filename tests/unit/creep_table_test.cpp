// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of creep forces: nodes, limits, symmetries, derivatives, files, and the table that is
// installed against solutions.
#include "microslip/creep_table/creep_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include "microslip/creep_table/creep_states.hpp"
#include "microslip/creep_table/creep_table_file.hpp"
#include "microslip/reference/full_sliding.hpp"
#include "microslip/support/netcdf.hpp"

namespace microslip::creep_table_test {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

double largest(const Eigen::MatrixXd& of) { return of.cwiseAbs().maxCoeff(); }

class Random {
 public:
  double uniform(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(bits_);
  }
  Vector3d motion() {
    std::normal_distribution<double> normal;
    const Vector3d direction(normal(bits_), normal(bits_), normal(bits_));
    return std::exp(normal(bits_)) * direction;
  }

 private:
  std::mt19937 bits_{7};
};

/// Full sliding by the midpoint rule in polar coordinates about the centre, a b = 1.
Vector3d sum_over_ellipse(double ratio, const Vector3d& motion) {
  constexpr int rings = 600, rays = 600;
  const double a = std::sqrt(ratio), b = 1 / a;
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < rings; ++i) {
    const double height = (i + 0.5) / rings, r = std::sqrt(1 - height * height);
    for (int j = 0; j < rays; ++j) {
      const double angle = 2 * pi * (j + 0.5) / rays;
      const double x = a * r * std::cos(angle), y = b * r * std::sin(angle);
      const Eigen::Vector2d slip(motion[0] - motion[2] * y, motion[1] + motion[2] * x);
      const Eigen::Vector2d one = slip.normalized();
      sum -= height * height * Vector3d(one.x(), one.y(), x * one.y() - y * one.x());
    }
  }
  return sum * 3 / (rings * static_cast<double>(rays));
}

TEST(FullSliding, IsTheSumOverTheEllipse) {
  Random random;
  for (int i = 0; i < 12; ++i) {
    const double ratio = std::exp(random.uniform(-2, 2));
    const Vector3d motion = random.motion();
    EXPECT_LT(largest(full_sliding(ratio, motion) - sum_over_ellipse(ratio, motion)), 5e-5)
        << ratio << ' ' << motion.transpose();
  }
}

TEST(FullSliding, HasClosedFormsAndItsLimit) {
  EXPECT_LT(largest(full_sliding(3, {2, -1.5, 0}) - Vector3d(-0.8, 0.6, 0)), 1e-15);
  EXPECT_NEAR(full_sliding(1, {0, 0, -1})[2], 3 * pi / 16, 1e-12);
  for (const double far : {1e3, 1e5, 1e7}) {
    EXPECT_LT(largest(full_sliding(0.3, {far, 0, 1}) - Vector3d(-1, 0, 0)), 2 / far);
  }
  const double a = std::sqrt(2.0);  // the pole is on the edge
  EXPECT_LT(largest(full_sliding(2, {1 / a, 0, 1}) - sum_over_ellipse(2, {1 / a, 0, 1})), 5e-5);
  EXPECT_THROW(full_sliding(1, {0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(full_sliding(-1, {1, 0, 0}), std::invalid_argument);
}

const CreepTableLayout small{.least_ratio = 0.8,
                             .largest_ratio = 1.25,
                             .ratios = 4,
                             .steps = 7,
                             .polar = 5,
                             .azimuths = 7,
                             .cells = 6};

const CreepTableNodes& small_nodes() {
  static const CreepTableNodes nodes = [] {
    const CreepTableMaker maker(small);
    std::vector<std::vector<double>> parts;
    for (std::size_t i = 0; i < maker.parts(); ++i) parts.push_back(maker.solve(i));
    return maker.joined(parts);
  }();
  return nodes;
}

const CreepTable& small_table() {
  static const CreepTable table(small_nodes());
  return table;
}

TEST(CreepTable, HasTheForcesOfItsNodes) {
  const CreepTableNodes& nodes = small_nodes();
  for (Index i = 0; i < small.ratios; ++i) {
    const MotionScales scales(small.ratio(i), nodes.coefficients[static_cast<std::size_t>(i)]);
    for (Index s = 1; s < small.steps - 1; ++s) {
      for (Index j = 0; j < small.polar; ++j) {
        for (Index k = 0; k < small.azimuths; ++k) {
          const Vector3d motion =
              size_of_motion(small.step(s)) * scales.unit_motion(small.angle(j), small.azimuth(k));
          const Vector3d at = Eigen::Map<const Vector3d>(&nodes.forces[nodes.at(i, s, j, k)]);
          ASSERT_LT(largest(small_table().forces(small.ratio(i), motion) - at), 1e-6);
        }
      }
    }
  }
}

TEST(CreepTable, IsExactAtRestAndInFullSliding) {
  const CreepCoefficients one = creep_coefficients(1, small.poisson_ratio).value;
  Matrix3d jacobian;
  EXPECT_EQ(small_table().forces(1, {0, 0, 0}, &jacobian), Vector3d(0, 0, 0));
  EXPECT_LT(largest(jacobian - linear_creep_forces(one)), 1e-4);  // between ratios
  const Vector3d little = small_table().forces(1, {1e-7, 2e-7, -3e-7});
  EXPECT_LT(largest(little * 1e7 - linear_creep_forces(one) * Vector3d(1, 2, -3)), 1e-3);
  const MotionScales scales(small.ratio(1), small_nodes().coefficients[1]);
  const Vector3d unit = scales.unit_motion(small.angle(2), small.azimuth(3));
  EXPECT_LT(largest(small_table().forces(small.ratio(1), 1e9 * unit) -
                    full_sliding(small.ratio(1), unit)),
            1e-6);
  EXPECT_LT(small_table().forces(1, {1e99, 0, 0})[0], -0.999);
}

TEST(CreepTable, IsSymmetric) {
  Random random;
  for (int i = 0; i < 200; ++i) {
    const Vector3d motion = random.motion();
    const Vector3d forces = small_table().forces(1.1, motion);
    EXPECT_EQ(small_table().forces(1.1, -motion), -forces);
    const Vector3d mirrored = small_table().forces(1.1, {-motion[0], motion[1], motion[2]});
    EXPECT_EQ(mirrored, Vector3d(-forces[0], forces[1], forces[2]));
  }
}

/// Central differences of a motion's components.
Matrix3d differences(const CreepTable& table, double ratio, const Vector3d& motion) {
  const double step = 1e-5 * motion.norm();
  Matrix3d found;
  for (Index c = 0; c < 3; ++c) {
    const Vector3d by = step * Vector3d::Unit(c);
    found.col(c) =
        (table.forces(ratio, motion + by) - table.forces(ratio, motion - by)) / (2 * step);
  }
  return found;
}

TEST(CreepTable, HasTheDerivativesOfItsForces) {
  Random random;
  for (int i = 0; i < 500; ++i) {
    Vector3d motion = random.motion();
    if (i % 3 == 0) motion.head<2>() *= 0.03;  // about pure spin
    if (i % 5 == 0) motion[i % 2] = 0;
    Matrix3d jacobian;
    small_table().forces(0.9, motion, &jacobian);
    const Matrix3d expected = differences(small_table(), 0.9, motion);
    ASSERT_LT(largest(jacobian - expected), 1e-5 * (1 + largest(expected))) << motion.transpose();
  }
}

Matrix3d jacobian_at(const Vector3d& motion) {
  Matrix3d jacobian;
  small_table().forces(1.1, motion, &jacobian);
  return jacobian;
}

// Where formulas change: pure spin, the border of what is about it, no spin, no creepage.
TEST(CreepTable, HasAContinuousJacobian) {
  constexpr double little = 1e-7, rounding = 1e-15;
  const Matrix3d pure_spin = jacobian_at({0, 0, 1});
  for (const double size : {little, rounding}) {
    for (const double turn : {0.0, 1.0, 2.0, 3.0, 4.5}) {
      const Vector3d near(size * std::sin(turn), size * std::cos(turn), 1);
      EXPECT_LT(largest(jacobian_at(near) - pure_spin), 1e-5) << size << ", " << turn;
    }
  }
  for (const Vector3d& at :
       {Vector3d(0.5, 0.7, 0), Vector3d(0, 0.7, 0.3), Vector3d(0.8, 0, 0), Vector3d(0, 0.6, 0)}) {
    for (Index c = 0; c < 3; ++c) {
      const Vector3d by = little * Vector3d::Unit(c);
      EXPECT_LT(largest(jacobian_at(at + by) - jacobian_at(at - by)), 1e-5) << at.transpose();
    }
  }
  for (double x = 0; x < 1.5; x += 0.003) {  // no jump on the way from pure spin
    const Vector3d from(x, 0.4 * x, 1), to(x + 0.003, 0.4 * (x + 0.003), 1);
    ASSERT_LT(largest(jacobian_at(to) - jacobian_at(from)), 0.03) << x;
  }
}

// A motion and its opposite have the same slopes, also where components are 0 of either sign.
TEST(CreepTable, HasOneJacobianForOppositeMotions) {
  for (const Vector3d& motion : {Vector3d(0, 0, 1), Vector3d(0, -0.0, 1), Vector3d(-0.0, 0, 1),
                                 Vector3d(0, 1, 1), Vector3d(1, 0, 1), Vector3d(1, -0.0, 0)}) {
    EXPECT_LT(largest(jacobian_at(motion) - jacobian_at(-motion)), 1e-12) << motion.transpose();
  }
}

TEST(CreepTable, HasUnits) {
  const double a = 6, b = 5.5, G = 82000, peak = 300, c = std::sqrt(a * b);
  const EllipticBound bound(a, b, peak);
  const Vector3d motion(1e-3, -5e-4, 2e-4);
  Matrix3d jacobian, scaled;
  const Vector3d found = small_table().resultants(G, bound, motion, &jacobian);
  const Vector3d unit = small_table().forces(
      a / b, G / peak * Vector3d(motion[0], motion[1], c * motion[2]), &scaled);
  const double full = 2 * pi / 3 * a * b * peak;
  EXPECT_LT(largest(found - full * Vector3d(unit[0], unit[1], c * unit[2])), 1e-9 * full);
  EXPECT_NEAR(jacobian(2, 2), full * c * c * G / peak * scaled(2, 2),
              1e-9 * std::abs(jacobian(2, 2)));
}

TEST(CreepTable, RefusesWhatItDoesNotHave) {
  const double not_a_number = std::nan("");
  EXPECT_THROW(small_table().forces(0.79, {0, 0, 1}), std::invalid_argument);
  EXPECT_THROW(small_table().forces(1.26, {0, 0, 1}), std::invalid_argument);
  EXPECT_THROW(small_table().forces(1, {0, not_a_number, 1}), std::invalid_argument);
  EXPECT_THROW(small_table().forces(1, {1e101, 0, 0}), std::invalid_argument);
  EXPECT_THROW(CreepTableMaker({.poisson_ratio = 0.6}), std::invalid_argument);
  EXPECT_THROW(CreepTableMaker({.steps = 3}), std::invalid_argument);
  EXPECT_THROW(CreepTableMaker({.cells = 41}), std::invalid_argument);
  EXPECT_THROW(CreepTableMaker({.least_ratio = 2, .largest_ratio = 1}), std::invalid_argument);
}

TEST(CreepTableFile, IsReadBack) {
  const CreepTableNodes read = read_creep_table(file_of(small_nodes(), "a test"));
  EXPECT_EQ(read.layout.azimuths, small.azimuths);
  EXPECT_EQ(read.errors.states, 0);
  const CreepTable table(read);
  Random random;
  for (int i = 0; i < 50; ++i) {
    const Vector3d motion = random.motion();
    EXPECT_LT(largest(table.forces(1, motion) - small_table().forces(1, motion)), 1e-6);
  }
}

TEST(CreepTableFile, IsRefusedIfCutOrDamaged) {
  const std::string bytes = file_of(small_nodes(), "a test");
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 300) {
    EXPECT_THROW(read_creep_table(bytes.substr(0, size)), std::invalid_argument) << size;
  }
  std::string damaged = bytes;
  damaged[bytes.size() - 3000] ^= 0x40;
  EXPECT_THROW(read_creep_table(damaged), std::invalid_argument);
  EXPECT_THROW(read_creep_table("CDF\002"), std::invalid_argument);
  EXPECT_THROW(read_creep_table(NetcdfFile().bytes()), std::invalid_argument);
}

CreepTableNodes installed() {
  std::ifstream file(std::string(MICROSLIP_SOURCE) + "/tables/creep_forces.nc", std::ios::binary);
  return read_creep_table({std::istreambuf_iterator<char>(file), {}});
}

// Solutions of today, at a random a/b that had no part in the table; its own errors are 0.11 % of
// full sliding at the root of the mean square, and its largest one is 1.7 %.
TEST(InstalledCreepTable, HasTheForcesOfSolutions) {
  const CreepTableNodes nodes = installed();
  EXPECT_GE(nodes.errors.states, 1900);
  EXPECT_LT(nodes.errors.rms.maxCoeff(), 1.3e-3);
  EXPECT_LT(nodes.errors.of_99_percent.maxCoeff(), 5e-3);
  EXPECT_LT(nodes.errors.largest.maxCoeff(), 1.8e-2);
  CreepTableLayout middle = nodes.layout;
  middle.least_ratio = 0.5;
  middle.largest_ratio = 2;
  const auto states = random_creep_states(middle, 12345, 60, 15);
  ASSERT_GT(states.size(), 55u);
  const CreepTableErrors errors = errors_in(states, CreepTable(nodes), 15);
  EXPECT_LT(errors.rms.maxCoeff(), 3e-3);
  EXPECT_LT(errors.largest.maxCoeff(), 2.1e-2);
}

}  // namespace microslip::creep_table_test
