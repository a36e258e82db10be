// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/evidence.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <string>

#include "microslip/halfspace/influence.hpp"
#include "microslip/linalg/inverse_norm.hpp"
#include "microslip/linalg/toeplitz_inverse.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const Kernel plane = PlaneKernel({1, 0.28}, 10);

double norm(const MatrixXd& matrix) { return matrix.cwiseAbs().colwise().sum().maxCoeff(); }

SteadyProblem steady(Index n, const SteadyMethod& method, const Load& load) {
  return {.kernel = plane,
          .bound = HertzBound(1, 1),
          .grid = Grid({.half_width = 1, .elements = n}),
          .method = method,
          .load = load};
}

std::string refusal(const Evidence& evidence, double condition) {
  try {
    require_evidence(evidence, condition, 3, {});
    return "";
  } catch (const NotConverged& error) {
    return error.what();
  }
}

TEST(InverseNorm, IsNearlyThatOfTheInverse) {
  for (const Index n : {2, 10, 60}) {
    const MatrixXd matrix = influence_difference_matrix(plane, linear_basis(), 0.1, n, 0.3);
    const auto estimate = inverse_norm(
        n, [&](VectorXd& x) { x = matrix.lu().solve(x).eval(); },
        [&](VectorXd& x) { x = matrix.transpose().lu().solve(x).eval(); });
    EXPECT_LE(estimate, 1.0001 * norm(matrix.inverse())) << n;
    EXPECT_GE(estimate, norm(matrix.inverse()) / 3) << n;
  }
}

TEST(Condition, OfAToeplitzMatrixIsThatOfAllItsEntries) {
  for (const double c : {1.0, 0.1, 0.01}) {
    for (const Index n : {70, 401}) {
      const Toeplitz toeplitz =
          influence_difference_toeplitz(plane, constant_basis().shapes().front(), 0.1, n, c);
      const MatrixXd all = toeplitz.dense();
      EXPECT_NEAR(toeplitz.norm(), norm(all), 1e-13 * norm(all));
      const double exact = norm(all) * norm(all.inverse());
      const double estimate = ToeplitzInverse(toeplitz).condition();
      EXPECT_LE(estimate, 1.0001 * exact) << c << " " << n;
      EXPECT_GE(estimate, exact / 3) << c << " " << n;
    }
  }
}

// A - A' of an odd number of elements is singular for c -> 0 under a creepage; a force makes it
// regular again.
TEST(Condition, OfTinyStepsGrowsAsTheirInverse) {
  const auto condition = [](double c, const Load& load) {
    return solve_steady(steady(15, Differences{c}, load)).condition;
  };
  const PrescribedCreepage all_sticks{0};
  EXPECT_NEAR(condition(1e-8, all_sticks) / condition(1e-6, all_sticks), 100, 5);
  EXPECT_GT(condition(1e-10, all_sticks), 1e10);
  EXPECT_LT(condition(1e-10, PrescribedForce{-0.1}), 1e3);
}

// Both are of the equations as they are factorised; the creepage borders dense matrices.
TEST(Condition, IsAboutThatOfDenseMatricesByFftAsWell) {
  for (const SteadyMethod& method : {SteadyMethod(Calibrated{}), SteadyMethod(Differences{1})}) {
    SteadyProblem problem = steady(400, method, PrescribedForce{-1});
    problem.solver.type = Solver::Type::dense;
    const double dense = solve_steady(problem).condition;
    problem.solver.type = Solver::Type::fft;
    const double fft = solve_steady(problem).condition;
    EXPECT_GT(fft, dense / 100);
    EXPECT_LT(fft, dense * 10);
    EXPECT_GT(dense, 50);
  }
  EXPECT_EQ(solve_steady(steady(400, Calibrated{}, PrescribedCreepage{9})).condition, 1);
  EXPECT_EQ(solve_steady(steady(400, Differences{1}, PrescribedCreepage{9})).condition, 1);
}

// The largest violations, as anyone may count them.
TEST(Evidence, IsWhatTheTractionsAndTheSlipSay) {
  for (const SteadyMethod& method : {SteadyMethod(Calibrated{}), SteadyMethod(Differences{0.3}),
                                     SteadyMethod(ChebyshevCollocation{})}) {
    const SteadySolution found = solve_steady(steady(101, method, PrescribedForce{-0.9}));
    const double excess = (found.traction.cwiseAbs() - found.bound).maxCoeff();
    const double along = (found.traction.array() * found.slip.array() > 0)
                             .select(found.slip.cwiseAbs(), 0)
                             .maxCoeff() /
                         found.creepage;
    EXPECT_LE(excess, found.evidence.bound_violation + 1e-14);
    EXPECT_LE(along, found.evidence.slip_violation + 1e-14);
    EXPECT_LE(found.evidence.bound_violation, 1e-12);
    EXPECT_LE(found.evidence.slip_violation, 1e-12);
    EXPECT_GT(found.evidence.residual, 0);
    EXPECT_LE(found.evidence.residual, 1e-13);
  }
}

// Three elements cannot follow a bound with a dent, and say so.
TEST(Evidence, ShowsViolationsBetweenNodes) {
  SteadyProblem problem = steady(3, Calibrated{}, PrescribedForce{-0.6});
  problem.bound = PolynomialBound(1, 1, Eigen::Vector3d(1, 0, -0.999));
  const Evidence coarse = solve_steady(problem).evidence;
  problem.grid = problem.grid.with_elements(400);
  const Evidence fine = solve_steady(problem).evidence;
  EXPECT_GE(std::max(coarse.bound_violation, coarse.slip_violation),
            std::max(fine.bound_violation, fine.slip_violation));
}

TEST(Evidence, OfATransientIsTheWorstOfItsParts) {
  const Evidence worst = worst_of({1, 5, 3}, {2, 4, 6});
  EXPECT_EQ(worst.residual, 2);
  EXPECT_EQ(worst.bound_violation, 5);
  EXPECT_EQ(worst.slip_violation, 6);
}

TEST(Evidence, WorseThanAcceptedIsRefusedByName) {
  EXPECT_EQ(refusal({}, 1), "");
  EXPECT_NE(refusal({.residual = 2e-10}, 1)
                .find("residual is 2e-10: expected at most "
                      "solver.tolerance = 1e-10"),
            std::string::npos);
  EXPECT_NE(refusal({.bound_violation = 0.1}, 1).find("bound_violation is 0.1"), std::string::npos);
  EXPECT_NE(refusal({.slip_violation = 0.1}, 1).find("slip_violation is 0.1"), std::string::npos);
  EXPECT_NE(refusal({}, 1e14).find("condition is 1e+14: expected at most solver.condition = 1e+13"),
            std::string::npos);
  EXPECT_NE(refusal({}, std::numeric_limits<double>::infinity()).find("condition"),
            std::string::npos);
}

}  // namespace
}  // namespace microslip
