// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/spectra.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "microslip/support/not_converged.hpp"

namespace microslip::spectra_test {

using Eigen::Index;
using Eigen::MatrixXd;

/// Returns the second difference of n values, whose eigenvalues are 2 - 2 cos(k pi/(n + 1)).
MatrixXd second_difference(Index n) {
  MatrixXd matrix = 2 * MatrixXd::Identity(n, n);
  matrix.diagonal(1).setConstant(-1);
  matrix.diagonal(-1).setConstant(-1);
  return matrix;
}

double known(Index k, Index n) {
  return 2 - 2 * std::cos(static_cast<double>(k) * std::numbers::pi / static_cast<double>(n + 1));
}

TEST(Spectra, AreThoseOfTheSecondDifference) {
  for (const Index n : {1, 2, 7, 40}) {
    const MatrixXd matrix = second_difference(n);
    EXPECT_NEAR(least_eigenvalue(matrix), known(1, n), 1e-14);
    EXPECT_NEAR(condition(matrix) / (known(n, n) / known(1, n)), 1, 1e-12);
    const Eigen::VectorXcd values = eigenvalues(matrix);
    for (Index k = 0; k < n; ++k) {
      EXPECT_NEAR(std::abs(values[k] - known(k + 1, n)), 0, 1e-13) << n << ' ' << k;
    }
  }
}

TEST(Spectra, ACyclicShiftHasTheRootsOfOne) {
  constexpr Index n = 9;
  MatrixXd shift = MatrixXd::Zero(n, n);
  for (Index i = 0; i < n; ++i) shift(i, (i + 1) % n) = 1;
  for (const auto& value : eigenvalues(shift)) {
    EXPECT_NEAR(std::abs(std::pow(value, n) - 1.0), 0, 1e-12);
  }
  EXPECT_NEAR(condition(shift), 1, 1e-13);
}

TEST(Spectra, ASingularMatrixHasAConditionAboveRounding) {
  MatrixXd matrix = second_difference(5);
  matrix.row(3) = matrix.row(1);
  EXPECT_GT(condition(matrix), 1e14);
  EXPECT_THROW(condition(MatrixXd::Ones(2, 3)), NotConverged);
  EXPECT_LT(least_eigenvalue(-second_difference(5)), -3.7);
}

}  // namespace microslip::spectra_test
