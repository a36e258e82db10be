// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <stdexcept>
#include <string>

#include "microslip/friction/active_set.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/not_converged.hpp"
#include "stick_zones.hpp"

namespace microslip::structured_contact_test {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Material material{1, 0.28};
const Solver dense{.type = Solver::Type::dense};
const Solver fft{.type = Solver::Type::fft};

SteadyProblem steady(const Kernel& kernel, Index n, const SteadyMethod& method, const Load& load) {
  return {.contact = {kernel, PolynomialBound(1, 1, Eigen::Vector3d(1, 0.3, 0.2))},
          .grid = Grid({.half_width = 1, .elements = n}),
          .basis = constant_basis(),
          .method = method,
          .load = load};
}

struct Kind {
  std::string name;
  Kernel kernel;
  SteadyMethod method;
};

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

class StructuredSteady : public testing::TestWithParam<Kind> {};

TEST_P(StructuredSteady, IsTheDenseSolution) {
  const auto& [name, kernel, method] = GetParam();
  for (const Index n : {41, 300}) {
    for (const Load load : {Load(PrescribedForce{-1.1}), Load(PrescribedForce{0.2}),
                            Load(PrescribedCreepage{0.45}), Load(PrescribedCreepage{-2})}) {
      SteadyProblem problem = steady(kernel, n, method, load);
      problem.solver = dense;
      const SteadySolution expected = solve_steady(problem);
      problem.solver = fft;
      const SteadySolution solution = solve_steady(problem);
      EXPECT_NEAR(solution.force, expected.force, 1e-10);
      EXPECT_NEAR(solution.creepage, expected.creepage, 1e-10);
      EXPECT_LT((solution.traction - expected.traction).lpNorm<Eigen::Infinity>(), 1e-10);
      EXPECT_LT((solution.slip - expected.slip).lpNorm<Eigen::Infinity>(), 1e-9);
      EXPECT_LT((solution.displacement - expected.displacement).lpNorm<Eigen::Infinity>(), 1e-10);
      EXPECT_EQ(solution.zones, expected.zones);
      EXPECT_LE(solution.evidence.residual, 1e-12);
      EXPECT_LE(expected.evidence.residual, 1e-12);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Methods, StructuredSteady,
    testing::Values(Kind{"standard", PlaneKernel(material, 10), Differences{1}},
                    Kind{"standard strip", StripKernel(material, 0.5), Differences{1}},
                    Kind{"half a step", PlaneKernel(material, 10), Differences{0.5}}));

// From a grid of a quarter of the elements, and from a whole step: from adhesion it would be
// log2(N) + 3 for c = 1, and O(N) for c << 1.
TEST(StructuredSteady, NumberOfRoundsDoesNotGrow) {
  for (const Index n : {60, 600, 2400, 20000}) {
    for (const double c : {1.0, 0.5, 0.1, 0.01}) {
      const SteadySolution solution =
          solve_steady(steady(PlaneKernel(material, 10), n, Differences{c}, PrescribedForce{-1.0}));
      EXPECT_LE(solution.iterations, 12) << n << " " << c;
      EXPECT_LE(solution.evidence.residual, 1e-11);
    }
  }
}

// Two zones stick. Where blocks of elements go to and fro, single exchanges go on from there: from
// adhesion everywhere it would be as many as elements slip.
TEST(StructuredSteady, SeveralStickZonesTakeFewRounds) {
  for (const Index n : {26, 51, 76, 90, 101, 120, 150, 190, 401, 6401}) {
    for (const double force : {-0.2, -0.2356, -0.3}) {
      const SteadySolution solution =
          solve_steady({.contact = {PlaneKernel(material, 10),
                                    PolynomialBound(1, 1, Eigen::Vector3d(0.05, 0, 1))},
                        .grid = Grid({.half_width = 1, .elements = n}),
                        .basis = constant_basis(),
                        .method = Calibrated{},
                        .load = PrescribedForce{force}});
      EXPECT_LE(solution.iterations, 20) << n << ' ' << force;
    }
  }
}

/// The bound has a dent in the middle, where slip begins.
TransientProblem transient(const Kernel& kernel, Index n, const AdvectionScheme& scheme,
                           const Solver& solver) {
  return {.contact = {kernel, PolynomialBound(1, 1, Eigen::Vector3d(0.2, 0, 2))},
          .grid = Grid({.half_width = 1, .elements = n}),
          .basis = constant_basis(),
          .scheme = scheme,
          .solver = solver};
}

class StructuredTransient : public testing::TestWithParam<std::string> {
 protected:
  static AdvectionScheme scheme() {
    const std::string name = GetParam();
    if (name == "remembered") return Remembered{};
    if (name == "direct") return Direct{};
    if (name == "relaxed") return Relaxed{1};
    return Fractional{};
  }
};

TEST_P(StructuredTransient, IsTheDenseSolutionWithSeveralStickZonesToo) {
  for (const Kernel& kernel : {Kernel(PlaneKernel(material, GetParam() == "fractional" ? 10 : 0.6)),
                               Kernel(StripKernel(material, 1))}) {
    const double full = 0.35 * std::numbers::pi;
    TransientRolling expected(transient(kernel, 201, scheme(), dense), CattaneoShift{-0.64 * full});
    TransientRolling rolling(transient(kernel, 201, scheme(), fft), CattaneoShift{-0.64 * full});
    const double dx = 2.0 / 201;
    int most_zones = 0;
    for (int step = 0; step < 120; ++step) {
      const double c = step % 3 == 0 ? 1 : 0.4;
      const Load load = step < 40   ? Load(PrescribedForce{-0.64 * full})
                        : step < 80 ? Load(PrescribedForce{(0.02 * (step - 40) - 0.5) * full})
                                    : Load(PrescribedCreepage{0.3});
      expected.step(c * dx, load);
      rolling.step(c * dx, load);
      ASSERT_LT((rolling.state().traction - expected.state().traction).lpNorm<Eigen::Infinity>(),
                1e-10)
          << step;
      ASSERT_NEAR(rolling.state().creepage, expected.state().creepage, 1e-9);
      ASSERT_EQ(rolling.state().zones, expected.state().zones);
      ASSERT_LE(rolling.state().evidence.residual, 1e-12);
      most_zones = std::max(most_zones, stick_zones(rolling.state().zones));
    }
    EXPECT_GT(most_zones, 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, StructuredTransient,
                         testing::Values("remembered", "direct", "relaxed", "fractional"));

// For c -> 0 and an odd number of elements in adhesion the matrix is next to singular, and GMRES
// fails; left the choice, LU is taken.
TEST(Solver, TakesFactorsForTinySteps) {
  for (const double c : {1e-12, 1e-9, 1e-6, 1e-3}) {
    for (const Index n : {100, 147, 201}) {
      SteadyProblem problem =
          steady(PlaneKernel(material, 10), n, Differences{c}, PrescribedForce{-1});
      EXPECT_LE(solve_steady(problem).evidence.residual, 1e-11) << c << " " << n;
    }
  }
}

TEST(Solver, FftIsForEqualFunctions) {
  SteadyProblem problem =
      steady(PlaneKernel(material, 1), 31, Differences{1}, PrescribedCreepage{0.4});
  problem.solver = fft;
  problem.basis = quadratic_basis();
  EXPECT_THROW(solve_steady(problem), std::invalid_argument);
  problem.basis = constant_basis();
  problem.method = Differences{1, 0.1};
  EXPECT_THROW(solve_steady(problem), std::invalid_argument);
}

TEST(Solver, DenseIsForMatricesThatFit) {
  SteadyProblem problem =
      steady(PlaneKernel(material, 1), 100001, Differences{1}, PrescribedCreepage{0.4});
  problem.solver = dense;
  EXPECT_THROW(solve_steady(problem), std::invalid_argument);
  problem.solver = {};
  problem.basis = quadratic_basis();
  EXPECT_THROW(solve_steady(problem), std::invalid_argument);
}

// Rounding is all that is left, so no tolerance of the range is missed here; where the equations
// cannot be solved, the residual says so.
TEST(Solver, ResidualOfASingularSystemIsCarriedByTheException) {
  const VectorXd zeros = VectorXd::Zero(2);
  ActiveSet active_set(LinearOperator(Eigen::MatrixXd::Ones(2, 2)), VectorXd::Ones(2));
  try {
    active_set.solve(
        {.bound = VectorXd::Constant(2, 9), .offset = Eigen::Vector2d(0, 0.5), .reference = zeros},
        PrescribedCreepage{0.1});
    FAIL() << "expected NotConverged";
  } catch (const NotConverged& error) {
    EXPECT_FALSE(error.residual() <= Solver{}.tolerance);
  }
}

}  // namespace microslip::structured_contact_test
