// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/edge_displacement.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/quadrature.hpp"

namespace microslip {
namespace {

constexpr Material material{3, 0.28};

// In plane strain, the integral of sin^2(t) ln(1 - cos t) over [0, pi] is (pi/2)(1/2 - ln 2).
TEST(EdgeDisplacement, AgreesWithTheClosedFormInPlaneStrain) {
  const double a = 2, peak = 5, length = 7, pi = std::numbers::pi;
  const HertzBound bound(a, peak);
  for (const double stick_ratio : {1e-3, 0.3, 0.6, 0.95}) {
    const Carter carter =
        Carter::from_creepage(material, bound, compliance(material) * peak * (1 - stick_ratio));
    const auto under_ellipse = [&](double r) {
      return -compliance(material) / pi * peak / a * r * r * (pi / 2) *
             (std::log(r / length) + 0.5 - std::log(2.0));
    };
    const double exact = -(under_ellipse(a) - under_ellipse(stick_ratio * a));
    EXPECT_NEAR(edge_displacement(PlaneKernel(material, length), carter), exact,
                1e-12 * std::abs(exact));
  }
}

// The thesis's integrals (10.5) as they stand, singular at the edge, in 50 digits.
TEST(EdgeDisplacement, AgreesWithTheThesisIntegralsInAStrip) {
  using Digits = boost::multiprecision::cpp_bin_float_50;
  const double width = 3;
  const Carter carter = Carter::from_creepage({1, 0.28}, HertzBound(1, 1), 0.576);
  boost::math::quadrature::tanh_sinh<Digits> integrator;
  const Digits nu = 0.28, b = Digits(width) / 2;
  const auto part = [&](const Digits& r) {  // z is the distance from the edge
    const auto integrand = [&](const Digits& z) {
      const Digits traction = sqrt(z * (2 * r - z));
      return Digits(traction * ((1 - nu) * asinh(b / z) + nu * b / sqrt(z * z + b * b)));
    };
    return integrator.integrate(integrand, Digits(0), Digits(2 * r));
  };
  const Digits exact =
      -2 / boost::math::constants::pi<Digits>() * (part(1) - part(Digits(carter.stick_ratio())));
  const double value = edge_displacement(StripKernel({1, 0.28}, width), carter);
  EXPECT_LT(static_cast<double>(abs((value - exact) / exact)), 1e-12);
}

TEST(EdgeDisplacement, ReversesWithTheCreepage) {
  const PlaneKernel kernel(material, 1);
  const HertzBound bound(1, 1);
  EXPECT_EQ(edge_displacement(kernel, Carter::from_creepage(material, bound, 0.1)),
            -edge_displacement(kernel, Carter::from_creepage(material, bound, -0.1)));
}

TEST(Quadrature, SaysWhereItFails) {
  EXPECT_NEAR(integrate([](double x) { return std::log(x); }, 0, 1, 1e-12), -1, 1e-12);
  EXPECT_THROW(integrate([](double x) { return 1 / x; }, 0, 1, 1e-12), NotConverged);
}

}  // namespace
}  // namespace microslip
