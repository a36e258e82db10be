// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/lu_factors.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "microslip/linalg/matrix_product.hpp"

namespace microslip::lu_factors_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_matrix(Index rows, Index columns, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  MatrixXd matrix(rows, columns);
  for (Index j = 0; j < columns; ++j) {
    for (Index i = 0; i < rows; ++i) matrix(i, j) = normal(random);
  }
  return matrix;
}

double largest(const MatrixXd& values) { return values.cwiseAbs().maxCoeff(); }

TEST(LuFactors, SolveForOneRightHandSideAndForSeveral) {
  for (const Index n : {1, 2, 7, 40, 200}) {
    const MatrixXd matrix = random_matrix(n, n, 1), right = random_matrix(n, 3, 2);
    const LuFactors factors(matrix);
    const MatrixXd solved = factors.solve_columns(right);
    EXPECT_LT(largest(matrix_product(matrix, solved) - right), 1e-10) << n;
    EXPECT_LT(largest(matrix_product(matrix, factors.inverse()) - MatrixXd::Identity(n, n)), 1e-10)
        << n;
    VectorXd in_place = right.col(0);
    factors.solve(in_place, in_place);
    EXPECT_LT(largest(matrix * in_place - right.col(0)), 1e-10) << n;
    EXPECT_LT(largest(factors.solve(right.col(1)) - solved.col(1)), 1e-12) << n;
  }
}

TEST(LuFactors, TellHowNearlySingularTheMatrixIs) {
  MatrixXd matrix = MatrixXd::Identity(4, 4);
  matrix(2, 2) = 1e-6;
  const LuFactors factors(matrix);
  EXPECT_NEAR(factors.rcond(), 1e-6, 1e-12);
  EXPECT_NEAR(factors.pivot_ratio(), 1e-6, 1e-12);
}

TEST(LuFactors, RefuseWhatIsNotSquare) {
  EXPECT_THROW(LuFactors(MatrixXd::Ones(3, 2)), std::invalid_argument);
}

TEST(LeastSquares, LeavesNothingAlongTheColumns) {
  const MatrixXd matrix = random_matrix(9, 4, 3);
  const VectorXd right = random_matrix(9, 1, 4).col(0);
  EXPECT_LT(largest(matrix.transpose() * (matrix * least_squares(matrix, right) - right)), 1e-12);
}

TEST(LeastSquares, LeaveNothingWhereTheyHaveMoreColumnsThanRows) {
  const MatrixXd matrix = random_matrix(2, 5, 6);
  const VectorXd right = random_matrix(2, 1, 7).col(0);
  EXPECT_LT(largest(matrix * least_squares(matrix, right) - right), 1e-12);
}

TEST(LeastSquares, AreZeroForNoMatrixAndNotFiniteForOneThatIsNot) {
  const VectorXd right = VectorXd::Constant(3, 1);
  MatrixXd matrix = MatrixXd::Zero(3, 2);
  EXPECT_EQ(least_squares(matrix, right), VectorXd::Zero(2));
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    matrix.setConstant(value);
    EXPECT_FALSE(least_squares(matrix, right).allFinite());
    matrix.setOnes();
    matrix(1, 1) = value;
    EXPECT_FALSE(least_squares(matrix, right).allFinite());
  }
}

TEST(LeastSquares, AreFiniteForASingularMatrix) {
  MatrixXd matrix(2, 2);
  matrix << 1, 2, 2, 4;
  const VectorXd right = VectorXd::Constant(2, 1);
  EXPECT_TRUE(least_squares(matrix, right).allFinite());
}

}  // namespace microslip::lu_factors_test
