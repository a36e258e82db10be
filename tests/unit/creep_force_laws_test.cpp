// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of creep forces: their slopes, full sliding, closed forms and symmetries.
#include "microslip/reference/creep_force_laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "microslip/support/require.hpp"

namespace microslip::creep_force_laws_test {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

/// A contact of a wheel on a rail, a/b as given.
CreepForceContact contact_of(double ratio) {
  const double c = 5.5;
  return {.half_width = c * std::sqrt(ratio),
          .lateral_half_width = c / std::sqrt(ratio),
          .shear_modulus = 82000,
          .full_sliding = 24000,
          .coefficients = creep_coefficients(ratio, 0.28).value};
}

Vector2d forces(const Vector3d& resultants) { return resultants.head<2>(); }

/// FASTSIM with so many cells that they do not matter.
Vector3d fine(const CreepForceContact& contact, const Vector3d& motion,
              Flexibilities flexibilities = Flexibilities::three) {
  return fastsim(contact, motion, flexibilities, 400);
}

TEST(CreepForceLaws, HaveTheSlopesOfKalkersCoefficients) {
  for (const double ratio : {0.3, 1.0, 4.0}) {
    const CreepForceContact contact = contact_of(ratio);
    for (const Vector3d& motion :
         {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 0.2), Vector3d(0.7, -0.6, 0)}) {
      const Vector3d small = 1e-9 * motion;
      const Vector2d linear = linear_creep_force(contact, small);
      const double size = linear.norm();
      EXPECT_LT((vermeulen_johnson(contact, small) - linear).norm(), 1e-5 * size) << ratio;
      EXPECT_NEAR(polach(contact, small).norm() / size, 1, 1e-5) << ratio << motion;
      EXPECT_LT((forces(fine(contact, small)) - linear).norm(), 1e-4 * size) << ratio << motion;
    }
  }
}

TEST(CreepForceLaws, HaveFullSlidingUnderLargeCreepages) {
  const CreepForceContact contact = contact_of(1.5);
  const Vector3d motion(-0.3, 0.4, 0);
  const Vector2d sliding = 24000 * Vector2d(0.6, -0.8);
  EXPECT_LT((forces(fine(contact, motion, Flexibilities::one)) - sliding).norm(), 0.3);
  const Vector2d by_johnson = vermeulen_johnson(contact, motion);
  EXPECT_NEAR(by_johnson.norm(), 24000, 1e-8);
  EXPECT_NEAR(polach(contact, 100 * motion).norm(), 24000, 1);
}

/// In a row of the half-length A, with the bound k (A^2 - x^2) and tractions that grow by g a length,
/// all slips behind A - d, d = 2 A - g/k; the row carries k d^3/6 less than in full sliding.
double closed_form(const CreepForceContact& contact, double growth) {
  const double a = contact.half_width, b = contact.lateral_half_width;
  const double k = 2 * contact.full_sliding / (pi * a * b) / (a * a);
  constexpr int rows = 20000;
  double less = 0;
  for (int i = 0; i < rows; ++i) {
    const double y = -1 + (i + 0.5) * 2 / rows;
    const double d = std::max(0.0, 2 * a * std::sqrt(1 - y * y) - growth / k);
    less += k * d * d * d / 6 * 2 * b / rows;
  }
  return contact.full_sliding - less;
}

TEST(CreepForceLaws, FastsimHasItsClosedFormWithoutSpin) {
  const CreepForceContact contact = contact_of(0.6);
  const double growth = 3 * 82000 * contact.coefficients.c11 / (8 * contact.half_width);
  for (const double creepage : {2e-4, 1e-3, 3e-3, 6e-3}) {
    const double expected = closed_form(contact, growth * creepage);
    EXPECT_NEAR(fine(contact, {creepage, 0, 0})[0], -expected, 2e-5 * 24000) << creepage;
    EXPECT_NEAR(fine(contact, {creepage, 0, 0}, Flexibilities::one)[0], -expected, 2e-5 * 24000);
  }
}

TEST(CreepForceLaws, FastsimConvergesInItsCells) {
  const CreepForceContact contact = contact_of(2);
  const auto expect_order = [&](const Vector3d& motion, double order, double largest) {
    const Vector3d exact = fastsim(contact, motion, Flexibilities::three, 2000);
    const auto error = [&](Eigen::Index cells) {
      const Vector3d found = fastsim(contact, motion, Flexibilities::three, cells);
      return (found - exact).head<2>().norm() / contact.full_sliding;
    };
    EXPECT_GT(std::log2(error(50) / error(200)) / 2, order) << motion;
    EXPECT_LT(error(100), largest) << motion;
  };
  expect_order({1e-3, 0, 0}, 1.7, 5e-5);
  expect_order({0, 0, 3e-3}, 0.8, 5e-3);
  expect_order({1e-3, 1e-3, 2e-3}, 0.8, 5e-3);
}

TEST(CreepForceLaws, FastsimOfPureSpinHasTheMomentOfItsTractions) {
  // Where nothing slips p_y is -(phi/L)(A^2 - x^2)/2 and p_x is phi y (A - x)/L, L = pi a^2/(4 G c C23).
  const CreepForceContact contact = contact_of(1);
  const double a = contact.half_width, phi = 1e-10;
  const double stiffness = 4 * 82000 * contact.size() * contact.coefficients.c23 / (pi * a * a);
  double moment = 0;
  constexpr int rows = 4000;
  for (int i = 0; i < rows; ++i) {  // of x p_y there is nothing; of y p_x 2 A^2 y^2
    const double y = a * (-1 + (i + 0.5) * 2 / rows);
    moment -= stiffness * phi * 2 * (a * a - y * y) * y * y * 2 * a / rows;
  }
  EXPECT_NEAR(fine(contact, {0, 0, phi})[2] / moment, 1, 1e-4);
}

TEST(CreepForceLaws, MirrorMotions) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 100; ++i) {
    const CreepForceContact contact = contact_of(std::exp(1.5 * any(random)));
    const Vector3d motion = Vector3d(any(random), any(random), 0.2 * any(random)) * 5e-3;
    const Vector3d backward = motion.cwiseProduct(Vector3d(-1, 1, 1));
    const Vector3d mirrored = motion.cwiseProduct(Vector3d(1, -1, -1));
    const auto expect = [&](const auto& law, const auto& along, const auto& across) {
      const auto force = law(motion);
      EXPECT_LT((law(backward) - force.cwiseProduct(along)).norm(), 1e-6) << motion;
      EXPECT_LT((law(mirrored) - force.cwiseProduct(across)).norm(), 1e-6) << motion;
      EXPECT_LE(force.template head<2>().norm(), 24000 * 1.0003) << motion;
    };
    const Vector2d along(-1, 1), across(1, -1);
    expect([&](const Vector3d& m) { return vermeulen_johnson(contact, m); }, along, across);
    expect(
        [&](const Vector3d& m) {
          return Vector2d(fastsim(contact, m, Flexibilities::three).head<2>());
        },
        along, across);
    const Vector2d force = polach(contact, motion), back = polach(contact, backward);
    EXPECT_LT((back - force.cwiseProduct(along)).norm(), 1e-6);
    EXPECT_LT((polach(contact, mirrored) - force.cwiseProduct(across)).norm(), 1e-6);
  }
}

/// His formulas once more, as a program of 1999 writes them, with eps = pi G a b Cj sC/(4 mu Q).
TEST(CreepForceLaws, PolachHasTheNumbersOfHisProgram) {
  const CreepForceContact contact = contact_of(1.2);
  const double a = contact.half_width, b = contact.lateral_half_width, G = 82000, most = 24000;
  const auto& C = contact.coefficients;
  const double sx = 1e-3, sy = 5e-4, om = 3e-4;
  const double syc = sy + om * a, sc = std::sqrt(sx * sx + syc * syc);
  const double cj =
      std::sqrt(std::pow(C.c11 * sx, 2) + std::pow(C.c22 * sy, 2)) / std::hypot(sx, sy);
  const double ep = pi * G * a * b * cj * sc / (4 * most);
  const double mi = (ep / (1 + ep * ep) + std::atan(ep)) * 2 / pi;
  const double ks = 1 + 6.3 * (1 - std::exp(-a / b));
  const double epm = 8 * b * std::sqrt(a * b) * G * C.c23 * std::abs(syc) / (3 * ks * most);
  const double de = (epm * epm - 1) / (epm * epm + 1);
  const double km =
      epm * (de * de * de / 3 - de * de / 2 + 1.0 / 6) - std::sqrt(std::pow(1 - de * de, 3)) / 3;
  const double fys = -9.0 / 16 * a * km * ks;
  const Vector2d force = polach(contact, {sx, sy, om});
  EXPECT_NEAR(force[0], -most * mi * sx / sc, 1e-8);
  EXPECT_NEAR(force[1], -most * (mi * sy + fys * om) / sc, 1e-8);
}

TEST(CreepForceLaws, RefusesFastsimWithoutCells) {
  EXPECT_THROW(fastsim(contact_of(1), {1e-3, 0, 0}, Flexibilities::three, 0), BadParameter);
}

}  // namespace microslip::creep_force_laws_test
