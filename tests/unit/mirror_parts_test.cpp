// SPDX-License-Identifier: GPL-3.0-or-later
// Matrices of a patch that is its own mirror image: their inverses by halves are those at once.
#include "../../core/src/patch/mirror_parts.hpp"

#include <gtest/gtest.h>

#include <random>

#include "microslip/linalg/lu_factors.hpp"
#include "microslip/linalg/matrix_product.hpp"

namespace microslip::mirror_parts_test {

using Eigen::Index;
using Eigen::MatrixXd;

/// The mirror image of tractions: rows are exchanged, and lateral components change their sign.
MatrixXd mirror_of(const JoinedRows& rows) {
  const Index n = rows.cells();
  MatrixXd mirror = MatrixXd::Zero(2 * n, 2 * n);
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      const Index to = rows.cell(i, rows.rows() - 1 - k), from = rows.cell(i, k);
      mirror(to, from) = 1;
      mirror(n + to, n + from) = -1;
    }
  }
  return mirror;
}

TEST(MirrorParts, HaveTheInverseOfTheWholeMatrix) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const Index M : {1, 2, 3, 4, 7}) {
    for (const Index N : {2, 3, 5}) {
      const JoinedRows rows(1.5, M, N);
      const Index size = 2 * rows.cells();
      const MatrixXd mirror = mirror_of(rows);
      MatrixXd matrix = MatrixXd::NullaryExpr(size, size, [&] { return uniform(random); });
      const MirrorParts parts(rows);
      EXPECT_EQ(parts.apply_to(matrix), false);
      matrix += matrix_product(matrix_product(mirror, matrix), mirror);
      matrix += 4 * MatrixXd::Identity(size, size);
      ASSERT_TRUE(parts.apply_to(matrix));
      std::array<MatrixXd, 2> inverses;
      Index unknowns = 0;
      for (std::size_t part = 0; part < 2; ++part) {
        const MatrixXd one = parts.part_of(matrix, part);
        unknowns += one.rows();
        inverses[part] = LuFactors(one).inverse();
      }
      EXPECT_EQ(unknowns, size);
      const MatrixXd expected = LuFactors(matrix).inverse();
      const double error = (parts.joined(inverses) - expected).cwiseAbs().maxCoeff();
      EXPECT_LT(error, 1e-11 * expected.cwiseAbs().maxCoeff()) << M << " x " << N;
    }
  }
}

}  // namespace microslip::mirror_parts_test
