// SPDX-License-Identifier: GPL-3.0-or-later
// Under-relaxation of the standard scheme in three dimensions, thesis (7.1).
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "microslip/patch/standard_patch.hpp"

namespace microslip::relaxed_rectangles_test {

using Eigen::Index;
using Eigen::MatrixX2d;
using Eigen::VectorXd;

constexpr Index size = 12;

/// A circle with the given c*; 0 is the direct scheme.
RectangleRolling circle(double relaxation, double peak = 1) {
  return RectangleRolling({.material = {1, 0.28},
                           .bound = EllipticBound(1, 1, peak),
                           .elements = size,
                           .rows = size,
                           .relaxation = relaxation});
}

PatchLoad creepages(double along, double across) {
  return {{{false, along}, {false, across}, {false, 0}}};
}

/// The change from element to element along the rows, less the smooth part of it: second
/// differences of the longitudinal tractions, as a root of the mean square.
double waves(const RectangleRolling& rolling) {
  const VectorXd y = rolling.y(), x = rolling.x();
  const MatrixX2d tractions = rolling.tractions();
  double sum = 0;
  Index count = 0;
  for (Index i = 1; i + 1 < x.size(); ++i) {
    if (y[i - 1] != y[i] || y[i + 1] != y[i] || std::abs(x[i]) > 0.5) continue;
    const double second = tractions(i - 1, 0) - 2 * tractions(i, 0) + tractions(i + 1, 0);
    sum += second * second;
    ++count;
  }
  return std::sqrt(sum / static_cast<double>(count));
}

// Thesis (7.10): where all sticks, relaxed influences and relaxed tractions are the same. The second
// way shares only the direct scheme with the first one.
TEST(RelaxedRectangles, HaveTheMeanOfTractionsWhereAllSticks) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  constexpr double strong = 1e6;  // the bound, so that nothing slips
  for (int sample = 0; sample < 10; ++sample) {
    const double relaxation = 1 + 0.5 * uniform(random), part = 0.55 + 0.44 * uniform(random);
    RectangleRolling relaxed = circle(relaxation, strong), direct = circle(0, strong);
    const double dx = direct.element();
    const PatchLoad before = creepages(uniform(random), uniform(random));
    const PatchLoad load = creepages(uniform(random), uniform(random));
    relaxed.shift(before);
    direct.shift(before);
    const MatrixX2d start = direct.tractions();
    relaxed.roll(part * relaxation * dx, load);
    direct.roll(relaxation * dx, load);
    const MatrixX2d expected = (1 - part) * start + part * direct.tractions();
    EXPECT_LT((relaxed.tractions() - expected).lpNorm<Eigen::Infinity>(), 1e-8 * expected.norm())
        << "c* = " << relaxation << ", part " << part;
  }
}

TEST(RelaxedRectangles, AreTheDirectSchemeInStepsOfTheRelaxation) {
  RectangleRolling relaxed = circle(1.5), direct = circle(0);
  const PatchLoad load{{{false, 0.4}, {false, -0.3}, {false, 0.2}}};
  for (int i = 0; i < 5; ++i) {
    relaxed.roll(1.5 * relaxed.element(), load);
    direct.roll(1.5 * direct.element(), load);
  }
  EXPECT_EQ(relaxed.slips(), direct.slips());
  EXPECT_LT((relaxed.tractions() - direct.tractions()).lpNorm<Eigen::Infinity>(), 1e-8);
}

// Short steps of the direct scheme make waves. That is why under-relaxation exists, which does not.
TEST(RelaxedRectangles, DoNotWiggleInShortSteps) {
  const auto rolled = [&](double relaxation, double c) {
    RectangleRolling rolling = circle(relaxation, 1e6);
    rolling.shift(creepages(1, 0));
    const int steps = static_cast<int>(std::lround(8 / c));
    for (int i = 0; i < steps; ++i) rolling.roll(c * rolling.element(), creepages(1, 0));
    return waves(rolling);
  };
  const double by_elements = rolled(0, 1);
  EXPECT_GT(rolled(0, 0.1), 3 * by_elements);
  for (const double c : {1.0, 0.3, 0.1, 0.01}) EXPECT_LT(rolled(1, c), 1.2 * by_elements) << c;
}

TEST(RelaxedRectangles, RefuseLongerStepsAndBadNumbers) {
  EXPECT_THROW(circle(-1), std::invalid_argument);
  EXPECT_THROW(circle(std::nan("")), std::invalid_argument);
  EXPECT_THROW(circle(2e6), std::invalid_argument);
  RectangleRolling rolling = circle(0.5);
  EXPECT_THROW(rolling.roll(0.51 * rolling.element(), creepages(1, 0)), std::invalid_argument);
  EXPECT_EQ(rolling.resultants().norm(), 0);
  rolling.roll(0.5 * rolling.element(), creepages(1, 0));
}

}  // namespace microslip::relaxed_rectangles_test
