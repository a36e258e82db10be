// SPDX-License-Identifier: GPL-3.0-or-later
// Records of the material of a row: whatever the edge does, they have the values that entered.
#include "../../core/src/patch/material_records.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace microslip::material_records_test {

Eigen::Vector2d smooth(double place) { return {std::sin(place), std::cos(2 * place)}; }

/// The edge goes on and back at random, by steps from far below the spacing to some of it.
TEST(MaterialRecords, KeepASmoothFieldAsTheEdgeGoesOnAndBack) {
  constexpr double spacing = 0.1, length = 2;
  for (int run = 0; run < 50; ++run) {
    std::mt19937 random(static_cast<unsigned>(run));
    std::uniform_real_distribution<double> exponent(-6, -0.5), part(0, 1);
    double front = 1, exit = front - length;
    MaterialRecords records(front - length, front, spacing);
    records.change([](double place, Eigen::Vector2d& value) { value = smooth(place); });
    for (int k = 0; k < 400; ++k) {
      const double step = spacing * std::pow(10, exponent(random));
      front += part(random) < 0.5 ? step : -step;
      records.enter(front, smooth(front));
      records.leave(front - length);
      exit = std::max(exit, front - length);
    }
    for (double place = front; place >= exit; place -= 0.013) {
      EXPECT_NEAR((records.at(place) - smooth(place)).norm(), 0, 1e-3)
          << "run " << run << ", " << front - place << " behind the edge";
    }
  }
}

/// Bodies that are shifted as they hardly roll change what enters by a finite amount over no distance.
TEST(MaterialRecords, AreBetweenWhatEnteredWhereItJumps) {
  for (const double step : {1e-9, 1e-6, 1e-3}) {
    MaterialRecords records(-1, 1, 0.1);
    const double front = 1.03;  // which is farther from the record before than the spacing
    records.enter(front, {0, 0});
    for (int k = 1; k <= 30; ++k) {
      records.enter(front + k * step, {0.01 * k, 0});
      for (double place = -1; place <= front + k * step; place += 0.007) {
        const double value = records.at(place)[0];
        EXPECT_GE(value, -0.01 * k) << step << ", " << place;
        EXPECT_LE(value, 0.01 * k * (1 + 1e-12)) << step << ", " << place;
      }
      EXPECT_NEAR(records.at(front + k * step)[0], 0.01 * k, 1e-12);
    }
  }
}

}  // namespace microslip::material_records_test
