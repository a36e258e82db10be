// SPDX-License-Identifier: GPL-3.0-or-later
// The derivative of a step's force by its creepage about a steady state with the stick half-width
// a'. The slip zone does not answer, so that it is the response of a contact that sticks to a step
// of the creepage,
//   dF/dw = -(a'/k) S(dq/a'; lambda'),  lambda' = ln(2 L0/a').
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "measured_order.hpp"
#include "microslip/reference/small_motion.hpp"
#include "microslip/rolling/transient.hpp"
#include "test_name.hpp"

namespace microslip::step_jacobian_test {

const Material material{1.44, 0.28};  // k = 1/pi
constexpr double length = 10;
constexpr std::array<double, 3> sizes = {50, 100, 200};

/// For small distances by its first terms, as 1/H = 1/2 + 1/(8 s) + ... + lambda s.
double response_to_step(double distance, double lambda) {
  if (distance >= 0.001) return force_after_creepage_step(distance, lambda);
  return distance / lambda * (1 - distance / (4 * lambda));
}

struct Case {
  double stick;     ///< a'/a
  double distance;  ///< dq/a
};

std::array<double, 3> errors_of_slope(const Case& c) {
  std::array<double, 3> errors{};
  const double force = -(1 - c.stick * c.stick) * HertzBound(1, 1).total();
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const auto n = static_cast<Eigen::Index>(sizes[i]);
    TransientRolling rolling({.contact = {PlaneKernel(material, length), HertzBound(1, 1)},
                              .grid = Grid({.half_width = 1, .elements = n}),
                              .basis = constant_basis(),
                              .scheme = Remembered{}});
    rolling.roll(30, {rolling.x()[1] - rolling.x()[0]}, PrescribedForce{force},
                 [](const TransientState&) {});
    StepJacobian jacobian;
    rolling.attempt(c.distance, PrescribedCreepage{rolling.state().creepage}, jacobian);
    const double exact = -std::numbers::pi * c.stick *
                         response_to_step(c.distance / c.stick, std::log(2 * length / c.stick));
    errors[i] = std::abs(jacobian.by_load.force / exact - 1);
  }
  return errors;
}

void print_order(const Case& c, const std::array<double, 3>& errors) {
  measured_order(fmt::format("a' = {:.4g} a, dq = {:g} a", c.stick, c.distance), sizes, errors);
}

class StepJacobian : public testing::TestWithParam<Case> {};

// Steps of whole elements, from where one has been travelled, have an error of their own, which is
// less for short ones; so the largest of five distances counts.
TEST_P(StepJacobian, OfLongStepsIsSecondOrder) {
  std::array<double, 3> largest{};
  for (const double stretch : {1.0, 1.013, 1.029, 1.041, 1.057}) {
    const auto errors = errors_of_slope({GetParam().stick, stretch * GetParam().distance});
    for (std::size_t i = 0; i < errors.size(); ++i) largest[i] = std::max(largest[i], errors[i]);
  }
  print_order(GetParam(), largest);
  EXPECT_LT(largest[1], 2e-4);
  EXPECT_GT(largest[0] / largest[1], 3.3);
  EXPECT_GT(largest[1] / largest[2], 3.3);
}

TEST(StepJacobian, OfWholeElementsIsExactWhereAllSticks) {
  for (const double distance : {0.04, 0.2, 1.0}) {
    const auto errors = errors_of_slope({0.9999999, distance});
    EXPECT_LT(errors[0], 1e-6) << distance;
    EXPECT_LT(errors[2], 1e-7) << distance;
  }
}

// The smallest load has no slip zone that could be resolved.
INSTANTIATE_TEST_SUITE_P(
    Distances, StepJacobian,
    testing::Values(Case{0.9999999, 0.1}, Case{0.9999999, 0.5}, Case{0.9999999, 3}, Case{0.6, 0.1},
                    Case{0.6, 0.5}, Case{0.6, 3}, Case{0.6, 10}, Case{0.3, 0.1}, Case{0.3, 0.5},
                    Case{0.3, 3}, Case{0.3, 10}),
    [](const auto& of) {
      return test::place({{"stick", of.param.stick}, {"distance", of.param.distance}});
    });

// Within an element the answer of the contact is singular at the leading edge, as that to a shift
// without rolling, and nothing has entered that could tell where the edge is.
TEST(StepJacobianWithinAnElement, IsFirstOrder) {
  for (const double stick : {0.9999999, 0.6, 0.3}) {
    for (const double distance : {1e-6, 1e-3}) {
      const auto errors = errors_of_slope({stick, distance});
      print_order({stick, distance}, errors);
      EXPECT_LT(errors[1], 4.2e-3) << stick << ", " << distance;
      EXPECT_NEAR(errors[1] / errors[2], 2, 0.2) << stick << ", " << distance;
    }
  }
}

}  // namespace microslip::step_jacobian_test
