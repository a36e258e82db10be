// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/rough_bound.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scene_text.hpp"

namespace microslip::rough_bound_test {

using Eigen::Index;
using Eigen::VectorXd;

const HertzBound hertz(5, 300);

/// The profile of a table whose amplitude is too small for the bound to reach zero, without its
/// ends.
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

// docs/stability.md promises these. They are sums over cosines in Python, with a mt19937_64 of its
// own.
TEST(RoughBound, OfASeedStaysTheSameInAllVersions) {
  const auto expect_at = [](unsigned seed, const std::array<double, 3>& expected) {
    const TabulatedBound bound = rough_bound(hertz, {.amplitude = 0.5, .hurst = 0.8, .seed = seed});
    const std::array<double, 3> rows = {512, 1024, 1700};  // of 0 to 2048
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_NEAR(bound(5 * (rows.at(i) / 1024 - 1)), expected.at(i), 1e-12 * 300);
    }
  };
  expect_at(1, {127.64388642647204, 353.7090505678931, 385.12919734950896});
  expect_at(4294967295U, {12.98711996743889, 279.9808751000045, 294.8542389818004});
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

}  // namespace microslip::rough_bound_test
