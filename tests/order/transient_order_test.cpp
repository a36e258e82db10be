// SPDX-License-Identifier: GPL-3.0-or-later
// Orders of convergence of transient rolling on the Cattaneo shift that turns to Carter's solution.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "measured_order.hpp"
#include "microslip/reference/cattaneo.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::transient_order_test {

const Material material{1.44, 0.28};  // 2 (1 - nu)/G mu p0 = 1
constexpr double length = 200;
const double force = -0.64 * std::numbers::pi / 2;

TransientRolling rolling_on(Eigen::Index n, const AdvectionScheme& scheme = Direct{}) {
  return TransientRolling({.contact = {PlaneKernel(material, length), HertzBound(1, 1)},
                           .grid = Grid({.half_width = 1, .elements = n}),
                           .basis = constant_basis(),
                           .scheme = scheme});
}

constexpr std::array<double, 4> sizes = {40, 80, 160, 320};

// An independent program gave the integral of |w| over the distance q, extrapolated to dx = 0, to
// about 4 digits.
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
    const std::string place = fmt::format("distance {:g} a", distances[k]);
    EXPECT_NEAR(measured_order(place, sizes, errors[k]), 1.0, 0.15) << place;
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
  EXPECT_NEAR(measured_order("shift", sizes, shift_errors), 1.5, 0.1);
  EXPECT_NEAR(measured_order("traction, mean of all nodes", sizes, traction_errors), 1.5, 0.3);
}

/// |S(q)| at thirty equal distances up to 3.
std::vector<double> cumulative_creeps(double n, double step_ratio, double carried = force) {
  TransientRolling rolling = rolling_on(static_cast<Eigen::Index>(n), Remembered{});
  rolling.start_from_shift({carried});
  std::vector<double> creeps;
  double creep = 0, before = 0;
  for (int k = 1; k <= 30; ++k) {
    rolling.roll(0.1, {step_ratio * 2 / n}, PrescribedForce{carried},
                 [&](const TransientState& state) {
                   creep += state.creepage * (state.distance - before);
                   before = state.distance;
                 });
    creeps.push_back(creep);
  }
  return creeps;
}

// Against known values to their four digits, and against a finer run to more. At each distance the
// error depends on where the stick-slip point lies within its element, so the mean is fitted. The
// length of steps changes less than that error.
TEST(TransientOrder, CumulativeCreepIsSecondOrderWhateverTheStep) {
  const std::vector<double> fine = cumulative_creeps(1280, 1);
  constexpr std::array<std::size_t, 4> known = {4, 9, 19, 29};
  for (std::size_t k = 0; k < known.size(); ++k) {
    EXPECT_NEAR(fine[known[k]], cumulative_creep[k + 1], 6e-6);
  }
  constexpr std::array<double, 4> coarse = {80, 160, 320, 640};
  std::vector<double> errors;
  for (const double n : coarse) {
    const std::vector<double> creeps = cumulative_creeps(n, 1);
    double squares = 0;
    for (std::size_t k = 0; k < fine.size(); ++k) squares += std::pow(creeps[k] - fine[k], 2);
    errors.push_back(std::sqrt(squares / static_cast<double>(fine.size())));
    if (n > 160) continue;
    for (const double step_ratio : {0.3, 0.01, 2.5}) {
      const std::vector<double> same = cumulative_creeps(n, step_ratio);
      for (std::size_t k = 0; k < fine.size(); ++k) EXPECT_NEAR(same[k], creeps[k], errors.back());
    }
  }
  EXPECT_NEAR(measured_order("rms of thirty distances", coarse, errors), 1.9, 0.2);
  EXPECT_LT(errors[1], 1.5e-5);
}

// Where nearly everything sticks, relative to the creep: the slip zone is shorter than an element.
TEST(TransientOrder, CumulativeCreepIsRightForSmallLoads) {
  for (const double ratio : {1e-2, 1e-3, 1e-4, 1e-6}) {
    const double small = -ratio * std::numbers::pi / 2;
    const double fine = cumulative_creeps(640, 1, small).back();
    for (const double step_ratio : {1.0, 0.3}) {
      const auto creep = [&](double n) {
        return cumulative_creeps(n, step_ratio, small).back() / fine;
      };
      EXPECT_NEAR(creep(40), 1, 1e-3) << ratio << ' ' << step_ratio;
      EXPECT_NEAR(creep(160), 1, 5e-4) << ratio << ' ' << step_ratio;
    }
  }
}

TEST(TransientOrder, CattaneoShiftIsSecondOrderOnElements) {
  const Cattaneo exact(material, HertzBound(1, 1), force);
  std::vector<double> errors;
  for (const double n : sizes) {
    TransientRolling rolling = rolling_on(static_cast<Eigen::Index>(n), Remembered{});
    errors.push_back(rolling.start_from_shift({force}) + exact.displacement(length));
  }
  EXPECT_NEAR(measured_order("shift", sizes, errors), 2.0, 0.1);
  EXPECT_LT(std::abs(errors.back()), 4e-6);
}

// The slip zone at the leading edge is shorter than an element, and has a part of its effect.
TEST(TransientOrder, CattaneoShiftOfASmallForceIsUpToATenThousandthTooSmall) {
  const double small = -0.01 * std::numbers::pi / 2;
  const Cattaneo exact(material, HertzBound(1, 1), small);
  for (const Eigen::Index n : {20, 40, 80}) {
    TransientRolling rolling = rolling_on(n, Remembered{});
    const double shift = -rolling.start_from_shift({small}) / exact.displacement(length);
    EXPECT_LT(shift, 1 - 4e-5) << n;
    EXPECT_GT(shift, 1 - 1e-4) << n;
  }
}

}  // namespace microslip::transient_order_test
