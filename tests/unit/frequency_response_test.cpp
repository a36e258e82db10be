// SPDX-License-Identifier: GPL-3.0-or-later
// Tables without another source were derived for this project, and confirmed by boundary elements.
#include "microslip/rolling/frequency_response.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "microslip/rolling/inverted_rolling.hpp"
#include "scene_text.hpp"

namespace microslip::frequency_response_test {

using Complex = std::complex<double>;
using std::numbers::pi;

const Material material{1.44, 0.28};  // k = 1/pi

Complex ratio(const FrequencyResponse& response, double wavelength) {
  return response.slope(wavelength) / response.steady_slope();
}

TEST(FrequencyResponse, AdhesionInPlaneStrain) {
  struct Row {
    double wavelength;
    Complex ratio;
    double size10, angle10, size100, angle100;
  };
  constexpr std::array<Row, 5> rows = {
      {{0.1,
        {0.501973470945, 0.499996105397},
        .005298628764,
        -1.568136553,
        .002999368882,
        -1.569290723},
       {1, {0.518240099292, 0.499667188014}, .0517347791, -1.543982077, .02959109463, -1.555460434},
       {5, {0.611441705440, -0.487422554144}, .2999689231, -1.386338576, .1612679805, -1.472029861},
       {10,
        {0.901388115321, -0.298140203393},
        .5486576576,
        -1.053475302,
        .3162467500,
        -1.281726194},
       {100,
        {0.999013039640, -0.0314004182966},
        .9888774771,
        -.1557111453,
        .9582963528,
        -.2931078511}}};
  // The contact has the half-width 3, and L0 = 10 a and 100 a.
  const FrequencyResponse near(PlaneKernel(material, 30), -3, 3, 0.3);
  const FrequencyResponse far(PlaneKernel(material, 300), -3, 3, 0.3);
  EXPECT_NEAR(near.steady_slope(), -3 * pi, 1e-13);
  for (const auto& [wavelength, exact, size10, angle10, size100, angle100] : rows) {
    EXPECT_LT(std::abs(adhesion_ratio(2 * pi / wavelength) - exact), 2e-12);
    EXPECT_NEAR(std::abs(ratio(near, 3 * wavelength)) / size10, 1, 3e-10);
    EXPECT_NEAR(std::arg(ratio(near, 3 * wavelength)), angle10, 1e-9);
    EXPECT_NEAR(std::abs(ratio(far, 3 * wavelength)) / size100, 1, 3e-10);
    EXPECT_NEAR(std::arg(ratio(far, 3 * wavelength)), angle100, 1e-9);
    EXPECT_LT(near.estimated_error(3 * wavelength), 1e-12);
  }
  EXPECT_EQ(near.terms(), 0);
}

TEST(FrequencyResponse, AboutACarterState) {
  const FrequencyResponse response(PlaneKernel(material, 10), -0.2, 1, 1);
  EXPECT_LT(std::abs(response.slope(1) / pi - Complex(-.0033692311, .0449227514)), 1e-10);
  EXPECT_LT(std::abs(response.slope(5) / pi - Complex(-.0857665187, .2293715155)), 1e-10);
  EXPECT_LT(std::abs(response.slope(10) / pi - Complex(-.2603634562, .3068929811)), 1e-10);
  EXPECT_LT(std::abs(response.slope(100) / pi - Complex(-.5925943427, .0671932052)), 1e-10);
}

// Without a dissipation of the linear part: force and creepage are in quadrature where J0 vanishes.
TEST(FrequencyResponse, Quadrature) {
  const FrequencyResponse response(PlaneKernel(material, 7), -1, 1, 0.5);
  for (const double wavelength : {2.612741, 1.138242, 0.726066}) {
    const Complex slope = response.slope(wavelength);
    EXPECT_NEAR(slope.real() / std::abs(slope), 0, 1e-6);
  }
}

TEST(FrequencyResponse, OfAStrip) {
  const FrequencyResponse response(StripKernel(material, 2), -1, 1, 0.3);
  EXPECT_NEAR(-response.steady_slope() / pi, 1.1454912567, 1e-10);
  constexpr std::array<std::array<double, 3>, 4> rows = {{{1, .0725174593, -1.534070771},
                                                          {5, .4398735297, -1.281326817},
                                                          {10, .7205924272, -.853218234},
                                                          {100, .9955641111, -.103030544}}};
  for (const auto& [wavelength, size, angle] : rows) {
    EXPECT_NEAR(std::abs(ratio(response, wavelength)), size, 1e-10);
    EXPECT_NEAR(std::arg(ratio(response, wavelength)), angle, 1e-9);
  }
}

// A strip of the width Dy tends to plane strain with L0 = Dy exp(nu/(1 - nu)); the rest is
// (a/Dy)^2.
TEST(FrequencyResponse, OfAWideStripIsPlaneStrain) {
  const double wide = 1e6;
  const FrequencyResponse strip(StripKernel(material, wide), 0.4, 1, 0.02);
  const FrequencyResponse plane(PlaneKernel(material, wide * std::exp(0.28 / 0.72)), 0.4, 1, 0.02);
  for (const double wavelength : {0.02, 0.03, 0.13, 0.5, 1.0, 3.0, 40.0, 1e4, 1e9}) {
    EXPECT_LT(std::abs(strip.slope(wavelength) / plane.slope(wavelength) - 1.0), 1e-11)
        << wavelength;
    EXPECT_LT(strip.estimated_error(wavelength), 1e-11);
  }
  EXPECT_NEAR(strip.steady_slope() / plane.steady_slope(), 1, 1e-11);
}

// Widths, stick zones and wavelengths as they come; what few terms give differs.
TEST(LongRunsOfFrequencyResponse, EstimateNarrowStrips) {
  for (const double width : {0.1, 0.3, 1.0, 8.0}) {
    for (const double begin : {-1.0, 0.0, 0.9}) {
      const double length = 1 - begin;
      const FrequencyResponse response(StripKernel(material, width), begin, 1, 0.15 * length);
      const FrequencyResponse finer(StripKernel(material, width), begin, 1, 0.05 * length);
      for (const double wavelength : {0.15, 0.4, 1.0, 7.0, 90.0}) {
        const Complex slope = response.slope(wavelength * length);
        EXPECT_LT(std::abs(slope / finer.slope(wavelength * length) - 1.0), 1e-10) << width;
        EXPECT_LT(response.estimated_error(wavelength * length), 1e-10) << width << ' ' << begin;
      }
    }
  }
}

/// Returns the slope of the curve of steady rolling, by a difference of the fourth order.
double slope_of_curve(const InvertedRolling& rolling, double creepage) {
  const auto force = [&](double part) {
    return rolling.solve(PrescribedCreepage{creepage * (1 + part)}).force();
  };
  const double h = 1e-3;
  return (8 * (force(h) - force(-h)) - (force(2 * h) - force(-2 * h))) / (12 * h * creepage);
}

// Slip zones do not answer: the stick zone alone knows the slope of the curve, whatever the bound.
TEST(FrequencyResponse, OfLongWavesIsTheSlopeOfTheCurve) {
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(5, -2, 2);
  const TabulatedBound falls(2, x, (Eigen::VectorXd(5) << 0, 1.2, 1.5, 0.6, 0).finished());
  const std::array<TractionBound, 3> bounds = {
      HertzBound(2, 1), PolynomialBound(2, 1, Eigen::Vector3d(1, 0.3, 0.2)), falls};
  for (const Kernel& kernel : {Kernel(PlaneKernel(material, 7)), Kernel(StripKernel(material, 3)),
                               Kernel(StripKernel(material, 30))}) {
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      const InvertedRolling rolling(kernel, bounds[i]);
      for (const double part : {0.05, 0.4, 0.7}) {
        const double force = -part * full_sliding_force(bounds[i]);
        const InvertedSolution state = rolling.solve(PrescribedForce{force});
        ASSERT_TRUE(state.keeps_conditions());
        EXPECT_EQ(state.stick_end() < 2, i == 2);  // the table slips before the stick zone, too
        const FrequencyResponse response(kernel, state.stick_edge(), state.stick_end(), 1);
        EXPECT_NEAR(response.steady_slope() / slope_of_curve(rolling, state.creepage()), 1, 1e-7)
            << i << ' ' << part;
        EXPECT_LT(std::abs(ratio(response, 1e7) - 1.0), 1e-5);
      }
    }
  }
}

TEST(FrequencyResponse, DependsOnNoUnit) {
  for (const double scale : {1e-6, 1e6}) {
    const FrequencyResponse response(StripKernel(material, 2 * scale), -scale, scale, scale / 3);
    EXPECT_NEAR(response.steady_slope() / scale / pi, -1.1454912567, 1e-9);
    EXPECT_NEAR(std::abs(ratio(response, 5 * scale)), .4398735297, 1e-9);
  }
}

TEST(FrequencyResponse, RefusesWhatItCannot) {
  const StripKernel strip(material, 1);
  EXPECT_EQ(message([&] { FrequencyResponse(strip, 1, 1, 1); }),
            "length of the stick zone = 0: expected a number > 0");
  EXPECT_TRUE(message([&] {
                FrequencyResponse(StripKernel(material, 0.01), -1, 1, 1);
              }).starts_with("width = 0.01: expected at least 0.09"));
  const std::string least = message([&] { FrequencyResponse(strip, -1, 1, 1e-5); });
  const std::string begins = "shortest = 1e-05: expected at least ";
  ASSERT_TRUE(least.starts_with(begins)) << least;
  EXPECT_NO_THROW(FrequencyResponse(strip, -1, 1, 1.001 * std::stod(least.substr(begins.size()))));
  EXPECT_THROW(FrequencyResponse(strip, -1, 1, 0.999 * std::stod(least.substr(begins.size()))),
               BadParameter);
  EXPECT_TRUE(message([&] {
                FrequencyResponse(PlaneKernel(material, 1), -1, 1, 1e-7);
              }).starts_with("shortest = 1e-07: expected at least 6.28"));
  EXPECT_TRUE(message([&] {
                FrequencyResponse(PlaneKernel(material, 0.5), -1, 1, 1);
              }).starts_with("length = 0.5: expected more than 0.5, "));
  const FrequencyResponse response(strip, -1, 1, 0.5);
  for (const double wavelength : {0.49, 0.0, -1.0, HUGE_VAL, std::nan("")}) {
    EXPECT_THROW(response.slope(wavelength), BadParameter) << wavelength;
  }
}

}  // namespace microslip::frequency_response_test
