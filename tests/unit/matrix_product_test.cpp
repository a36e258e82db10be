// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/matrix_product.hpp"

#include <gtest/gtest.h>

namespace microslip::matrix_product_test {

using Eigen::Index;
using Eigen::MatrixXd;
using RowsInOrder = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Whole numbers, whose products have no rounding.
template <class Matrix>
Matrix whole_numbers(Index rows, Index columns) {
  Matrix matrix(rows, columns);
  for (Index i = 0; i < rows; ++i) {
    for (Index j = 0; j < columns; ++j)
      matrix(i, j) = static_cast<double>((7 * i + 3 * j) % 11 - 5);
  }
  return matrix;
}

void expect_product(const MatrixXd& product, const MatrixXd& left, const MatrixXd& right) {
  ASSERT_EQ(product.rows(), left.rows());
  ASSERT_EQ(product.cols(), right.cols());
  for (Index i = 0; i < left.rows(); ++i) {
    for (Index j = 0; j < right.cols(); ++j) {
      double sum = 0;
      for (Index k = 0; k < left.cols(); ++k) sum += left(i, k) * right(k, j);
      EXPECT_EQ(product(i, j), sum) << i << ' ' << j;
    }
  }
}

TEST(MatrixProduct, IsTheSumOverRowsAndColumns) {
  for (const Index inner : {1, 2, 9, 40}) {
    const auto left = whole_numbers<MatrixXd>(31, inner), right = whole_numbers<MatrixXd>(inner, 5);
    expect_product(matrix_product(left, right), left, right);
  }
}

TEST(MatrixProduct, TakesBlocksTransposesAndOtherOrders) {
  const auto whole = whole_numbers<MatrixXd>(20, 20);
  const auto in_order = whole_numbers<RowsInOrder>(9, 6);
  expect_product(matrix_product(whole.middleCols(3, 6), in_order.transpose()),
                 whole.middleCols(3, 6), in_order.transpose());
  expect_product(matrix_product(in_order, whole.topLeftCorner(6, 2)), in_order,
                 whole.topLeftCorner(6, 2));
}

TEST(MatrixProduct, MayBeEmpty) {
  const auto left = whole_numbers<MatrixXd>(4, 3);
  const MatrixXd none = matrix_product(left, MatrixXd(3, 0));
  EXPECT_EQ(none.rows(), 4);
  EXPECT_EQ(none.cols(), 0);
  EXPECT_EQ(matrix_product(MatrixXd(4, 0), MatrixXd(0, 2)), MatrixXd::Zero(4, 2));
}

}  // namespace microslip::matrix_product_test
