// SPDX-License-Identifier: GPL-3.0-or-later
// Shifts without rolling, from any state.
#include "microslip/rolling/shift.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "microslip/reference/fretting_cycle.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/convergence.hpp"

namespace microslip::shift_test {

using Eigen::Index;

const Material material{1.44, 0.28};  // 2 (1 - nu)/G = 1
const HertzBound hertz(1, 1);
const double full_sliding = hertz.total();

TransientProblem problem(Index n, const AdvectionScheme& scheme,
                         const Kernel& kernel = PlaneKernel(material, 20),
                         const TractionBound& bound = hertz) {
  return {.contact = {kernel, bound},
          .grid = Grid({.half_width = 1, .elements = n}),
          .basis = constant_basis(),
          .scheme = scheme};
}

void roll(TransientRolling& rolling, double distance, double length, const Load& load) {
  rolling.roll(distance, {length}, load, [](const TransientState&) {});
}

const std::vector<AdvectionScheme> schemes = {Direct{}, Remembered{}, Relaxed{1}, Fractional{}};

/// Rolled by 12 elements and a part of one.
TransientRolling rolled(const AdvectionScheme& scheme, double part, double creepage) {
  TransientRolling rolling(problem(41, scheme));
  roll(rolling, (12 + part) * 2 / 41, 2.0 / 41, PrescribedCreepage{creepage});
  return rolling;
}

TEST(Shift, OfNothingChangesNothing) {
  for (const AdvectionScheme& scheme : schemes) {
    for (const double part : {0.2, 0.8}) {
      TransientRolling rolling = rolled(scheme, part, 0.1);
      const TransientState before = rolling.state();
      EXPECT_EQ(rolling.shift(PrescribedShift{0}).work, 0);
      EXPECT_EQ(rolling.shift(PrescribedForce{before.force}).distance, 0);
      EXPECT_EQ(rolling.state().traction, before.traction);
      // Nor does one that is very short: here no edge begins to stick or to slip by it. The mean
      // over partitions of Remembered has one element more in a shift, which changes its last
      // digits.
      rolling.shift(PrescribedShift{1e-9});
      const double most = std::holds_alternative<Remembered>(scheme) ? 5e-7 : 1e-7;
      EXPECT_LT((rolling.state().traction - before.traction).lpNorm<Eigen::Infinity>(), most);
    }
  }
}

// The equation of the slip, the bound, and slip against the tractions.
TEST(Shift, MeetsTheContactConditions) {
  for (const AdvectionScheme& scheme : schemes) {
    for (const double by : {-2.0, -0.4, 0.05, 0.3, 3.0}) {
      TransientRolling rolling = rolled(scheme, 0.3, 0.1);
      const Eigen::VectorXd before = rolling.displacement();
      const Shift shift = rolling.shift(PrescribedShift{by});
      const TransientState& state = rolling.state();
      EXPECT_EQ(shift.distance, by);
      const Eigen::VectorXd slip = (rolling.displacement() - before).array() + by;
      EXPECT_LT((slip - shift.slip).lpNorm<Eigen::Infinity>(), 1e-13);
      for (Index i = 0; i < slip.size(); ++i) {
        const double p = state.traction[i];
        // A mean over partitions, up to a tenth of the next node's distance to the bound above it.
        const double near = std::holds_alternative<Remembered>(scheme) ? 0.03 : 1e-14;
        EXPECT_LE(std::abs(p), rolling.bound()[i] + near);
        if (state.zones[static_cast<std::size_t>(i)] == Zone::adhesion) continue;
        EXPECT_NEAR(std::abs(p), rolling.bound()[i], near);
        EXPECT_LE(p * slip[i], near);
      }
      EXPECT_EQ(state.slip.lpNorm<1>(), 0);
      EXPECT_EQ(state.creepage, 0);
      EXPECT_EQ(state.dissipation, 0);
      EXPECT_GT(state.distance, 0);
    }
  }
}

TEST(Shift, BalancesEnergyToRounding) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const AdvectionScheme& scheme : schemes) {
    for (const Kernel& kernel :
         {Kernel(PlaneKernel(material, 20)), Kernel(StripKernel(material, 3))}) {
      TransientRolling rolling(problem(31, scheme, kernel));
      for (int i = 0; i < 40; ++i) {
        const double before = rolling.elastic_energy();
        const Shift shift = i % 2 == 0
                                ? rolling.shift(PrescribedShift{uniform(generator)})
                                : rolling.shift(PrescribedForce{full_sliding * uniform(generator)});
        EXPECT_NEAR(shift.work - shift.dissipation, rolling.elastic_energy() - before, 1e-14);
        if (i % 5 == 0) roll(rolling, 0.11, 0.05, PrescribedCreepage{0.1 * uniform(generator)});
      }
    }
  }
}

// A steady way that is divided: by the scheme of the thesis all is the same, the energies included.
TEST(Shift, InPartsIsTheSame) {
  for (const double part : {0.0, 0.35, 0.8}) {
    for (const double by : {-3.0, -1.0, -0.1, 0.01, 0.1, 1.0, 3.0}) {
      for (const AdvectionScheme& scheme :
           {AdvectionScheme(Direct{}), AdvectionScheme(Remembered{})}) {
        const bool mean = std::holds_alternative<Remembered>(scheme);
        TransientRolling whole = rolled(scheme, part, 0.2);
        TransientRolling parts = whole;
        const Shift shift = whole.shift(PrescribedShift{by});
        double work = 0, dissipation = 0;
        for (int i = 0; i < 7; ++i) {
          const Shift one = parts.shift(PrescribedShift{by / 7});
          work += one.work;
          dissipation += one.dissipation;
        }
        const double difference =
            (whole.state().traction - parts.state().traction).lpNorm<1>() / 20;
        const std::string which = std::to_string(part) + ' ' + std::to_string(by);
        EXPECT_LT(difference, mean ? 1e-2 : 1e-13) << which;
        EXPECT_NEAR(work, shift.work, mean ? 5e-3 * std::abs(shift.work) : 1e-14) << which;
        EXPECT_NEAR(dissipation, shift.dissipation, mean ? 5e-3 * std::abs(shift.work) : 1e-14)
            << which;
      }
    }
  }
}

// Along the way the force changes; the sums by the trapezoidal rule tend to the work. With
// Remembered they end beside it, as the slip of nodes is not the mean over partitions.
TEST(Shift, WorkIsTheAreaUnderTheForce) {
  for (const AdvectionScheme& scheme : {AdvectionScheme(Direct{}), AdvectionScheme(Remembered{})}) {
    TransientRolling start(problem(40, scheme));
    start.shift(PrescribedForce{-0.7 * full_sliding});
    TransientRolling whole = start;
    const Shift shift = whole.shift(PrescribedForce{0.6 * full_sliding});
    std::vector<double> sizes, errors;
    for (const int n : {20, 40, 80, 160}) {
      TransientRolling parts = start;
      double work = 0;
      for (int i = 1; i <= n; ++i) {
        const double before = parts.state().force;
        const double to = (-0.7 + 1.3 * i / n) * full_sliding;
        work -= (before + to) / 2 * parts.shift(PrescribedForce{to}).distance;
      }
      sizes.push_back(n);
      errors.push_back(work - shift.work);
    }
    const bool mean = std::holds_alternative<Remembered>(scheme);
    if (!mean) {
      EXPECT_NEAR(fitted_order(sizes, errors), 2, 0.4);
    }
    EXPECT_LT(std::abs(errors.back()), (mean ? 5e-4 : 1e-4) * std::abs(shift.work));
  }
}

TEST(Shift, ByForceAndByDistanceAgree) {
  for (const AdvectionScheme& scheme : schemes) {
    TransientRolling by_distance = rolled(scheme, 0.6, 0.1);
    TransientRolling by_force = by_distance;
    by_distance.shift(PrescribedShift{0.7});
    // Partitions of one force have other shifts: their mean agrees to third order in dx.
    const bool mean = std::holds_alternative<Remembered>(scheme);
    EXPECT_NEAR(by_force.shift(PrescribedForce{by_distance.state().force}).distance, 0.7,
                mean ? 1e-6 : 1e-12);
    EXPECT_LT((by_force.state().traction - by_distance.state().traction).lpNorm<Eigen::Infinity>(),
              mean ? 3e-4 : 1e-12);
  }
}

TEST(Shift, FromRestIsTheStart) {
  for (const AdvectionScheme& scheme : schemes) {
    TransientRolling one = rolled(scheme, 0.6, 0.1);
    TransientRolling other(problem(41, scheme));
    const double force = -0.4 * full_sliding;
    EXPECT_EQ(one.start_from_shift({force}), other.shift(PrescribedForce{force}).distance);
    EXPECT_EQ(one.state().traction, other.state().traction);
    EXPECT_EQ(one.state().distance, 0);
  }
}

// With all else as if it had not been tried.
TEST(Shift, IsRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const AdvectionScheme& scheme : schemes) {
    TransientRolling rolling = rolled(scheme, 0.6, 0.1);
    TransientRolling untouched = rolling;
    for (const double force : {1.01 * full_sliding, -2 * full_sliding, nan}) {
      EXPECT_THROW(rolling.shift(PrescribedForce{force}), std::invalid_argument);
      EXPECT_THROW(rolling.start_from_shift({force}), std::invalid_argument);
    }
    EXPECT_THROW(rolling.shift(PrescribedShift{nan}), std::invalid_argument);
    EXPECT_THROW(rolling.shift(PrescribedShift{HUGE_VAL}), std::invalid_argument);
    for (TransientRolling* one : {&rolling, &untouched}) {
      one->step(0.01, PrescribedCreepage{0.1});
      one->shift(PrescribedForce{0.3});
    }
    EXPECT_EQ(rolling.state().traction, untouched.state().traction);
  }
}

// Mindlin's loop in steps: the way back, by half the change of the force, is twice the way there.
TEST(Shift, StepsGoAlongMindlinsLoop) {
  constexpr int steps = 7;
  for (const int elements : {30, 60, 144}) {
    for (const double tau : {0.3, 0.8}) {
      TransientRolling rolling(problem(elements, Remembered{}));
      const double most = tau * full_sliding;
      std::vector<double> there{0};
      for (int i = 1; i <= steps; ++i) {
        const double distance = rolling.shift(PrescribedForce{most * i / steps}).distance;
        there.push_back(there.back() + distance);
      }
      for (const double sign : {-1.0, 1.0}) {
        double back = 0;
        for (int i = 1; i <= steps; ++i) {
          const double force = sign * most * (2.0 * i / steps - 1);
          back += rolling.shift(PrescribedForce{force}).distance;
          const double expected = sign * 2 * there[static_cast<std::size_t>(i)];
          EXPECT_NEAR(back, expected, 4e-4 * std::abs(there.back()))
              << elements << ' ' << tau << ' ' << i;
        }
        EXPECT_NEAR(back, sign * 2 * there.back(), 1e-12);
      }
    }
  }
}

// To and fro under the same forces: from the first way back on, each cycle is the same.
TEST(Shift, CyclesAreClosed) {
  for (const AdvectionScheme& scheme : schemes) {
    for (const double tau : {0.05, 0.3, 0.6, 0.95}) {
      TransientRolling rolling(problem(61, scheme));
      const double force = tau * full_sliding;
      rolling.shift(PrescribedForce{force});
      const Eigen::VectorXd start = rolling.state().traction;
      double distance = 0;
      for (const double to : {-force, force})
        distance += rolling.shift(PrescribedForce{to}).distance;
      EXPECT_NEAR(distance, 0, 1e-12) << tau;
      EXPECT_LT((rolling.state().traction - start).lpNorm<Eigen::Infinity>(), 1e-11) << tau;
    }
  }
}

}  // namespace microslip::shift_test
