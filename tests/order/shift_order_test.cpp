// SPDX-License-Identifier: GPL-3.0-or-later
// Shifts between two ways of rolling where everything sticks: tractions are singular at the edges,
// wherever these are within an element.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "measured_order.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::shift_order_test {

using Eigen::Index;

constexpr double high = 1000;  ///< peak of a bound that nothing reaches  [N/mm^2]
constexpr double creepage = 1e-3;
constexpr double by = 1e-3;

struct Forces {
  double after_shift;
  double later;
};

TransientRolling at_rest(Index elements, const AdvectionScheme& scheme) {
  return TransientRolling({.contact = {PlaneKernel({1.44, 0.28}, 20), HertzBound(1, high)},
                           .grid = Grid({.half_width = 1, .elements = elements}),
                           .basis = constant_basis(),
                           .scheme = scheme});
}

/// Rolled by 0.96 + `part` of an element of N = 50, shifted, and rolled on by 0.4.
Forces forces(Index elements, const AdvectionScheme& scheme, double part, double step_ratio = 1) {
  TransientRolling rolling = at_rest(elements, scheme);
  const double length = step_ratio * 2 / static_cast<double>(elements);
  const auto roll = [&](double distance) {
    rolling.roll(distance, {length}, PrescribedCreepage{creepage}, [](const TransientState&) {});
  };
  roll(0.96 + part * 0.04);
  rolling.shift(PrescribedShift{by});
  const double after_shift = rolling.state().force;
  roll(0.4);
  return {after_shift, rolling.state().force};
}

/// By the scheme of the thesis with whole elements, extrapolated.
Forces exact(double part) {
  const Forces coarse = forces(400, Direct{}, part);
  const Forces fine = forces(800, Direct{}, part);
  return {2 * fine.after_shift - coarse.after_shift, 2 * fine.later - coarse.later};
}

TEST(ShiftOrder, BetweenTwoWaysOfRollingIsOfSecondOrderWhereEverythingSticks) {
  const std::vector<double> sizes = {25, 50, 100, 200};
  std::vector<double> shifted(sizes.size(), 0.0), later(sizes.size(), 0.0);
  for (const double part : {0.0, 0.25, 0.5, 0.625, 0.75, 0.875}) {
    const Forces truth = exact(part);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      const Forces found = forces(static_cast<Index>(sizes[i]), Remembered{}, part);
      shifted[i] = std::max(shifted[i], std::abs(found.after_shift / truth.after_shift - 1));
      later[i] = std::max(later[i], std::abs(found.later / truth.later - 1));
    }
  }
  EXPECT_NEAR(measured_order("force after the shift", sizes, shifted), 2, 0.3);
  EXPECT_NEAR(measured_order("force 0.4 a later", sizes, later), 2, 0.5);
  EXPECT_LT(shifted[1], 5e-6);
  EXPECT_LT(later[1], 5e-6);
}

TEST(ShiftOrder, ShortStepsEndAtTheSame) {
  for (const double part : {0.0, 0.3, 0.7}) {
    const double whole = forces(50, Remembered{}, part).later;
    for (const double step_ratio : {0.3, 0.07, 2.6}) {
      EXPECT_NEAR(forces(50, Remembered{}, part, step_ratio).later / whole, 1, 1e-10)
          << part << ' ' << step_ratio;
    }
  }
}

// The shift lays down a traction ahead of the last node, which falls while an element is travelled.
// So the force goes on evenly from the shift.
TEST(ShiftOrder, RollingGoesOnFromTheShift) {
  for (const double part : {0.0, 0.3, 0.7}) {
    TransientRolling rolling = at_rest(50, Remembered{});
    rolling.roll(0.96 + part * 0.04, {0.04}, PrescribedCreepage{creepage},
                 [](const TransientState&) {});
    rolling.shift(PrescribedShift{by});
    const double shifted = rolling.state().force;
    rolling.step(1e-9, PrescribedCreepage{0});
    EXPECT_NEAR(rolling.state().force / shifted, 1, 1e-4) << part;
    TransientRolling fine = at_rest(400, Direct{});
    fine.roll(0.96 + part * 0.04, {0.005}, PrescribedCreepage{creepage},
              [](const TransientState&) {});
    fine.shift(PrescribedShift{by});
    for (int k = 0; k < 8; ++k) {
      fine.step(0.01, PrescribedCreepage{creepage});
      rolling.step(0.01, PrescribedCreepage{creepage});
      EXPECT_NEAR(rolling.state().force / fine.state().force, 1, 1.5e-3) << part << ' ' << k;
    }
  }
}

}  // namespace microslip::shift_order_test
