// SPDX-License-Identifier: GPL-3.0-or-later
// Transients of contacts that nobody chose, by the schemes that take any step: against the scheme
// of the thesis with c = 1, which has another grid and other bounds of its elements, extrapolated.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/transient.hpp"
#include "property/generated_contacts.hpp"
#include "property/samples.hpp"

namespace microslip::generated_transients_test {

using Eigen::Index;

TransientRolling rolling(const SteadyContact& contact, Index elements,
                         const AdvectionScheme& scheme, const Start& start) {
  return TransientRolling({.contact = contact,
                           .grid = Grid({.half_width = half_width, .elements = elements}),
                           .basis = constant_basis(),
                           .scheme = scheme},
                          start);
}

/// The integral of the creepage over a distance of 1.5 half-widths, after a shift.
double cumulative_creep(const SteadyContact& contact, Index elements, double step_ratio,
                        const AdvectionScheme& scheme) {
  const double force = std::get<PrescribedForce>(contact.load).value;
  TransientRolling rolled = rolling(contact, elements, scheme, CattaneoShift{force});
  const double dx = 2 * half_width / static_cast<double>(elements);
  double creep = 0, before = 0;
  rolled.roll(1.5 * half_width, {step_ratio * dx}, PrescribedForce{force},
              [&](const TransientState& state) {
                creep += state.creepage * (state.distance - before);
                before = state.distance;
              });
  return creep;
}

/// The force after that distance from rest, under the creepage of steady rolling.
double force_from_rest(const SteadyContact& contact, double creepage, Index elements,
                       double step_ratio, const AdvectionScheme& scheme) {
  TransientRolling rolled = rolling(contact, elements, scheme, Rest{});
  const double dx = 2 * half_width / static_cast<double>(elements);
  rolled.roll(1.5 * half_width, {step_ratio * dx}, PrescribedCreepage{creepage},
              [](const TransientState&) {});
  return rolled.state().force;
}

// Within one and a half times the larger of 1 % (of 3 % where the bound jumps) and the error of the
// thesis's scheme with as many elements and c = 1; the truth is known to the difference of the two
// that are extrapolated.
TEST(GeneratedTransients, AreRight) {
  ContactGenerator generator(seed_of_tests() + 2000);
  double worst_creep = 0, worst_force = 0;
  for (int i = 0; i < samples(60); ++i) {
    const auto [kind, contact] = generator.next();
    if (!rolls_transiently(contact)) continue;
    const double creepage = steady_creepage(contact);
    const auto check = [&](const auto& result, double step_ratio, double& worst) {
      const double coarse = result(200, 1, Direct{});
      const double fine = result(400, 1, Direct{});
      const double truth = 2 * fine - coarse;
      const double error = std::abs(result(100, step_ratio, Remembered{}) - truth);
      const double other = std::abs(result(100, 1, Direct{}) - truth);
      worst = std::max(worst, error / std::abs(truth));
      EXPECT_LE(error, 1.5 * std::max((kind == "jumps" ? 0.03 : 0.01) * std::abs(truth), other) +
                           std::abs(fine - coarse))
          << kind << ", case " << i << ", c = " << step_ratio << ": " << error / truth;
    };
    const double step_ratio = i % 2 == 0 ? 1 : 0.3;
    check([&](auto... a) { return cumulative_creep(contact, a...); }, step_ratio, worst_creep);
    check([&](auto... a) { return force_from_rest(contact, creepage, a...); }, step_ratio,
          worst_force);
  }
  std::cout << "largest relative error, N = 100: cumulative creep " << worst_creep << ", force "
            << worst_force << '\n';
}

// Where the bound is not reached, it has no influence. The start slips next to either edge.
TEST(GeneratedTransients, DoNotKnowTheBoundWhereItSticks) {
  const SteadyContact contact{{PlaneKernel({82000, 0.28}, 50), HertzBound(half_width, 300)},
                              PrescribedForce{-100}};
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(2001, -half_width, half_width);
  const TabulatedBound smooth(half_width, x, bound_at(contact.bound, x));
  const TabulatedBound rough(half_width, x, x.unaryExpr([&](double at) {
    const double g = 300 * std::sqrt(std::max(0.0, 1 - std::pow(at / half_width, 2)));
    return at < -3 || at > 4 ? g : g * (2 + std::sin(40 * at));
  }));
  for (const double step_ratio : {1.0, 0.3}) {
    const auto creep = [&](const TractionBound& bound) {
      return cumulative_creep({{contact.kernel, bound}, contact.load}, 60, step_ratio,
                              Remembered{});
    };
    EXPECT_NEAR(creep(rough) / creep(smooth), 1, 1e-9) << step_ratio;
  }
}

}  // namespace microslip::generated_transients_test
