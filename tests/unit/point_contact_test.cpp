// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/point_contact.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "microslip/reference/line_contact.hpp"
#include "microslip/support/require.hpp"

namespace microslip::point_contact_test {

constexpr Material steel{82000, 0.28};
constexpr double stiffness = 82000 / 0.72;

TEST(PointContact, IsACircleForEqualCurvatures) {
  const PointContact contact(steel, 1e5, 1.0 / 400, 1.0 / 400);
  const double a = std::cbrt(0.75 * 1e5 * 400 / stiffness);
  EXPECT_NEAR(contact.half_width(), a, 1e-12 * a);
  EXPECT_NEAR(contact.lateral_half_width(), a, 1e-12 * a);
  const double peak = 1.5e5 / (std::numbers::pi * a * a);
  EXPECT_NEAR(contact.peak_pressure(), peak, 1e-12 * peak);
}

// Legendre's integrals have the same curvatures: the approach of the surfaces is their quadratic.
TEST(PointContact, HasItsCurvaturesByLegendresIntegrals) {
  for (const double ratio : {1.001, 2.0, 30.0, 1e5}) {
    const PointContact contact(steel, 8e4, 1e-3, ratio * 1e-3);
    const double a = contact.half_width(), b = contact.lateral_half_width();
    ASSERT_GT(a, b);
    const double e2 = (1 - b / a) * (1 + b / a), e = std::sqrt(e2);
    const double K = boost::math::ellint_1(e), E = boost::math::ellint_2(e);
    const double factor = 2 * contact.peak_pressure() * b / (e2 * a * a * stiffness);
    EXPECT_NEAR(factor * (K - E), 1e-3, 1e-11) << ratio;
    EXPECT_NEAR(factor * (a * a / (b * b) * E - K), ratio * 1e-3, 1e-9 * ratio) << ratio;
    const PointContact turned(steel, 8e4, ratio * 1e-3, 1e-3);
    EXPECT_DOUBLE_EQ(turned.half_width(), b);
    EXPECT_DOUBLE_EQ(turned.lateral_half_width(), a);
  }
}

// Across a long ellipse the contact is a line contact under the load of its middle.
TEST(PointContact, IsALineContactAcrossALongEllipse) {
  const PointContact contact(steel, 8e4, 1e-2, 1e-9);
  const double middle = contact.peak_pressure() * std::numbers::pi / 2 * contact.half_width();
  const LineContact line(steel, middle, 1e-2);
  EXPECT_NEAR(contact.half_width(), line.half_width(), 1e-4 * line.half_width());
}

// The radius that is to blame is that of the concave body.
TEST(PointContact, CurvaturesAddUpOrNameTheRadius) {
  EXPECT_DOUBLE_EQ(summed_curvature("one", 4, "two", 0), 0.25);
  EXPECT_DOUBLE_EQ(summed_curvature("one", -4, "two", 2), 0.25);
  const auto blamed = [](double radius_1, double radius_2) -> std::string {
    try {
      summed_curvature("one", radius_1, "two", radius_2);
    } catch (const BadParameter& error) {
      return error.name();
    }
    return "";
  };
  EXPECT_EQ(blamed(-4, 4), "one");
  EXPECT_EQ(blamed(4, -3), "two");
  EXPECT_EQ(blamed(0, -3), "two");
  EXPECT_EQ(blamed(-3, -5), "one");
  EXPECT_EQ(blamed(0, 0), "one");
  EXPECT_EQ(blamed(1e60, 1), "one");
  EXPECT_EQ(blamed(1, 1e-60), "two");
  EXPECT_EQ(blamed(1, std::nan("")), "two");
}

TEST(PointContact, RefusesBadNumbers) {
  EXPECT_THROW(PointContact(steel, 0, 1, 1), std::invalid_argument);
  EXPECT_THROW(PointContact(steel, 1, -1, 1), std::invalid_argument);
  EXPECT_THROW(PointContact(steel, 1, 1, 0), std::invalid_argument);
  EXPECT_THROW(PointContact(steel, 1, 1, 2e8), std::invalid_argument);
}

}  // namespace microslip::point_contact_test
