// SPDX-License-Identifier: GPL-3.0-or-later
// Work of the force that is not stored is dissipated.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "microslip/halfspace/influence.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::dissipation_test {

struct Case {
  AdvectionScheme scheme;
  double step_ratio;
  double accepted;  ///< error with 101 elements, relative
};

/// Dissipation over what the balance says, less 1, after a way on which rolling has become steady.
struct Missing {
  double by_mean;
  double by_end;
};

Missing missing(const Case& c, Eigen::Index n, const Load& load) {
  TransientRolling rolling({.contact = {StripKernel({82000, 0.28}, 10), HertzBound(5, 300)},
                            .grid = Grid({.half_width = 5, .elements = n}),
                            .basis = constant_basis(),
                            .scheme = c.scheme});
  const double length = c.step_ratio * 10 / static_cast<double>(n);
  rolling.roll(60, {length}, load, [](const TransientState&) {});
  // Over an element, as what the material remembers only comes back to where it was after one.
  double by_mean = 0, by_end = 0, work = 0;
  const double stored = rolling.elastic_energy();
  double last = rolling.state().distance;
  rolling.roll(std::max(1.0, c.step_ratio) * 10 / static_cast<double>(n), {length}, load,
               [&](const TransientState& state) {
                 const double step = state.distance - last;
                 last = state.distance;
                 by_mean += step * state.dissipation;
                 by_end += step * state.end_dissipation;
                 work -= step * state.mean_force * state.creepage;
               });
  const double lost = work - (rolling.elastic_energy() - stored);
  return {by_mean / lost - 1, by_end / lost - 1};
}

TEST(Dissipation, OfTransientsIsTheWorkLessWhatIsStored) {
  for (const Case& c :
       {Case{Remembered{}, 1, 1e-12}, Case{Remembered{}, 0.3, 1e-12}, Case{Remembered{}, 2, 1e-12},
        Case{Direct{}, 1, 3e-4}, Case{Direct{}, 0.5, 2e-3}, Case{Direct{}, 2, 2e-3},
        Case{Relaxed{1}, 0.25, 3e-4}, Case{RelaxedTraction{1}, 0.5, 3e-4},
        Case{Fractional{}, 0.5, 0.05}}) {
    for (const double creepage : {0.001, 0.004}) {
      const Missing found = missing(c, 101, PrescribedCreepage{creepage});
      EXPECT_LT(std::abs(found.by_mean), c.accepted) << c.scheme.index() << ' ' << c.step_ratio;
      if (std::holds_alternative<Fractional>(c.scheme)) continue;
      EXPECT_LT(found.by_end, -2.5e-3) << c.scheme.index() << ' ' << c.step_ratio;
    }
  }
}

// On elements that move along with the material, slip under the mean tractions of a step loses the
// work of the force less the stored energy, whatever the tractions are. With the tractions at the
// end of the step the energy of their change is missing.
TEST(Dissipation, MeanTractionsBalanceAnyStepAndThoseAtItsEndDoNot) {
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto any = [&](double) { return uniform(generator); };
  constexpr Eigen::Index n = 24;
  for (const Kernel& kernel :
       {Kernel(PlaneKernel({1, 0.28}, 9)), Kernel(StripKernel({1, 0.28}, 0.7))}) {
    const Eigen::MatrixXd a = influence_matrix(kernel, constant_basis(), 0.1, n);
    for (int i = 0; i < 20; ++i) {
      const Eigen::VectorXd before = Eigen::VectorXd::Zero(n).unaryExpr(any);
      const Eigen::VectorXd after = Eigen::VectorXd::Zero(n).unaryExpr(any);
      const double shift = uniform(generator);  // w dq
      const Eigen::VectorXd slip = (a * (after - before)).array() + shift;
      const double stored = (after.dot(a * after) - before.dot(a * before)) / 2;
      const double change = (after - before).dot(a * (after - before)) / 2;
      const auto missing = [&](const Eigen::VectorXd& p) {
        return -p.sum() * shift - stored - -p.dot(slip);
      };
      EXPECT_NEAR(missing((before + after) / 2), 0, 1e-12);
      EXPECT_NEAR(missing(after), change, 1e-12);
      EXPECT_GT(change, 1e-3);
    }
  }
}

}  // namespace microslip::dissipation_test
