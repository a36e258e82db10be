// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/small_motion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "microslip/rolling/frequency_response.hpp"

namespace microslip::small_motion_test {

using std::numbers::pi;
using Values = std::array<std::pair<double, double>, 9>;

// Derived for this project by de Hoog's method in 30 digits, of which some 8 hold.
TEST(SmallMotion, ForceAfterAStepOfTheCreepage) {
  constexpr Values near = {{{0.1, .0331014636},
                            {0.25, .0816982671},
                            {0.5, .159832109},
                            {1, .304971877},
                            {1.5, .434168799},
                            {2, .544633750},
                            {3, .700632698},
                            {5, .870805578},
                            {10, .984194798}}};
  constexpr Values far = {{{0.1, .0187843923},
                           {0.25, .0466207068},
                           {0.5, .0920809520},
                           {1, .179290059},
                           {1.5, .261024287},
                           {2, .336135381},
                           {3, .462143079},
                           {5, .647206267},
                           {10, .877063795}}};
  for (const auto& [q, force] : near) {
    EXPECT_NEAR(force_after_creepage_step(q, std::log(20)), force, 3e-8) << q;
  }
  for (const auto& [q, force] : far) {
    EXPECT_NEAR(force_after_creepage_step(q, std::log(200)), force, 3e-8) << q;
  }
}

// The same source.
TEST(SmallMotion, CreepageAfterAStepOfTheForce) {
  constexpr std::array<std::pair<double, double>, 12> exact = {{{0.1, .5128219},
                                                                {0.25, .5333589},
                                                                {0.5, .5716907},
                                                                {1, .6704351},
                                                                {1.5, .8283660},
                                                                {1.9, 1.142406},
                                                                {2.1, 1.190222},
                                                                {2.5, 1.0043685},
                                                                {3, .9715777},
                                                                {4, 1.01719},
                                                                {5, .9980795},
                                                                {8, 1.0000242}}};
  for (const auto& [q, creepage] : exact) {
    EXPECT_NEAR(creepage_after_force_step(q), creepage, q == 4 ? 3e-6 : 3e-7) << q;
  }
}

double integral(const auto& function, double from, double to) {
  constexpr int parts = 20;
  double sum = 0;
  for (int k = 0; k < parts; ++k) {
    sum += boost::math::quadrature::gauss<double, 15>::integrate(
        function, from + k * (to - from) / parts, from + (k + 1) * (to - from) / parts);
  }
  return sum;
}

// After a force that begins to act at once, the creepage follows an Abel equation in the time
// domain: the integral of c(t) sqrt((2 - v)/v), v = q - t, from v = 0 to 2, is arccos(1 - q), pi
// from q = 2 on.
TEST(SmallMotion, CreepageMeetsTheAbelEquation) {
  for (const double q : {0.3, 1.2, 1.9}) {
    // v = q sin^2, with all of the square root.
    const auto part = [&](double angle) {
      const double v = q * std::pow(std::sin(angle), 2);
      return creepage_after_force_step(q - v) * std::sqrt(2 - v) * 2 * std::sqrt(q) *
             std::cos(angle);
    };
    const double least = std::acos(std::sqrt(1e-3 / q));  // c is 1/2 next to q = 0
    EXPECT_NEAR(integral(part, 0, least) + 0.5 * std::sqrt((2 - q) / q) * 1e-3, std::acos(1 - q),
                1e-5)
        << q;
  }
}

// The response to a step has the frequency response as its transform.
TEST(SmallMotion, StepAndHarmonicAgree) {
  using boost::math::quadrature::gauss;
  const double lambda = 1;
  const std::array<double, 3> kappas = {0.3, 2, 5};
  std::array<std::complex<double>, 3> sums = {1e-3, 1e-3, 1e-3};  // up to the least distance
  for (int k = 0; k < 15; ++k) {  // between the kinks at whole multiples of 2
    const double half = k == 0 ? 1 - 5e-4 : 1;
    const double centre = 2 * k + 2 - half;
    for (const double side : {-1.0, 1.0}) {
      for (std::size_t i = 0; i < gauss<double, 20>::abscissa().size(); ++i) {
        const double q = centre + side * half * gauss<double, 20>::abscissa()[i];
        const double missing = 1 - force_after_creepage_step(q, lambda);
        for (std::size_t j = 0; j < kappas.size(); ++j) {
          sums[j] +=
              half * gauss<double, 20>::weights()[i] * missing * std::polar(1.0, -kappas[j] * q);
        }
      }
    }
  }
  EXPECT_LT(std::abs(1 - force_after_creepage_step(30, lambda)), 1e-9);
  for (std::size_t j = 0; j < kappas.size(); ++j) {
    const std::complex<double> slope(0, kappas[j]);
    const auto exact = 1.0 / (adhesion_ratio(kappas[j]) + slope * lambda);
    EXPECT_LT(std::abs(1.0 - slope * sums[j] - exact), 2e-5) << kappas[j];
  }
}

// With L0 next to a/2 the force overshoots. The same to 13 digits whether the asymptotic series
// take over at 100, 200 or 1000.
TEST(SmallMotion, BodiesThatNearlyYield) {
  EXPECT_NEAR(force_after_creepage_step(0.1, 0.2), 0.4419322221338, 1e-10);
  EXPECT_NEAR(force_after_creepage_step(1, 0.2), 1.634002940735, 1e-10);
  EXPECT_NEAR(force_after_creepage_step(4, 0.2), 1.409270238409, 1e-10);
}

TEST(SmallMotion, Limits) {
  for (const double lambda : {0.2, 1.0, 3.0, 30.0, 100.0}) {
    EXPECT_NEAR(force_after_creepage_step(1e-3, lambda) * lambda / 1e-3, 1, 3e-3) << lambda;
  }
  EXPECT_NEAR(force_after_creepage_step(1e3, 0.2), 1, 1e-10);
  EXPECT_NEAR(force_after_creepage_step(1e3, 3), 1, 1e-10);
  EXPECT_NEAR(creepage_after_force_step(1e-3), 0.5, 2e-4);
  EXPECT_NEAR(creepage_after_force_step(1e3), 1, 1e-10);
  EXPECT_EQ(creepage_after_force_step(2), HUGE_VAL);
  EXPECT_NEAR(creepage_after_force_step(2 - 1e-6) - creepage_after_force_step(2 - 1e-3),
              std::log(1e3) / (2 * pi), 1e-3);
  for (const double q : {0.0, 9e-4, -1.0, 1.1e3, HUGE_VAL, std::nan("")}) {
    EXPECT_THROW(force_after_creepage_step(q, 3), std::invalid_argument);
    EXPECT_THROW(creepage_after_force_step(q), std::invalid_argument);
  }
  for (const double lambda : {0.19, 101.0, -1.0, std::nan("")}) {
    EXPECT_THROW(force_after_creepage_step(1, lambda), std::invalid_argument);
  }
}

}  // namespace microslip::small_motion_test
