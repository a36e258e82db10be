// SPDX-License-Identifier: GPL-3.0-or-later
// Responses to loads so small that the whole contact sticks, against the linear theory in plane
// strain. With the modified Bessel functions I0, I1 of s a and lambda = ln(2 L0/a), the force after
// a step of the creepage and the creepage after a step of the force are inverse Laplace transforms,
//   F(q) = -(w a/k) L^-1 { 1/(s (I0/(I0 + I1) + s a lambda)) },
//   w(q) = w_steady L^-1 { I0/(s (I0 + I1)) },
// evaluated in 30 digits by de Hoog's method.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "microslip/rolling/transient.hpp"

namespace microslip {
namespace {

using std::numbers::pi;

const Material material{1.44, 0.28};  // k = 1/pi
constexpr double length = 10;
constexpr double tiny = 1e-7;  // of full sliding, which is pi/2

TransientRolling rolling_on(Eigen::Index n) {
  return TransientRolling({.kernel = PlaneKernel(material, length),
                           .bound = HertzBound(1, 1),
                           .grid = Grid({.half_width = 1, .elements = n}),
                           .basis = constant_basis(),
                           .scheme = MaterialFixed{}});
}

using Value = std::pair<double, double>;

class SmallMotion : public testing::TestWithParam<double> {};

/// \return the largest relative error
double error_of_creepage_step(Eigen::Index n, double step_ratio) {
  constexpr std::array<Value, 6> exact = {{{0.5, 0.159832109},
                                           {1, 0.304971877},
                                           {1.5, 0.434168799},
                                           {2, 0.544633750},
                                           {3, 0.700632698},
                                           {5, 0.870805578}}};
  TransientRolling rolling = rolling_on(n);
  const double step = step_ratio * 2 / static_cast<double>(n);
  double error = 0;
  std::size_t next = 0;
  rolling.roll(5, {step}, PrescribedCreepage{tiny}, [&](const TransientState& state) {
    if (next == exact.size() || state.distance < exact[next].first - step / 2) return;
    const double expected = -pi * tiny * exact[next].second;
    error = std::max(error, std::abs(state.force / expected - 1));
    ++next;
  });
  EXPECT_EQ(next, exact.size());
  return error;
}

TEST_P(SmallMotion, ForceAfterAStepOfTheCreepageIsSecondOrder) {
  std::vector<double> errors;
  for (const Eigen::Index n : {40, 80, 160})
    errors.push_back(error_of_creepage_step(n, GetParam()));
  EXPECT_LT(errors[1], 1e-5);
  EXPECT_LT(errors[2], 3e-6);
  EXPECT_GT(errors[0] / errors[2], 9);
}

/// Of the creepage, by the difference of the cumulative creep over two elements.
double error_of_force_step(Eigen::Index n, double step_ratio) {
  constexpr std::array<Value, 6> exact = {{{0.25, 0.5333589},
                                           {0.5, 0.5716907},
                                           {1, 0.6704351},
                                           {1.5, 0.8283660},
                                           {2.5, 1.0043685},
                                           {3, 0.9715777}}};
  TransientRolling rolling = rolling_on(n);
  const double force = -tiny;
  const double dx = 2 / static_cast<double>(n);
  rolling.start_from_shift({force});
  std::vector<double> creep = {0};  // after each whole element
  double sum = 0;
  rolling.roll(3.2, {step_ratio * dx}, PrescribedForce{force}, [&](const TransientState& state) {
    sum += state.creepage * step_ratio * dx;
    const double whole = static_cast<double>(creep.size()) * dx;
    if (state.distance > whole - step_ratio * dx / 2) creep.push_back(sum);
  });
  double error = 0;
  for (const auto& [distance, part] : exact) {
    const auto k = static_cast<std::size_t>(std::lround(distance / dx));
    const double creepage = (creep.at(k + 1) - creep.at(k - 1)) / (2 * dx);
    error = std::max(error, std::abs(creepage / (tiny / pi * part) - 1));
  }
  return error;
}

TEST_P(SmallMotion, CreepageAfterAStepOfTheForceIsSecondOrder) {
  std::vector<double> errors;
  for (const Eigen::Index n : {40, 80, 160}) errors.push_back(error_of_force_step(n, GetParam()));
  EXPECT_LT(errors[1], 2e-4);
  EXPECT_GT(errors[0] / errors[2], 14);
}

INSTANTIATE_TEST_SUITE_P(Steps, SmallMotion, testing::Values(1.0, 0.25, 0.1));

}  // namespace
}  // namespace microslip
