// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/chebyshev_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "microslip/friction/sliding_field.hpp"
#include "microslip/support/quadrature.hpp"

namespace microslip::chebyshev_field_test {

const Material material{1.3, 0.28};

ChebyshevTraction some_traction() {
  return {-0.4, 1.1, (Eigen::VectorXd(4) << 0.7, -0.3, 0.2, 0.15).finished()};
}

/// u by adaptive quadrature over both sides of x.
double integrated_displacement(const Kernel& kernel, const ChebyshevTraction& p, double x) {
  const auto integrand = [&](double y) { return p(y) * kernel.displacement(std::abs(x - y)); };
  if (x <= p.begin() || x >= p.end()) return integrate(integrand, p.begin(), p.end(), 1e-10);
  return integrate(integrand, p.begin(), x, 1e-10) + integrate(integrand, x, p.end(), 1e-10);
}

TEST(ChebyshevTraction, IntegralsAreThoseOfItsValues) {
  const ChebyshevTraction p = some_traction();
  const auto values = [&](double x) { return p(x); };
  for (const double x : {-0.2, 0.5, 1.09}) {
    EXPECT_NEAR(p.integral(x), integrate(values, p.begin(), x, 1e-12), 1e-13);
  }
  EXPECT_EQ(p.integral(-3), 0);
  EXPECT_DOUBLE_EQ(p.integral(3), p.force());
}

TEST(ChebyshevField, DisplacementsAgreeWithQuadrature) {
  for (const Kernel& kernel :
       {Kernel(PlaneKernel(material, 7)), Kernel(StripKernel(material, 20)),
        Kernel(StripKernel(material, 0.8)), Kernel(StripKernel(material, 0.015))}) {
    const ChebyshevField field(kernel, some_traction());
    for (const double x : {-3.0, -0.41, -0.3, 0.35, 1.0, 1.2, 9.0}) {
      const double expected = integrated_displacement(kernel, some_traction(), x);
      EXPECT_NEAR(field.displacement(x), expected, 2e-10) << x;
    }
  }
}

TEST(ChebyshevField, StrainIsTheSlopeOfTheDisplacement) {
  for (const Kernel& kernel :
       {Kernel(PlaneKernel(material, 7)), Kernel(StripKernel(material, 0.8))}) {
    const ChebyshevField field(kernel, some_traction());
    for (const double x : {-3.0, -0.45, -0.3, 0.35, 1.0, 1.2, 9.0}) {
      constexpr double h = 1e-5;
      const double slope = (field.displacement(x - h) - field.displacement(x + h)) / (2 * h);
      EXPECT_NEAR(field.strain(x), slope, 1e-8) << x;
    }
  }
}

// The remark of the class: strain of U_n's term is compliance T_(n+1).
TEST(ChebyshevField, InPlaneStrainIsAPolynomialThatGoesOn) {
  const ChebyshevField field(PlaneKernel(material, 7), some_traction());
  const Eigen::VectorXd c = some_traction().coefficients();
  for (const double t : {-0.9, 0.3, 1.7}) {
    const double expected = c[0] * t + c[1] * (2 * t * t - 1) + c[2] * (4 * t * t * t - 3 * t) +
                            c[3] * (8 * t * t * t * t - 8 * t * t + 1);
    EXPECT_NEAR(field.continued_strain(0.35 + 0.75 * t), compliance(material) * expected, 1e-14);
  }
}

TEST(ChebyshevField, RefusesNarrowStrips) {
  EXPECT_THROW(ChebyshevField(StripKernel(material, 0.01), some_traction()), std::invalid_argument);
}

}  // namespace microslip::chebyshev_field_test
