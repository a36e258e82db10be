// SPDX-License-Identifier: GPL-3.0-or-later
// The mean of the creepage over the last element travelled.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "microslip/rolling/transient.hpp"

namespace microslip {
namespace {

constexpr double full_sliding = std::numbers::pi / 2;

TransientRolling rolling_on(Eigen::Index elements, const AdvectionScheme& scheme = MaterialFixed{},
                            const Start& start = Rest{}) {
  return TransientRolling({.kernel = PlaneKernel(Material{1.44, 0.28}, 20),
                           .bound = HertzBound(1, 1),
                           .grid = Grid({.half_width = 1, .elements = elements}),
                           .basis = constant_basis(),
                           .scheme = scheme},
                          start);
}

/// Creep over the distance, linear over each step, looked up from the whole history.
class History {
 public:
  void include(double length, double creepage) {
    distances_.push_back(distances_.back() + length);
    creeps_.push_back(creeps_.back() + length * creepage);
  }

  double mean_over(double travel) const {
    const double from = std::max(0.0, distances_.back() - travel);
    std::size_t i = 1;
    while (distances_[i] < from) ++i;
    const double slope = (creeps_[i] - creeps_[i - 1]) / (distances_[i] - distances_[i - 1]);
    const double creep = creeps_[i - 1] + (from - distances_[i - 1]) * slope;
    return (creeps_.back() - creep) / (distances_.back() - from);
  }

 private:
  std::vector<double> distances_ = {0}, creeps_ = {0};
};

TEST(ElementCreepage, IsTheMeanOverTheLastElementForAnySteps) {
  constexpr double dx = 0.1;
  std::mt19937 generator(7);
  for (const AdvectionScheme& scheme :
       {AdvectionScheme(MaterialFixed{}), AdvectionScheme(Direct{})}) {
    TransientRolling rolling = rolling_on(20, scheme);
    EXPECT_EQ(rolling.state().element_creepage, 0);
    History history;
    for (int k = 0; k < 400; ++k) {
      const double c = std::exp(std::uniform_real_distribution(std::log(0.02), 0.7)(generator));
      const PrescribedForce force{-0.4 - 0.3 * std::sin(0.1 * k)};
      const double tried = rolling.attempt(c * dx, force).element_creepage;
      rolling.step(c * dx, force);
      const TransientState& state = rolling.state();
      EXPECT_NEAR(state.element_creepage, tried, 1e-12);
      history.include(c * dx, state.creepage);
      const double expected = history.mean_over(std::max(c, 1.0) * dx);
      EXPECT_NEAR(state.element_creepage, expected, 1e-9 * std::abs(expected) + 1e-12);
      if (c >= 1) {
        EXPECT_EQ(state.element_creepage, state.creepage);
      }
    }
    rolling.start_from_shift({-0.5});
    EXPECT_EQ(rolling.state().element_creepage, 0);
    rolling.step(0.3 * dx, PrescribedForce{-0.5});
    EXPECT_EQ(rolling.state().element_creepage, rolling.state().creepage);
  }
}

// Steps of next to nothing are put together, up to a thousandth of an element.
TEST(ElementCreepage, ForgetsNothingOfMinuteSteps) {
  constexpr double dx = 0.1;
  TransientRolling rolling = rolling_on(20);
  double creep = 0;
  int steps = 0;
  const auto roll = [&](int count) {
    for (creep = steps = 0; steps < count; ++steps) {
      rolling.step(dx / 20000, PrescribedCreepage{1e-6 * (1 + 0.5 * std::sin(0.003 * steps))});
      creep += rolling.state().creepage;
    }
  };
  roll(500);
  roll(20000);
  EXPECT_NEAR(rolling.state().element_creepage / (creep / steps), 1, 1e-6);
}

/// Root mean square about a curve of degree 5, over the mean.
double noise_of(const std::vector<double>& creepages) {
  const auto n = static_cast<Eigen::Index>(creepages.size());
  const Eigen::ArrayXd t = Eigen::ArrayXd::LinSpaced(n, -1, 1);
  Eigen::MatrixXd powers(n, 6);
  for (int j = 0; j < 6; ++j) powers.col(j) = t.pow(j);
  const Eigen::VectorXd w = Eigen::Map<const Eigen::VectorXd>(creepages.data(), n);
  const Eigen::VectorXd rest = w - powers * powers.householderQr().solve(w);
  return std::sqrt(rest.squaredNorm() / static_cast<double>(n)) / std::abs(w.mean());
}

struct Noise {
  double of_steps;
  double over_element;
};

/// Under a constant force after a shift, where no peak or kink of the tractions leaves adhesion.
Noise noise_under(double ratio, Eigen::Index elements, double c) {
  const PrescribedForce force{-ratio * full_sliding};
  TransientRolling rolling = rolling_on(elements, MaterialFixed{}, CattaneoShift{force.value});
  std::vector<double> of_steps, over_element;
  const double step = c * 2 / static_cast<double>(elements);
  rolling.roll(2.8, {step}, force, [&](const TransientState& state) {
    if (state.distance < 2.3) return;
    of_steps.push_back(state.creepage);
    over_element.push_back(state.element_creepage);
  });
  return {noise_of(of_steps), noise_of(over_element)};
}

TEST(ElementCreepage, HasLittleOfTheNoiseOfShortSteps) {
  for (const double ratio : {0.9, 0.64, 0.1, 1e-2, 1e-3, 1e-5}) {
    for (const double c : {0.25, 0.1, 0.03}) {
      const Noise noise = noise_under(ratio, 200, c);
      EXPECT_LT(noise.over_element, 1e-3) << ratio << ' ' << c;
      EXPECT_GT(noise.of_steps, 20 * noise.over_element) << ratio << ' ' << c;
    }
  }
}

// Part of a step is taken off where an element is no whole number of steps, as if its creepage were
// even: a tenth of the noise is left with c = 0.3.
TEST(ElementCreepage, HasLessOfItWhereAnElementIsNoWholeNumberOfSteps) {
  for (const double ratio : {0.64, 0.1, 1e-2, 1e-3}) {
    const Noise noise = noise_under(ratio, 200, 0.3);
    EXPECT_GT(noise.of_steps, 8 * noise.over_element) << ratio;
  }
}

}  // namespace
}  // namespace microslip
