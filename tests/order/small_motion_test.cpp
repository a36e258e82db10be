// SPDX-License-Identifier: GPL-3.0-or-later
// Responses to loads so small that the whole contact sticks, against the linear theory in plane
// strain. With the modified Bessel functions I0, I1 of s a and lambda = ln(2 L0/a), the force after
// a step of the creepage and the creepage after a step of the force are inverse Laplace transforms,
//   F(q) = -(w a/k) L^-1 { 1/(s (I0/(I0 + I1) + s a lambda)) },
//   w(q) = w_steady L^-1 { I0/(s (I0 + I1)) },
// evaluated in 30 digits by de Hoog's method.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "measured_order.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/rolling/frequency_response.hpp"
#include "microslip/rolling/inverted_rolling.hpp"
#include "microslip/rolling/transient.hpp"
#include "test_name.hpp"

namespace microslip::small_motion_test {

using std::numbers::pi;

const Material material{1.44, 0.28};  // k = 1/pi
constexpr double length = 10;
constexpr double tiny = 1e-7;  // of full sliding, which is pi/2

TransientRolling rolling_on(const Kernel& kernel, Eigen::Index n, const AdvectionScheme& scheme) {
  return TransientRolling({.contact = {kernel, HertzBound(1, 1)},
                           .grid = Grid({.half_width = 1, .elements = n}),
                           .basis = constant_basis(),
                           .scheme = scheme});
}

using Value = std::pair<double, double>;

struct Case {
  AdvectionScheme scheme;
  double step_ratio;
  double accepted;  ///< relative error of the force after a step of the creepage, N = 80
};

class SmallMotion : public testing::TestWithParam<Case> {};

/// \return the largest relative error
double error_of_creepage_step(Eigen::Index n, const Case& by) {
  constexpr std::array<Value, 6> exact = {{{0.5, 0.159832109},
                                           {1, 0.304971877},
                                           {1.5, 0.434168799},
                                           {2, 0.544633750},
                                           {3, 0.700632698},
                                           {5, 0.870805578}}};
  TransientRolling rolling = rolling_on(PlaneKernel(material, length), n, by.scheme);
  const double step = by.step_ratio * 2 / static_cast<double>(n);
  double error = 0;
  std::size_t next = 0;
  rolling.roll(5, {step}, PrescribedCreepage{tiny}, [&](const TransientState& state) {
    if (next == exact.size() || state.distance < exact[next].first - step / 2) return;
    const double expected = -pi * tiny * exact[next].second;
    error = std::max(error, std::abs(state.force / expected - 1));
    ++next;
  });
  EXPECT_EQ(next, exact.size());
  return error;
}

constexpr std::array<double, 3> sizes = {40, 80, 160};

/// Returns the errors for three sizes, and prints their order.
std::vector<double> errors_of(double (*error)(Eigen::Index n, const Case& by), const Case& by) {
  std::vector<double> errors;
  for (const double n : sizes) errors.push_back(error(static_cast<Eigen::Index>(n), by));
  measured_order(fmt::format("c = {:g}", by.step_ratio), sizes, errors);
  return errors;
}

TEST_P(SmallMotion, ForceAfterAStepOfTheCreepageIsSecondOrder) {
  const std::vector<double> errors = errors_of(error_of_creepage_step, GetParam());
  EXPECT_LT(errors[1], GetParam().accepted);
  EXPECT_LT(errors[2], GetParam().accepted / 3.3);
  EXPECT_GT(errors[0] / errors[2], 9);
}

/// Returns the error of the creepage, by the difference of the cumulative creep over two elements.
double error_of_force_step(Eigen::Index n, const Case& by) {
  constexpr std::array<Value, 6> exact = {{{0.25, 0.5333589},
                                           {0.5, 0.5716907},
                                           {1, 0.6704351},
                                           {1.5, 0.8283660},
                                           {2.5, 1.0043685},
                                           {3, 0.9715777}}};
  TransientRolling rolling = rolling_on(PlaneKernel(material, length), n, by.scheme);
  const double step_ratio = by.step_ratio;
  const double force = -tiny;
  const double dx = 2 / static_cast<double>(n);
  rolling.start_from_shift({force});
  std::vector<double> creep = {0};  // after each whole element
  double sum = 0;
  rolling.roll(3.2, {step_ratio * dx}, PrescribedForce{force}, [&](const TransientState& state) {
    sum += state.creepage * step_ratio * dx;
    const double whole = static_cast<double>(creep.size()) * dx;
    if (state.distance > whole - step_ratio * dx / 2) creep.push_back(sum);
  });
  double error = 0;
  for (const auto& [distance, part] : exact) {
    const auto k = static_cast<std::size_t>(std::lround(distance / dx));
    const double creepage = (creep.at(k + 1) - creep.at(k - 1)) / (2 * dx);
    error = std::max(error, std::abs(creepage / (tiny / pi * part) - 1));
  }
  return error;
}

TEST_P(SmallMotion, CreepageAfterAStepOfTheForceIsSecondOrder) {
  const std::vector<double> errors = errors_of(error_of_force_step, GetParam());
  EXPECT_LT(errors[1], 2e-4);
  EXPECT_GT(errors[0] / errors[2], 14);
}

INSTANTIATE_TEST_SUITE_P(Steps, SmallMotion,
                         testing::Values(Case{Remembered{}, 1.0, 1.5e-5},
                                         Case{Remembered{}, 0.25, 1.5e-5},
                                         Case{Remembered{}, 0.1, 1.5e-5}),
                         [](const auto& of) {
                           return test::place({{"c", of.param.step_ratio}});
                         });

// About a state with slip, by changes so small that the stick-slip point moves by much less than an
// element: the slip zone does not answer, the stick zone does (FrequencyResponse).
double error_about_state(const Kernel& kernel, Eigen::Index n, double step_ratio,
                         double amplitude) {
  constexpr double wavelength = 10;
  const double wave = 2 * pi / wavelength;
  const HertzBound bound(1, 1);
  const InvertedSolution state =
      InvertedRolling(kernel, bound).solve(PrescribedForce{-0.64 * bound.total()});
  const double mean = state.creepage();
  TransientRolling rolling = rolling_on(kernel, n, Remembered{});
  const double dx = 2 / static_cast<double>(n);
  rolling.roll(20, {dx}, PrescribedCreepage{mean}, [](const TransientState&) {});
  const int steps = static_cast<int>(std::lround(wavelength / (step_ratio * dx)));
  const double step = wavelength / steps;
  std::complex<double> answer = 0;
  for (int period = 0; period < 4; ++period) {
    answer = 0;
    for (int k = 0; k < steps; ++k) {
      const double creepage = amplitude * mean *
                              (std::sin(wave * (k + 1) * step) - std::sin(wave * k * step)) /
                              (wave * step);
      rolling.step(step, PrescribedCreepage{mean + creepage});
      answer += std::polar(2.0 / steps, -wave * (k + 1) * step) * rolling.state().force;
    }
  }
  const std::complex<double> exact =
      FrequencyResponse(kernel, state.stick_edge(), 1, wavelength).slope(wavelength);
  return std::abs(answer / (amplitude * mean) / exact - 1.0);
}

/// In five alignments of the stick-slip point with the elements, for about so many of them. Their
/// order is printed.
std::array<double, 2> largest_errors(std::string_view problem, const Kernel& kernel,
                                     double step_ratio, const std::array<double, 2>& elements) {
  std::array<double, 2> largest{};
  for (const Eigen::Index alignment : {0, 1, 2, 3, 4}) {
    for (const std::size_t k : {0, 1}) {
      const Eigen::Index n = static_cast<Eigen::Index>(elements[k]) + alignment;
      largest[k] = std::max(largest[k], error_about_state(kernel, n, step_ratio, 1e-4));
    }
  }
  measured_order(problem, elements, largest);
  return largest;
}

TEST(SmallMotionAboutCarter, IsSecondOrder) {
  for (const double step_ratio : {1.0, 0.3}) {
    const auto largest = largest_errors(fmt::format("c = {:g}", step_ratio),
                                        PlaneKernel(material, length), step_ratio, {50, 100});
    EXPECT_LT(largest[0], 1.2e-4) << step_ratio;
    EXPECT_LT(largest[1], 3e-5) << step_ratio;
    EXPECT_GT(largest[0] / largest[1], 3.5) << step_ratio;
  }
}

TEST(SmallMotionAboutPartialSlipOfStrips, IsSecondOrder) {
  for (const auto& [width, step_ratio] : {std::pair{2.0, 1.0}, std::pair{0.5, 0.3}}) {
    const auto largest = largest_errors(fmt::format("strip of {:g} a, c = {:g}", width, step_ratio),
                                        StripKernel(material, width), step_ratio, {50, 200});
    EXPECT_LT(largest[0], 2.3e-4) << width;
    EXPECT_LT(largest[1], 1.5e-5) << width;
    EXPECT_NEAR(largest[0] / largest[1], 15, 4) << width;
  }
}

TEST(SmallMotionAboutCarter, DoesNotKnowTheAmplitude) {
  for (const double amplitude : {1e-6, 1e-3, 0.03}) {
    EXPECT_LT(error_about_state(PlaneKernel(material, length), 51, 0.3, amplitude), 3e-4)
        << amplitude;
  }
}

/// Root mean square of the creepage about a polynomial of the fourth degree, over its mean, where
/// nothing happens but that material passes through the elements.
double noise(Eigen::Index n, double step_ratio, double force) {
  TransientRolling rolling({.contact = {PlaneKernel(material, 20), HertzBound(1, 1)},
                            .grid = Grid({.half_width = 1, .elements = n}),
                            .basis = constant_basis(),
                            .scheme = Remembered{}},
                           CattaneoShift{force});
  std::vector<double> places, creepages;
  rolling.roll(2.8, {step_ratio * 2 / static_cast<double>(n)}, PrescribedForce{force},
               [&](const TransientState& state) {
                 if (state.distance < 2.3) return;
                 places.push_back((state.distance - 2.55) / 0.25);
                 creepages.push_back(state.creepage);
               });
  const auto count = static_cast<Eigen::Index>(places.size());
  Eigen::MatrixXd powers(count, 5);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < 5; ++k) {
      powers(i, k) = std::pow(places[static_cast<std::size_t>(i)], static_cast<double>(k));
    }
  }
  const Eigen::VectorXd values = Eigen::Map<const Eigen::VectorXd>(creepages.data(), count);
  const Eigen::VectorXd fitted = powers * least_squares(powers, values);
  return (values - fitted).norm() / std::sqrt(static_cast<double>(count)) / std::abs(values.mean());
}

TEST(Noise, IsBelowOneInTenThousandForAnyStep) {
  for (const double step_ratio : {1.0, 0.37, 0.1, 0.01}) {
    for (const double ratio : {0.9, 0.64, 0.1, 1e-2, 1e-4}) {
      EXPECT_LT(noise(200, step_ratio, -ratio * pi / 2), 1e-4) << ratio << ", " << step_ratio;
    }
  }
}

}  // namespace microslip::small_motion_test
