// SPDX-License-Identifier: GPL-3.0-or-later
// Orders of convergence of transient rolling on the Cattaneo shift that turns to Carter's solution.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "microslip/reference/cattaneo.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/convergence.hpp"

namespace microslip {
namespace {

const Material material{1.44, 0.28};  // K mu p0 a = 1
constexpr double length = 200;
const double force = -0.64 * std::numbers::pi / 2;

TransientRolling rolling_on(Eigen::Index n) {
  return TransientRolling({.kernel = PlaneKernel(material, length),
                           .bound = HertzBound(1, 1),
                           .grid = Grid({.half_width = 1, .elements = n}),
                           .basis = constant_basis(),
                           .scheme = Direct{}});
}

constexpr std::array<double, 4> sizes = {40, 80, 160, 320};

// Of an independent program, extrapolated to dx = 0: the integral of |w| over the distance q, about
// 4 digits.
constexpr std::array<double, 5> distances = {0.25, 0.5, 1, 2, 3};
constexpr std::array<double, 5> cumulative_creep = {0.052644, 0.111834, 0.289966, 0.696553,
                                                    1.09784};

// All distances are whole numbers of elements.
TEST(TransientOrder, CumulativeCreepIsFirstOrder) {
  std::array<std::vector<double>, distances.size()> errors;
  for (const double n : sizes) {
    TransientRolling rolling = rolling_on(static_cast<Eigen::Index>(n));
    rolling.start_from_shift({force});
    const double dx = 2 / n;
    double creep = 0;
    std::size_t next = 0;
    rolling.roll(distances.back(), {dx}, PrescribedForce{force}, [&](const TransientState& state) {
      creep += state.creepage * dx;
      if (state.distance < distances[next] - dx / 2) return;
      errors[next].push_back(creep - cumulative_creep[next]);
      ++next;
    });
    ASSERT_EQ(next, distances.size());
  }
  for (std::size_t k = 0; k < distances.size(); ++k) {
    EXPECT_NEAR(fitted_order(sizes, errors[k]), 1.0, 0.15) << "q = " << distances[k];
    EXPECT_LT(std::abs(errors[k].back()), 0.005 * cumulative_creep[k]);
  }
}

// Limited by the square roots at the ends of the stick zone.
TEST(TransientOrder, CattaneoShiftIsOfOrderThreeHalves) {
  const Cattaneo exact(material, HertzBound(1, 1), force);
  std::vector<double> shift_errors;
  std::vector<double> traction_errors;
  for (const double n : sizes) {
    TransientRolling rolling = rolling_on(static_cast<Eigen::Index>(n));
    shift_errors.push_back(rolling.start_from_shift({force}) + exact.displacement(length));
    const Eigen::VectorXd at_nodes =
        rolling.x().unaryExpr([&](double x) { return exact.traction(x); });
    traction_errors.push_back((rolling.state().traction - at_nodes).lpNorm<1>() / n);
  }
  EXPECT_NEAR(fitted_order(sizes, shift_errors), 1.5, 0.1);
  EXPECT_NEAR(fitted_order(sizes, traction_errors), 1.5, 0.3);
}

}  // namespace
}  // namespace microslip
