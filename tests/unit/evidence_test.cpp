// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/evidence.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <limits>
#include <string>

#include "microslip/halfspace/influence.hpp"
#include "microslip/linalg/inverse_norm.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/linalg/toeplitz_inverse.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip::evidence_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const Kernel plane = PlaneKernel({1, 0.28}, 10);

double norm(const MatrixXd& matrix) { return matrix.cwiseAbs().colwise().sum().maxCoeff(); }

SteadyProblem steady(Index n, const SteadyMethod& method, const Load& load) {
  return {.contact = {plane, HertzBound(1, 1)},
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
    const LuFactors factors(matrix), transposed(matrix.transpose());
    const auto estimate = inverse_norm(
        n, [&](VectorXd& x) { factors.solve(x, x); }, [&](VectorXd& x) { transposed.solve(x, x); });
    const double exact = norm(factors.inverse());
    EXPECT_LE(estimate, 1.0001 * exact) << n;
    EXPECT_GE(estimate, exact / 3) << n;
  }
}

TEST(Condition, OfAToeplitzMatrixIsThatOfAllItsEntries) {
  for (const double c : {1.0, 0.1, 0.01}) {
    for (const Index n : {70, 401}) {
      const Toeplitz toeplitz =
          influence_difference_toeplitz(plane, constant_basis().shapes().front(), 0.1, n, c);
      const MatrixXd all = toeplitz.dense();
      EXPECT_NEAR(toeplitz.norm(), norm(all), 1e-13 * norm(all));
      const double exact = norm(all) * norm(LuFactors(all).inverse());
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
  SteadyProblem problem = steady(400, Differences{1}, PrescribedForce{-1});
  problem.solver.type = Solver::Type::dense;
  const double dense = solve_steady(problem).condition;
  problem.solver.type = Solver::Type::fft;
  const double fft = solve_steady(problem).condition;
  EXPECT_GT(fft, dense / 100);
  EXPECT_LT(fft, dense * 10);
  EXPECT_GT(dense, 50);
  EXPECT_EQ(solve_steady(steady(400, Inversion{}, PrescribedCreepage{9})).condition, 1);
  EXPECT_EQ(solve_steady(steady(400, Differences{1}, PrescribedCreepage{9})).condition, 1);
}

// As anyone may count it from what is written.
TEST(Evidence, IsWhatTheTractionsAndTheSlipSay) {
  for (const SteadyMethod& method : {SteadyMethod(Differences{1}), SteadyMethod(Differences{0.3}),
                                     whole_contact(steady(101, {}, {})).method}) {
    const SteadySolution found = solve_steady(steady(101, method, PrescribedForce{-0.9}));
    const Evidence& evidence = found.evidence;
    const double dx = 2.0 / 101;
    EXPECT_NEAR(evidence.dissipated, -dx * found.traction.dot(found.slip), 1e-14);
    EXPECT_NEAR(evidence.load, 0.9, 1e-14);
    EXPECT_NEAR(evidence.power, 0.9 * found.creepage, 1e-14);
    EXPECT_NEAR(evidence.full_sliding, full_sliding_force(HertzBound(1, 1)), 1e-14);
    EXPECT_LE(evidence.violation(), 1e-12);
    EXPECT_GT(evidence.residual, 0);
    EXPECT_LE(evidence.residual, 1e-13);
  }
}

// By hand: three elements of length 2, of which one is above the bound, one slips with the traction
// and less than the bound's mean, and one against it.
TEST(Evidence, CountsSharesOfTheLoad) {
  const Eigen::Vector3d lengths(2, 2, 2), bound(1, 1, 1), means(1, 0.75, 1), traction(-1.5, -1, -1),
      slip(0, -0.25, 0.5);
  const VectorXd l = lengths, b = bound, m = means, p = traction, s = slip;
  const Evidence evidence = evidence_by_elements({l, b, m, p, s}, -7, 0.5);
  EXPECT_DOUBLE_EQ(evidence.bound_violation(), 2 * 0.5 / 7);
  EXPECT_DOUBLE_EQ(evidence.slip_violation(), 2 * 0.25 / 3.5);
  EXPECT_DOUBLE_EQ(evidence.bound_resolution(), 2 * 0.25 / 7);
  EXPECT_DOUBLE_EQ(evidence.dissipated, 2 * 0.5 - 2 * 0.25);
  EXPECT_DOUBLE_EQ(evidence.dissipation_error(), (3.5 - 0.5) / 3.5);
  EXPECT_DOUBLE_EQ(evidence.full_sliding, 2 * 2.75);
  EXPECT_EQ(evidence_by_elements({l, b, m, VectorXd::Zero(3), VectorXd::Zero(3)}, 0, 0).violation(),
            0);
}

// Nodes that miss a peak or a dent of the bound.
TEST(Evidence, ShowsBoundsThatElementsDoNotResolve) {
  SteadyProblem problem = steady(20, Differences{1}, PrescribedForce{-0.5});
  const VectorXd x = (VectorXd(6) << -1, -0.82, -0.8, -0.78, 0, 1).finished();
  problem.contact.bound =
      TabulatedBound(1, x, (VectorXd(6) << 0.3, 0.3, 1.5, 0.3, 1, 0).finished());
  const double coarse = solve_steady(problem).evidence.bound_resolution();
  EXPECT_GT(coarse, 0.01);
  problem.grid = problem.grid.with_elements(2000);
  EXPECT_LT(solve_steady(problem).evidence.bound_resolution(), coarse / 5);
  problem.method = Inversion{};
  problem.grid = problem.grid.with_elements(20);
  EXPECT_LE(solve_steady(problem).evidence.bound_resolution(), 1e-15);
}

// Evidence is relative to small loads, too: tractions exceed the bound by amounts that are nothing
// next to its peak.
TEST(Evidence, IsRelativeToTheLoad) {
  const PolynomialBound bound(1, 1, Eigen::Vector2d(1, -1));
  const Evidence evidence = evidence_by_samples(
      bound, [&](double x) { return x > 0.5 ? -1e-3 - bound(x) : 0; }, [](double) { return 0; }, 0,
      1, 100, -1e-3, 1e-3);
  EXPECT_NEAR(evidence.bound_violation(), 0.5, 1e-12);
}

TEST(Evidence, OfATransientIsTheWorstOfItsSteps) {
  const Evidence worst = worst_of({.residual = 1, .excess = 5, .dissipated = 1, .load = 2},
                                  {.residual = 2, .excess = 4, .dissipated = -1, .load = 1});
  EXPECT_EQ(worst.residual, 2);
  EXPECT_EQ(worst.bound_violation(), 2.5);
  EXPECT_EQ(worst.dissipated, -1);
}

TEST(Evidence, WorseThanAcceptedIsRefusedByName) {
  const Evidence good{.load = 1, .power = 1, .full_sliding = 1};
  const auto with = [&](double Evidence::*value, double is) {
    Evidence changed = good;
    changed.*value = is;
    return refusal(changed, 1);
  };
  EXPECT_EQ(refusal(good, 1), "");
  EXPECT_NE(with(&Evidence::residual, 2e-10)
                .find("residual is 2e-10: expected at most the tolerance, 1e-10"),
            std::string::npos);
  EXPECT_NE(with(&Evidence::excess, 0.1).find("bound_violation is 0.1"), std::string::npos);
  EXPECT_NE(with(&Evidence::backward, 0.1).find("slip_violation is 0.1"), std::string::npos);
  EXPECT_NE(with(&Evidence::load, 1.1).find("above full sliding"), std::string::npos);
  EXPECT_NE(with(&Evidence::dissipated, -0.1).find("dissipation is negative"), std::string::npos);
  EXPECT_NE(refusal(good, 1e14)
                .find("condition is 1e+14: expected at most the accepted condition, 1e+13"),
            std::string::npos);
  EXPECT_NE(refusal(good, std::numeric_limits<double>::infinity()).find("condition"),
            std::string::npos);
}

TEST(Evidence, OfWhichSomeIsDoubtful) {
  const Evidence good{.dissipated = 1, .load = 1, .power = 1, .full_sliding = 1};
  const auto doubt = [&](double Evidence::*value, double is, bool steady = true) {
    Evidence changed = good;
    changed.*value = is;
    return doubt_of(changed, {}, steady).value_or("none");
  };
  EXPECT_EQ(doubt(&Evidence::residual, 0), "none");
  EXPECT_NE(doubt(&Evidence::excess, 0.02).find("0.02"), std::string::npos);
  EXPECT_NE(doubt(&Evidence::unresolved, 0.1).find("bound_resolution is 0.1"), std::string::npos);
  EXPECT_NE(doubt(&Evidence::dissipated, 1.5).find("dissipation_error is 0.5"), std::string::npos);
  EXPECT_EQ(doubt(&Evidence::dissipated, 1.5, false), "none");
  EXPECT_EQ(doubt(&Evidence::dissipated, 0.1), "none");  // a slip zone shorter than an element
}

}  // namespace microslip::evidence_test
