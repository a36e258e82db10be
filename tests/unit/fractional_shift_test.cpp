// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/fractional_shift.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>

#include "microslip/halfspace/basis.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/linalg/spectra.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/thesis/schur_powers.hpp"

namespace microslip::fractional_shift_test {

constexpr Material material{1, 0.28};

FractionalShift shift_of(Eigen::Index n, const Basis& basis = constant_basis()) {
  const double dx = 2.0 / static_cast<double>(n);
  return {PlaneKernel(material, 200), basis.shapes()[0], dx, n};
}

Eigen::VectorXd pyramid(Eigen::Index n) {
  return Eigen::VectorXd::NullaryExpr(n, [n](Eigen::Index i) {
    return std::max(0.0, 1 - std::abs(6.0 * static_cast<double>(i) / static_cast<double>(n) - 3));
  });
}

TEST(FractionalShift, MatrixIsTheInverseOfATimesAOneElementUpstream) {
  for (const Basis& basis : {constant_basis(), linear_basis()}) {
    constexpr Eigen::Index n = 41;
    constexpr double dx = 2.0 / n;
    const PlaneKernel kernel(material, 200);
    const Eigen::MatrixXd a = influence_matrix(kernel, basis, dx, n);
    const Eigen::MatrixXd upstream = a - influence_difference_matrix(kernel, basis, dx, n, 1);
    const Eigen::MatrixXd difference =
        shift_matrix(shift_of(n, basis)) - LuFactors(a).solve_columns(upstream);
    EXPECT_LT(difference.lpNorm<Eigen::Infinity>(), 1e-11);
  }
}

TEST(FractionalShift, AgreesWithASchurMethod) {
  for (const Eigen::Index n : {1, 3, 51, 101}) {
    const FractionalShift shift = shift_of(n);
    const Eigen::VectorXd start = pyramid(n) + Eigen::VectorXd::Unit(n, 0);
    const Eigen::MatrixXd matrix = shift_matrix(shift);
    SchurPowers powers(matrix);
    for (const double c : {1e-6, 0.05, 0.5, 0.8, 0.999999, 2.3}) {
      const Eigen::MatrixXd power = powers.power(c);
      EXPECT_LT((shift.move(start, c).traction - power * start).lpNorm<Eigen::Infinity>(), 1e-11)
          << n << ' ' << c;
    }
  }
}

TEST(FractionalShift, PowersAdd) {
  for (const Eigen::Index n : {31, 601}) {
    const FractionalShift shift = shift_of(n);
    const Eigen::VectorXd start = pyramid(n) + Eigen::VectorXd::Unit(n, n - 1);
    Eigen::VectorXd by_fractions = start;
    for (int k = 0; k < 5; ++k) by_fractions = shift.move(by_fractions, 0.8).traction;
    const Eigen::VectorXd whole = shift.move(start, 4).traction;
    EXPECT_LT((by_fractions - whole).lpNorm<Eigen::Infinity>(), 1e-10);
    EXPECT_EQ(shift.move(start, 4).solves, 0);
  }
}

/// Returns ln M = r ln M^(1/r) by the series 2 (X + X^3/3 + ...) of M^(1/r) = (I + X)/(I - X).
Eigen::MatrixXd logarithm(const Eigen::MatrixXd& matrix) {
  constexpr double roots = 4096;
  const Eigen::MatrixXd root = SchurPowers(matrix).power(1 / roots);
  const auto identity = Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols());
  const Eigen::MatrixXd x = LuFactors(root + identity).solve_columns(root - identity);
  const Eigen::MatrixXd square = x * x;
  return 2 * roots * (x + x * square / 3 + x * square * square / 5);
}

// C^c = I + c ln C + ...: the rate of change keeps its digits for any small c.
TEST(FractionalShift, SmallPowersKeepTheirDigits) {
  const FractionalShift shift = shift_of(51);
  const Eigen::VectorXd start = pyramid(51);
  const Eigen::VectorXd rate = logarithm(shift_matrix(shift)) * start;
  for (const double c : {1e-6, 1e-9}) {
    const Eigen::VectorXd change = (shift.move(start, c).traction - start) / c;
    EXPECT_LT((change - rate).lpNorm<Eigen::Infinity>(), 1e-15 / c + 10 * c) << c;
  }
}

TEST(FractionalShift, SolvesGrowWithTheLogarithmOfTheSize) {
  for (const Eigen::Index n : {51, 401, 1601}) {
    const int solves = shift_of(n).move(pyramid(n), 0.8).solves;
    EXPECT_LT(solves, 150 * std::log(static_cast<double>(n)));
    EXPECT_GT(solves, 100);
  }
}

// As a predictor of positive definite coefficients, and no eigenvalue on the branch cut.
TEST(FractionalShift, EigenvaluesLieInsideTheUnitCircleAndOffTheNegativeAxis) {
  for (const Eigen::Index n : {3, 31, 101}) {
    const Eigen::VectorXcd values = eigenvalues(shift_matrix(shift_of(n)));
    EXPECT_LT(values.cwiseAbs().maxCoeff(), 1);
    for (const auto& value : values) {
      EXPECT_FALSE(value.real() < 0 && std::abs(value.imag()) < 1e-3) << value;
    }
  }
}

TEST(FractionalShift, RejectsAnEvenNumberOfElements) {
  EXPECT_THROW(shift_of(50), std::invalid_argument);
}

// An eigenvalue below zero is refused at once; its power is complex, and no quadrature finds it.
TEST(FractionalShift, RejectsShortLengthsOfPlaneStrain) {
  const auto shift = [](double length, Eigen::Index n, const Basis& basis) {
    return FractionalShift(PlaneKernel(material, length), basis.shapes()[0],
                           2.0 / static_cast<double>(n), n);
  };
  for (const Basis& basis : {constant_basis(), linear_basis()}) {
    for (const Eigen::Index n : {3, 11, 101, 401}) {
      for (const double length : {1.2, 2.0, 3.1}) {
        EXPECT_THROW(shift(length, n, basis), std::invalid_argument) << n << ' ' << length;
      }
      for (const double c : {1e-5, 0.3, 0.9}) {
        EXPECT_TRUE(shift(3.8, n, basis).move(pyramid(n), c).traction.allFinite());
      }
    }
    EXPECT_THROW(shift(3.7, 51, basis), std::invalid_argument);  // a pair of them
  }
}

TEST(FractionalShift, ThrowsWhereTheInfluenceIsNotPositiveDefinite) {
  EXPECT_THROW(FractionalShift(PlaneKernel(material, 0.2), constant_basis().shapes()[0], 0.1, 21),
               NotConverged);
}

}  // namespace microslip::fractional_shift_test
