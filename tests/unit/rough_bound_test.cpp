// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/rough_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene_text.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

const HertzBound hertz(5, 300);

/// The profile of a table whose amplitude is too small for the bound to reach zero, without its ends.
VectorXd profile_of(const Roughness& roughness) {
  const VectorXd x = VectorXd::LinSpaced(roughness.rows, -5, 5).segment(1, roughness.rows - 2);
  const VectorXd rough = bound_at(rough_bound(hertz, roughness), x);
  return (rough.array() / bound_at(hertz, x).array() - 1) / roughness.amplitude;
}

TEST(RoughBound, HasTheAmplitudeAndTheHurstExponent) {
  for (const double hurst : {0.2, 0.5, 0.8}) {
    const VectorXd profile = profile_of({.amplitude = 1e-3, .hurst = hurst, .rows = 65537});
    const Index n = profile.size();
    EXPECT_NEAR(profile.squaredNorm() / static_cast<double>(n), 1, 1e-3);
    const auto difference = [&](Index apart) {
      return std::sqrt((profile.tail(n - apart) - profile.head(n - apart)).squaredNorm() /
                       static_cast<double>(n - apart));
    };
    const double exponent = std::log2(difference(512) / difference(64)) / 3;
    EXPECT_NEAR(exponent, hurst, 0.05);
  }
}

TEST(RoughBound, IsTheSameForTheSameSeedOnly) {
  const VectorXd one = profile_of({.amplitude = 0.1, .hurst = 0.7, .seed = 1});
  EXPECT_EQ(one, profile_of({.amplitude = 0.1, .hurst = 0.7, .seed = 1}));
  const VectorXd other = profile_of({.amplitude = 0.1, .hurst = 0.7, .seed = 2});
  EXPECT_GT((one - other).norm(), 0.5 * one.norm());
}

// More rows add waves that are shorter than before.
TEST(RoughBound, KeepsItsLongWavesWithMoreRows) {
  const VectorXd few = profile_of({.amplitude = 0.1, .hurst = 0.8, .rows = 1025});
  const VectorXd many = profile_of({.amplitude = 0.1, .hurst = 0.8, .rows = 8193});
  double square = 0;
  for (Index i = 0; i < few.size(); ++i) square += std::pow(many[8 * (i + 1) - 1] - few[i], 2);
  EXPECT_LT(std::sqrt(square / static_cast<double>(few.size())), 0.02);
}

TEST(RoughBound, IsNowhereNegative) {
  const TabulatedBound bound = rough_bound(hertz, {.amplitude = 2, .hurst = 0.5});
  EXPECT_EQ(bound.values().minCoeff(), 0);
  EXPECT_GT((bound.values().array() == 0).count(), 100);
}

TEST(RoughBound, RefusesWhatIsNoProfile) {
  const auto refused = [](const Roughness& roughness) {
    return message([&] { rough_bound(hertz, roughness); });
  };
  EXPECT_EQ(refused({.amplitude = -0.1, .hurst = 0.5}),
            "amplitude = -0.1: expected a number in [0, 10]");
  EXPECT_EQ(refused({.amplitude = 0.1, .hurst = 0}), "hurst = 0: expected a number in (0, 1]");
  EXPECT_EQ(refused({.amplitude = 0.1, .hurst = 0.5, .rows = 8}),
            "rows = 8: expected a whole number in [9, 1000001]");
}

}  // namespace
}  // namespace microslip
