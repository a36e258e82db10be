// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "microslip/reference/brush.hpp"
#include "microslip/rolling/steady.hpp"

namespace microslip::brush_rolling_test {

using Eigen::VectorXd;

constexpr double compliance = 1e-4;

SteadySolution solve(const TractionBound& bound, const Load& load, Eigen::Index elements = 50) {
  return solve_steady({.contact = {WinklerKernel(compliance), bound},
                       .grid = Grid({.half_width = half_width_of(bound), .elements = elements}),
                       .load = load});
}

/// Springs one after the other from the leading edge on, as a simulation has them.
double force_by_springs(const TractionBound& bound, double creepage, int springs) {
  const double a = half_width_of(bound);
  const double step = 2 * a / springs;
  double traction = 0, force = 0;
  for (int i = 0; i < springs; ++i) {
    const double x = a - step * (i + 0.5);
    const double g = std::visit([&](const auto& of) { return of(x); }, bound);
    traction = std::min(g, traction + creepage / compliance * (i == 0 ? step / 2 : step));
    force += traction * step;
  }
  return force;
}

TractionBound generated_bound(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  if (between(0, 1) < 0.3) {
    // 1 + r cos-like waves that stay above zero
    VectorXd h(5);
    h << 1, 0, between(-2, 2), 0, between(1.1, 4);
    return PolynomialBound(5, between(50, 300), h);
  }
  const int rows = 3 + static_cast<int>(between(0, 12));
  std::vector<double> x;
  for (int i = 0; i < rows; ++i) x.push_back(between(-4.99, 4.99));
  std::ranges::sort(x);
  VectorXd place(rows), value(rows);
  for (int i = 0; i < rows; ++i) {
    place[i] = x[static_cast<std::size_t>(i)];
    value[i] = between(0, 1) < 0.2 ? 0 : between(0, 300);
  }
  value[0] += 1;
  return TabulatedBound(5, place, value);
}

TEST(BrushRolling, IsTheClosedFormOfHertz) {
  const HertzBound hertz(5, 300);
  const Brush brush(compliance, hertz);
  for (const double creepage : {1e-8, -1e-5, 1e-3, -0.006, 0.1}) {
    const SteadySolution found = solve(hertz, PrescribedCreepage{creepage});
    EXPECT_EQ(found.scheme, SteadyScheme::closed_form);
    EXPECT_NEAR(found.force / brush.force(creepage), 1, 1e-12);
    EXPECT_NEAR(*found.stick_edge, brush.stick_edge(creepage), 1e-11);
    for (Eigen::Index i = 0; i < found.x.size(); ++i) {
      EXPECT_NEAR(found.traction[i], brush.traction(found.x[i], creepage), 1e-9);
    }
  }
}

/// The rows of a valley; the creepage is that of an integration in closed form.
TEST(BrushRolling, CrossesAValleyWithAnyNumberOfElements) {
  VectorXd x(5), g(5);
  x << -5, -2.5, 0, 2.5, 5;
  g << 0, 200, 20, 200, 0;
  for (const Eigen::Index elements : {1, 20, 100}) {
    const SteadySolution found = solve(TabulatedBound(5, x, g), PrescribedForce{-210}, elements);
    EXPECT_NEAR(found.creepage, 4.8682e-4, 1e-8);
    EXPECT_TRUE(found.fallback.empty());
  }
}

TEST(BrushRolling, AgreesWithSpringsOneByOne) {
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    const TractionBound bound = generated_bound(random);
    const double most = full_sliding_force(bound);
    const double creepage = std::pow(10, std::uniform_real_distribution<>(-5, -1)(random));
    const SteadySolution found = solve(bound, PrescribedCreepage{creepage});
    EXPECT_NEAR(-found.force, force_by_springs(bound, creepage, 100000), 3e-4 * most) << i;
    if (-found.force >= (1 - 1e-9) * most) continue;
    const SteadySolution back = solve(bound, PrescribedForce{found.force});
    EXPECT_NEAR(solve(bound, PrescribedCreepage{back.creepage}).force, found.force, 1e-11 * most);
    for (const double slip : found.slip) EXPECT_GE(slip, -1e-9 * creepage) << i;
  }
}

TEST(BrushRolling, RefusesForcesOfFullSliding) {
  const HertzBound hertz(5, 300);
  EXPECT_THROW(solve(hertz, PrescribedForce{full_sliding_force(hertz)}), std::invalid_argument);
  EXPECT_EQ(solve(hertz, PrescribedForce{0}).creepage, 0);
}

}  // namespace microslip::brush_rolling_test
