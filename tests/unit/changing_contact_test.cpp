// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::changing_contact_test {

using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

const Material material{1.44, 0.28};  // k = 1/pi
constexpr double full = pi / 2;       // full sliding of the problem's contact

TransientProblem problem_with(const Kernel& kernel, Index n, double half_width = 1, double peak = 1,
                              const AdvectionScheme& scheme = Remembered{}) {
  return {.contact = {kernel, HertzBound(half_width, peak)},
          .grid = Grid({.half_width = half_width, .elements = n}),
          .basis = constant_basis(),
          .scheme = scheme};
}

const PlaneKernel plane(material, 10);
const StripKernel strip(material, 4);

// A contact that has had its size from the start, and one that is given it.
TEST(ChangingContact, OfAnotherSizeFromTheStartIsAnotherProblem) {
  for (const Kernel& kernel : {Kernel(plane), Kernel(strip)}) {
    TransientRolling of_size(problem_with(kernel, 40, 1.3, 0.7));
    TransientRolling scaled(problem_with(kernel, 40));
    scaled.set_contact({1.3, 0.7});
    scaled.start_from(VectorXd::Zero(40));
    EXPECT_NEAR((scaled.x() - of_size.x()).norm(), 0, 1e-14);
    for (int i = 0; i < 50; ++i) {
      const Load load = i < 25 ? Load(PrescribedCreepage{0.2}) : Load(PrescribedForce{-0.3});
      of_size.step(0.03, load);
      scaled.step(0.03, load);
      EXPECT_NEAR(scaled.state().force, of_size.state().force, 1e-12);
      EXPECT_NEAR(scaled.state().creepage, of_size.state().creepage, 1e-11);
      EXPECT_NEAR(scaled.state().dissipation, of_size.state().dissipation, 1e-11);
    }
    EXPECT_NEAR((scaled.traction_at_nodes() - of_size.traction_at_nodes()).norm(), 0, 1e-11);
    EXPECT_NEAR((scaled.bound_at_nodes() - of_size.bound_at_nodes()).norm(), 0, 1e-13);
    EXPECT_NEAR((scaled.displacement() - of_size.displacement()).norm(), 0, 1e-11);
    EXPECT_NEAR(scaled.elastic_energy() / of_size.elastic_energy(), 1, 1e-11);
  }
}

/// Rolls under a load that rises and falls by so much, in the given number of steps an element.
TransientRolling rolled_under_waves(const Kernel& kernel, Index n, int steps, double amplitude) {
  TransientRolling rolling(problem_with(kernel, n));
  const double step = 2.0 / static_cast<double>(n * steps);
  for (double q = step; q < 4 + step / 2; q += step) {
    rolling.set_contact(hertz_scale(1 + amplitude * std::sin(3 * q), 1 + 0.2 * std::sin(q)));
    rolling.step(step, PrescribedCreepage{0.3});
  }
  return rolling;
}

TEST(LongRunsOfChangingContacts, AreOfSecondOrderForAnyStep) {
  for (const Kernel& kernel : {Kernel(plane), Kernel(strip)}) {
    const double exact = rolled_under_waves(kernel, 400, 1, 0.3).state().force;
    for (const int steps : {1, 3}) {
      const auto error = [&](Index n) {
        return std::abs(rolled_under_waves(kernel, n, steps, 0.3).state().force / exact - 1);
      };
      const double coarse = error(25), fine = error(100);
      EXPECT_LE(fine, 1e-3) << steps;
      EXPECT_GE(std::log2(coarse / fine) / 2, 1.5) << steps << ": " << coarse << ' ' << fine;
    }
  }
}

// Slow changes are quasi-static: Carter's contact of each moment.
TEST(ChangingContact, ThatChangesSlowlyIsCarters) {
  TransientRolling rolling(problem_with(plane, 60));
  rolling.roll(20, {0.05}, PrescribedCreepage{0.4}, [](const TransientState&) {});
  const double waves = 2000;
  for (double q = 0; q < waves; q += 1) {
    rolling.set_contact(hertz_scale(1 + 0.5 * std::sin(2 * pi * q / waves)));
    rolling.step(1, PrescribedCreepage{0.4});
    const double a = rolling.state().scale.half_width;
    const double stuck = 1 - 0.4 / a;  // a'/a: the peak is a
    EXPECT_NEAR(rolling.state().force / (full * a * a), -(1 - stuck * stuck), 6e-3);
  }
}

// Force and normal load that rise together in one ratio below friction stick everywhere: on the
// contact of each moment the increment is singular at the edges, and the shift is
// d(delta) = k ln(2 L0/a) dF. At standstill the trailing edge is felt half an element off.
TEST(ChangingContact, ThatGrowsAtStandstillUnderAnObliqueLoadSticks) {
  const double from = 0.5, ratio = 0.8;
  const auto error = [&](Index n) {
    TransientRolling rolling(problem_with(plane, n));
    rolling.set_contact({from, from});
    rolling.start_from(VectorXd::Zero(n));
    double shift = 0, lost = 0;
    for (int i = 1; i <= 16; ++i) {
      const double grown = (1 - from * from) * i / 16;
      rolling.set_contact(hertz_scale(from * from + grown));
      const Shift part = rolling.shift(PrescribedForce{-ratio * full * grown});
      shift += part.distance;
      lost += part.dissipation;
    }
    EXPECT_NEAR(lost, 0, 1e-3 * shift);
    EXPECT_GE(rolling.state().adhesion_elements, n - 2);
    const auto integral = [&](double a) {
      return ratio * full / pi * a * a * (std::log(2 * 10 / a) + 0.5);
    };
    return std::abs(shift / (integral(1) - integral(from)) - 1);
  };
  const double coarse = error(50), fine = error(200);
  EXPECT_LE(fine, 6e-4);
  EXPECT_GE(std::log2(coarse / fine) / 2, 0.8) << coarse << ' ' << fine;
}

// Mindlin and Deresiewicz: while the normal load rises under a constant force nothing happens; a
// force that rises then by less than friction times that rise slips in Cattaneo's strip for its own
// rise, and the shifts of the two rises are Cattaneo's of their own contacts.
TEST(ChangingContact, MeetsMindlinAndDeresiewicz) {
  TransientRolling rolling(problem_with(plane, 400), CattaneoShift{-0.5 * full});
  rolling.set_contact(hertz_scale(2));
  EXPECT_NEAR(rolling.shift(PrescribedForce{-0.5 * full}).distance, 0, 1e-5);
  const double shift = rolling.shift(PrescribedForce{-1.2 * full}).distance;
  const double a = std::sqrt(2.0), tau = 0.7 / 2;
  const double exact =
      2 * full / pi * (tau * (std::log(2 * 10 / a) + 0.5) + (1 - tau) * std::log(1 - tau) / 2);
  EXPECT_NEAR(shift / exact, 1, 2e-3);
  EXPECT_NEAR(static_cast<double>(rolling.state().adhesion_elements) / 400, std::sqrt(1 - tau),
              0.01);
}

TEST(ChangingContact, ThatIsLostCarriesNothingAndReturnsUnstrained) {
  TransientRolling rolling(problem_with(plane, 30));
  rolling.roll(1, {0.1}, PrescribedCreepage{0.3}, [](const TransientState&) {});
  const TransientState before = rolling.state();
  const double stored = rolling.elastic_energy();
  rolling.set_contact({0, 0});
  rolling.step(0.1, PrescribedCreepage{0.3});
  EXPECT_EQ(rolling.state().force, 0);
  EXPECT_EQ(rolling.state().traction.norm(), 0);
  EXPECT_EQ(rolling.state().adhesion_elements + rolling.state().slip_elements, 0);
  EXPECT_NEAR(rolling.state().mean_force, before.force / 2, 1e-15);
  EXPECT_EQ(rolling.state().creepage, 0.3);
  EXPECT_NEAR(rolling.state().dissipation * 0.1, stored - before.force / 2 * 0.3 * 0.1, 1e-15);
  EXPECT_EQ(rolling.displacement().norm(), 0);
  rolling.step(5, PrescribedForce{0});
  EXPECT_THROW(rolling.step(0.1, PrescribedForce{-0.1}), std::invalid_argument);

  // It grows over the step, as a tiny contact at rest does.
  rolling.set_contact({0.8, 0.8});
  TransientRolling rest(problem_with(plane, 30, 0.8e-9, 0.8e-9));
  rest.set_contact({1e9, 1e9});
  for (int i = 0; i < 6; ++i) {
    rolling.step(0.1, PrescribedCreepage{0.3});
    rest.step(0.1, PrescribedCreepage{0.3});
    EXPECT_LT(rolling.state().force, 0);
    EXPECT_NEAR(rolling.state().force / rest.state().force, 1, 1e-6);
  }
  rolling.set_contact({0.8, 0});  // no friction
  rolling.step(0.1, PrescribedCreepage{0.3});
  EXPECT_EQ(rolling.state().force, 0);
  rolling.set_contact({1, 1});
  rolling.step(0.1, PrescribedForce{-0.2});
  EXPECT_NEAR(rolling.state().force, -0.2, 1e-13);
}

// An implicit integrator tries a step in which the contact returns, and rejects it.
TEST(ChangingContact, ThatIsLostStaysSoInAnAttempt) {
  for (const double sign : {1.0, -1.0}) {
    TransientRolling rolling(problem_with(plane, 30));
    rolling.roll(1, {0.1}, PrescribedCreepage{0.3}, [](const TransientState&) {});
    rolling.set_contact({0, 0});
    rolling.step(0.1, PrescribedCreepage{0.3});
    rolling.set_contact({1, 1});
    TransientRolling tried = rolling;
    EXPECT_LT(tried.attempt(sign * 0.1, PrescribedCreepage{sign * 0.3}).force, 0);
    TransientRolling shifted = tried, other = rolling;
    shifted.shift(PrescribedShift{1e-3});
    other.shift(PrescribedShift{1e-3});
    EXPECT_EQ(shifted.state().force, other.state().force);
    tried.step(0.1, PrescribedForce{-0.2});
    rolling.step(0.1, PrescribedForce{-0.2});
    EXPECT_EQ(tried.state().creepage, rolling.state().creepage);
    EXPECT_EQ(tried.state().traction, rolling.state().traction);
  }
}

// Whatever it is that is lost: nodes have no tractions then, and no bound.
TEST(ChangingContact, ThatIsLostHasNoTractionsAtItsNodes) {
  for (const ContactScale& lost :
       {ContactScale{0, 0}, ContactScale{0, 1}, ContactScale{0, 0.7}, ContactScale{0.7, 0}}) {
    TransientRolling rolling(problem_with(strip, 30));
    rolling.roll(1, {0.1}, PrescribedCreepage{0.3}, [](const TransientState&) {});
    EXPECT_GT(rolling.traction_at_nodes().norm(), 1);
    rolling.set_contact(lost);
    rolling.step(0.1, PrescribedCreepage{0.3});
    EXPECT_EQ(rolling.traction_at_nodes().norm(), 0);
    EXPECT_EQ(rolling.bound_at_nodes().norm(), 0);
    EXPECT_EQ(rolling.displacement().norm(), 0);
  }
}

// Work and stored energy balance whatever the contact does, by the state itself.
TEST(ChangingContact, KeepsTheBalanceOfEnergyAndTheBound) {
  for (const Kernel& kernel : {Kernel(plane), Kernel(strip)}) {
    TransientRolling rolling(problem_with(kernel, 50));
    double stored = 0;
    for (int i = 1; i <= 200; ++i) {
      rolling.set_contact(hertz_scale(1 + 0.6 * std::sin(0.21 * i)));
      rolling.step(0.03, PrescribedCreepage{0.3 * std::sin(0.05 * i)});
      const TransientState& state = rolling.state();
      const double now = rolling.elastic_energy();
      EXPECT_NEAR(state.dissipation * 0.03,
                  -state.mean_force * state.creepage * 0.03 - (now - stored), 1e-13);
      stored = now;
      EXPECT_LE((rolling.traction_at_nodes().cwiseAbs() - rolling.bound_at_nodes()).maxCoeff(),
                1e-12);
    }
  }
}

// Growth and shrinkage faster than rolling, and in one step what another has in many.
TEST(ChangingContact, TakesAnyChange) {
  for (const Kernel& kernel : {Kernel(plane), Kernel(strip)}) {
    TransientRolling rolling(problem_with(kernel, 24));
    const std::vector<double> sizes{1, 0.01, 2, 1e-6, 1, 1.0001, 0.5, 3, 0.4};
    for (const double step : {1e-9, 1e-3, 1.0}) {
      for (const double size : sizes) {
        rolling.set_contact({size, size});
        rolling.step(step, PrescribedCreepage{0.1});
        EXPECT_LE(std::abs(rolling.state().force), (1 + 1e-9) * full * size * size) << size;
        rolling.set_contact({1.1 * size, 0.9 * size});
        rolling.shift(PrescribedForce{0.2 * size * size});
        EXPECT_NEAR(rolling.state().force, 0.2 * size * size, 1e-12);
      }
    }
  }
}

TEST(ChangingContact, CanBeTriedAndCopied) {
  TransientRolling rolling = rolled_under_waves(strip, 30, 2, 0.4);
  TransientRolling copy(rolling);
  const auto next = [](TransientRolling& of) {
    of.set_contact({1.2, 0.9});
    of.step(0.05, PrescribedForce{-0.4});
    of.step(0.05, PrescribedForce{-0.3});
    return of.state();
  };
  rolling.set_contact({0.7, 0.7});
  rolling.attempt(0.2, PrescribedForce{-0.1});
  const TransientState state = next(rolling), other = next(copy);
  EXPECT_NEAR(state.creepage, other.creepage, 1e-12);
  EXPECT_NEAR((state.traction - other.traction).norm(), 0, 1e-12);
}

TEST(ChangingContact, HasTheDerivativeByTheLoad) {
  const TransientRolling rolling = rolled_under_waves(plane, 40, 2, 0.4);
  const auto after = [&](double load, StepJacobian& jacobian) {
    TransientRolling tried(rolling);
    tried.set_contact({1.1, 0.8});
    return tried.attempt(0.12, PrescribedCreepage{load}, jacobian);
  };
  StepJacobian jacobian, other;
  const TransientState state = after(0.3, jacobian);
  const double d = 1e-5;
  const double slope = (after(0.3 + d, other).force - after(0.3 - d, other).force) / (2 * d);
  EXPECT_NEAR(jacobian.by_load.force / slope, 1, 1e-6);
  EXPECT_TRUE(std::isnan(jacobian.by_length.force));
  EXPECT_LT(state.force, 0);
}

TEST(ChangingContact, IsRefusedWhereItIsNone) {
  TransientRolling direct(problem_with(plane, 20, 1, 1, Direct{}));
  EXPECT_NO_THROW(direct.set_contact({1, 1}));
  EXPECT_THROW(direct.set_contact({1.1, 1}), std::invalid_argument);
  TransientRolling rolling(problem_with(plane, 20));
  EXPECT_THROW(rolling.set_contact({-1, 1}), std::invalid_argument);
  EXPECT_THROW(rolling.set_contact({1, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(rolling.set_contact({20, 1}), std::invalid_argument);  // L0 = 10
  EXPECT_THROW(hertz_scale(-1), std::invalid_argument);
}

}  // namespace microslip::changing_contact_test
