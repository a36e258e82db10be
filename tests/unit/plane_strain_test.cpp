// SPDX-License-Identifier: GPL-3.0-or-later
// Plane strain on an interval of the half-length a resists displacements if L0 > a/2, the
// interval's logarithmic capacity.
#include <gtest/gtest.h>

#include <stdexcept>

#include "microslip/dynamics/cylinder.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/linalg/spectra.hpp"
#include "microslip/rolling/steady.hpp"
#include "scene_text.hpp"

namespace microslip::plane_strain_test {

const Material steel{82000, 0.28};

double least_of_influence(double length, double half_length, Eigen::Index n) {
  return least_eigenvalue(influence_matrix(PlaneKernel(steel, length), constant_basis(),
                                           2 * half_length / static_cast<double>(n), n));
}

TEST(PlaneStrain, IsDefiniteAboveTheLogarithmicCapacity) {
  for (const double half_length : {5.0, 0.3}) {
    EXPECT_GT(least_of_influence(0.5 * half_length, half_length, 200), 0);
    EXPECT_LT(least_of_influence(0.496 * half_length, half_length, 200), 0);
  }
  EXPECT_EQ(PlaneKernel(steel, 3).definite_half_length(), 6);
  EXPECT_EQ(StripKernel(steel, 3).definite_half_length(), INFINITY);
}

TransientProblem transient(double length, const AdvectionScheme& scheme, Eigen::Index n) {
  return {.contact = {PlaneKernel(steel, length), HertzBound(5, 300)},
          .grid = Grid({.half_width = 5, .elements = n}),
          .basis = constant_basis(),
          .scheme = scheme};
}

// A creepage of +0.001 once led to a force of +568 N/mm with L0 = 2 mm.
TEST(PlaneStrain, ShortLengthsAreRefusedInTransients) {
  for (const AdvectionScheme& scheme : {AdvectionScheme(Remembered{}), AdvectionScheme(Direct{})}) {
    for (const double length : {0.1, 2.0, 2.5, 2.54}) {
      EXPECT_THROW(TransientRolling(transient(length, scheme, 100)), std::invalid_argument);
      EXPECT_THROW(RollingCylinder(transient(length, scheme, 100), {5.5, 5.5e5, 450, 500},
                                   Integrator::midpoint, 1),
                   std::invalid_argument);
    }
  }
  EXPECT_EQ(message([] { TransientRolling(transient(2, Direct{}, 100)); }),
            "length = 2: expected more than (half_width + dx)/2 = 2.55 mm, from where on "
            "plane strain resists displacements; below, a creepage would drive the force the wrong "
            "way. Steady rolling takes any length");
}

// An accepted length makes the bodies resist, also where elements reach beyond the edges.
TEST(PlaneStrain, AcceptedLengthsResist) {
  for (const AdvectionScheme& scheme : {AdvectionScheme(Remembered{}), AdvectionScheme(Direct{})}) {
    for (const Eigen::Index n : {3, 10, 31, 100}) {
      if (n < 4 && std::holds_alternative<Remembered>(scheme)) continue;
      const double length = 1.001 * (5 + 10. / static_cast<double>(n)) / 2;
      TransientRolling rolling(transient(length, scheme, n));
      for (int k = 0; k < 20; ++k) {
        rolling.step(0.37 * 10. / static_cast<double>(n), PrescribedCreepage{1e-4});
        EXPECT_LT(rolling.state().force, 0) << n << ' ' << k;
        EXPECT_GT(rolling.elastic_energy(), 0) << n << ' ' << k;
      }
    }
  }
}

TEST(PlaneStrain, SteadyRollingTakesAnyLength) {
  const auto force = [](double length) {
    return solve_steady({.contact = {PlaneKernel(steel, length), HertzBound(5, 300)},
                         .grid = Grid({.half_width = 5, .elements = 40}),
                         .basis = constant_basis(),
                         .load = PrescribedCreepage{0.001}})
        .force;
  };
  EXPECT_NEAR(force(0.1), force(100), 1e-9);
}

}  // namespace microslip::plane_strain_test
