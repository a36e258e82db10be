// SPDX-License-Identifier: GPL-3.0-or-later
// The frequency response about states that slip on both sides of the stick zone, for plane strain
// and strips, by boundary elements, which know nothing of stick zones.
#include "microslip/rolling/frequency_response.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "microslip/rolling/inverted_rolling.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::frequency_response_test {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double period = 20;  // in which both waves return
constexpr std::array<double, 2> wavelengths{10, 2.5};
constexpr double amplitude = 1e-3;  // of each, over the creepage

/// dF/dw of each wave; the creepage of a step is its mean, the force that at its end.
std::array<Complex, 2> by_elements(const Kernel& kernel, const TractionBound& bound,
                                   double creepage, Eigen::Index n) {
  TransientRolling rolling({.contact = {kernel, bound},
                            .grid = Grid({.half_width = 1, .elements = n}),
                            .basis = constant_basis(),
                            .scheme = Remembered{}});
  const double step = 2 / static_cast<double>(n);
  const long steps = std::lround(period / step);
  std::array<Complex, 2> slopes{};
  for (long i = -2 * steps; i < steps; ++i) {
    const double from = static_cast<double>(i) * step;
    double w = creepage;
    for (const double length : wavelengths) {
      const double wave = 2 * pi / length;
      w += amplitude * creepage * (std::sin(wave * (from + step)) - std::sin(wave * from)) /
           (wave * step);
    }
    rolling.step(step, PrescribedCreepage{w});
    for (std::size_t j = 0; i >= 0 && j < slopes.size(); ++j) {
      const double phase = 2 * pi / wavelengths[j] * (from + step);
      slopes[j] += 2 * step / period * rolling.state().force / (amplitude * creepage) *
                   std::polar(1.0, -phase);
    }
  }
  return slopes;
}

TEST(FrequencyResponse, WithSlipOnBothSidesIsThatOfElements) {
  const Material material{1.44, 0.28};
  const TabulatedBound bound(1, Eigen::Vector3d(-1, 0.2, 1), Eigen::Vector3d(0, 1, 0));
  for (const Kernel& kernel :
       {Kernel(PlaneKernel(material, 10)), Kernel(StripKernel(material, 2))}) {
    const InvertedSolution state =
        InvertedRolling(kernel, bound).solve(PrescribedForce{-0.7 * full_sliding_force(bound)});
    ASSERT_TRUE(state.keeps_conditions());
    ASSERT_LT(state.stick_end(), 0.98);
    const FrequencyResponse exact(kernel, state.stick_edge(), state.stick_end(), 1);
    const FrequencyResponse to_the_edge(kernel, state.stick_edge(), 1, 1);
    const auto slopes = by_elements(kernel, bound, state.creepage(), 201);
    for (std::size_t j = 0; j < slopes.size(); ++j) {
      EXPECT_LT(std::abs(slopes[j] / exact.slope(wavelengths[j]) - 1.0), 8e-3) << j;
      EXPECT_GT(std::abs(slopes[j] / to_the_edge.slope(wavelengths[j]) - 1.0), 1e-2) << j;
    }
  }
}

}  // namespace microslip::frequency_response_test
