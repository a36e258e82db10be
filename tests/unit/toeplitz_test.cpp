// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/toeplitz.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numeric>
#include <ostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "microslip/halfspace/influence.hpp"
#include "microslip/linalg/circulant_inverse.hpp"
#include "microslip/linalg/gmres.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/linalg/toeplitz_inverse.hpp"
#include "microslip/linalg/toeplitz_product.hpp"
#include "microslip/linalg/toeplitz_submatrix.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/work.hpp"

namespace microslip::toeplitz_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const Kernel plane = PlaneKernel({1, 0.28}, 4);
const Kernel strip = StripKernel({1, 0.28}, 0.3);

/// A, on elements that fill [-1, 1], or A - A' over a step.
Toeplitz influence_over(const Kernel& kernel, const Basis& basis, Index n, double step_ratio) {
  const double dx = 2 / static_cast<double>(n);
  const ShapeFunction& shape = basis.shapes().front();
  return step_ratio == 0 ? influence_toeplitz(kernel, shape, dx, n)
                         : influence_difference_toeplitz(kernel, shape, dx, n, step_ratio);
}

VectorXd some_values(Index n) {
  return VectorXd::NullaryExpr(n, [](Index i) {
    return std::sin(0.7 * static_cast<double>(i)) + 0.3 * static_cast<double>(i % 3);
  });
}

TEST(RealFft, GoesForwardAndBack) {
  for (const Index n : {1, 2, 15, 97, 210, 1024}) {
    RealFft fft(n);
    const VectorXd values = some_values(n);
    fft.values() = values;
    fft.forward();
    EXPECT_NEAR(fft.spectrum()[0].real(), values.sum(), 1e-13 * static_cast<double>(n));
    fft.backward();
    EXPECT_LT((fft.values() / static_cast<double>(n) - values).lpNorm<Eigen::Infinity>(), 1e-14)
        << n;
  }
}

TEST(RealFft, FastSizesAreFewAndClose) {
  EXPECT_EQ(RealFft::good_size(1), 32);
  EXPECT_EQ(RealFft::good_size(65), 72);
  EXPECT_EQ(RealFft::good_size(1 << 20), 1 << 20);
  for (Eigen::Index n = 33; n < 5000; ++n) {
    const Eigen::Index size = RealFft::good_size(n);
    ASSERT_GE(size, n);
    ASSERT_LE(7 * size, 8 * n);
    ASSERT_EQ(size % 2, 0);
  }
}

// Plans are made in one thread at a time; the same size gives the same digits in all.
TEST(RealFft, ServesThreadsSideBySide) {
  std::vector<VectorXd> results(4);
  std::vector<std::thread> threads;
  for (VectorXd& result : results) {
    threads.emplace_back([&result] {
      for (const Index n : {60, 126, 250, 486}) {
        RealFft fft(n);
        fft.values() = some_values(n);
        fft.forward();
        fft.backward();
        result = fft.values();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const VectorXd& result : results) EXPECT_EQ(result, results.front());
}

TEST(Toeplitz, MayBeCutShiftedAndScaled) {
  const Toeplitz matrix(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(1, 5, 6));
  EXPECT_FALSE(matrix.is_symmetric());
  EXPECT_EQ(matrix.leading(2).dense(), matrix.dense().topLeftCorner(2, 2));
  EXPECT_EQ(matrix.plus(0.5).dense(), (matrix.dense().array() + 0.5).matrix());
  EXPECT_EQ(matrix.times(2).dense(), 2 * matrix.dense());
}

// Structured solvers rely on this symmetry, exactly.
TEST(Toeplitz, InfluenceOfEvenFunctionsIsSymmetric) {
  for (const Basis& basis : {constant_basis(), linear_basis()}) {
    EXPECT_TRUE(influence_over(strip, basis, 50, 0).is_symmetric());
    const Toeplitz unit = influence_over(strip, basis, 50, 1);
    for (Index k = 1; k < 50; ++k) EXPECT_EQ(unit(0, k), -unit(k - 1, 0));
  }
}

struct Case {
  std::string name;
  Kernel kernel;
  Basis basis;
  double step_ratio;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

class StructuredSolver : public testing::TestWithParam<Case> {};

TEST_P(StructuredSolver, ProductIsThatOfTheDenseMatrix) {
  const auto& [name, kernel, basis, step_ratio] = GetParam();
  for (const Index n : {1, 2, 7, 64, 311}) {
    const Toeplitz matrix = influence_over(kernel, basis, n, step_ratio);
    const VectorXd x = some_values(n);
    VectorXd y;
    ToeplitzProduct(matrix).apply(x, y);
    const VectorXd expected = matrix.dense() * x;
    EXPECT_LE((y - expected).lpNorm<Eigen::Infinity>(), 1e-14 * expected.lpNorm<1>());
  }
}

TEST_P(StructuredSolver, InverseIsThatOfTheDenseMatrix) {
  const auto& [name, kernel, basis, step_ratio] = GetParam();
  for (const Index n : {1, 2, 7, 64, 311}) {
    const Toeplitz matrix = influence_over(kernel, basis, n, step_ratio);
    const VectorXd b = some_values(n);
    const MatrixXd dense = matrix.dense();
    const LuFactors factors(dense);
    const VectorXd expected = factors.solve(b);
    const double condition = 1 / factors.rcond();
    VectorXd x;
    ToeplitzInverse(matrix).apply(b, x);
    EXPECT_LE((x - expected).norm(), 1e-14 * condition * expected.norm()) << n;
  }
}

// The whole point: 22 at most of those tried up to a million, so 25 here is no slack.
TEST_P(StructuredSolver, NeedsFewIterationsWhateverTheSize) {
  const auto& [name, kernel, basis, step_ratio] = GetParam();
  for (const Index n : {100, 1000, 10007}) {
    EXPECT_LE(ToeplitzInverse(influence_over(kernel, basis, n, step_ratio)).iterations(), 25) << n;
  }
}

// Intervals of different lengths, some of them short, with gaps of one element and more.
TEST_P(StructuredSolver, BlockOfSeveralIntervalsIsThatOfTheDenseMatrix) {
  const auto& [name, kernel, basis, step_ratio] = GetParam();
  const Toeplitz matrix = influence_over(kernel, basis, 400, step_ratio);
  ToeplitzSubmatrix block(matrix, 1e-13);
  const auto expect_solution = [&](const std::vector<Index>& indices) {
    block.choose(indices);
    const VectorXd b = some_values(static_cast<Index>(indices.size()));
    const MatrixXd dense = matrix.dense()(indices, indices);
    VectorXd x;
    block.solve(b, x);
    EXPECT_LT((dense * x - b).norm(), 1e-12 * b.norm());
  };
  std::vector<Index> indices;
  for (Index i = 90; i < 300; ++i) indices.push_back(i);
  expect_solution(indices);
  for (Index i = 301; i < 391; ++i) indices.push_back(i);
  for (Index i = 396; i < 399; ++i) indices.push_back(i);
  expect_solution(indices);
  indices.erase(indices.begin(), indices.begin() + 1);
  expect_solution(indices);
}

INSTANTIATE_TEST_SUITE_P(Matrices, StructuredSolver,
                         testing::Values(Case{"A", plane, constant_basis(), 0},
                                         Case{"c = 1", plane, constant_basis(), 1},
                                         Case{"linear, c = 0.37", plane, linear_basis(), 0.37},
                                         Case{"c = 0.05", plane, constant_basis(), 0.05},
                                         Case{"strip, A", strip, constant_basis(), 0},
                                         Case{"strip, linear, c = 1", strip, linear_basis(), 1},
                                         Case{"strip, c = 2.5", strip, constant_basis(), 2.5},
                                         Case{"strip, linear, A", strip, linear_basis(), 0}));

// Factors of 500 elements would take 8e7 operations.
TEST(ToeplitzSubmatrix, LongIntervalsAreInvertedByFft) {
  ToeplitzSubmatrix block(influence_over(plane, constant_basis(), 600, 1), 1e-13);
  std::vector<Index> indices(500);
  std::iota(indices.begin(), indices.end(), 50);
  const WorkCount count;
  block.choose(indices);
  EXPECT_LT(count.operations(), 2e7);
}

// Every 40, 13 or 5 elements one is missing: 100 to 800 intervals.
TEST(ToeplitzSubmatrix, NeedsFewIterationsForManyIntervals) {
  const Toeplitz matrix = influence_over(plane, constant_basis(), 4000, 1);
  ToeplitzSubmatrix block(matrix, 1e-7);
  for (const Index period : {40, 13, 5}) {
    std::vector<Index> indices;
    for (Index i = 0; i < matrix.size(); ++i) {
      if (i % period != 1) indices.push_back(i);
    }
    block.choose(indices);
    VectorXd x;
    EXPECT_LE(block.solve(some_values(static_cast<Index>(indices.size())), x), 28) << period;
  }
}

TEST(ToeplitzInverse, ThrowsWhereTheMatrixIsSingular) {
  EXPECT_THROW(ToeplitzInverse(Toeplitz(VectorXd::Ones(70), VectorXd::Ones(70))), NotConverged);
}

TEST(Gmres, EndsInOneIterationWithTheInverseAndInNWithout) {
  const MatrixXd matrix = influence_over(plane, constant_basis(), 12, 1).dense();
  const LuFactors factors(matrix);
  const VectorXd b = some_values(12);
  const auto product = [&](const VectorXd& x, VectorXd& y) { y = matrix * x; };
  VectorXd x;
  Gmres gmres(50);
  const auto exact = gmres.solve(
      product, [&](const VectorXd& y, VectorXd& z) { factors.solve(y, z); }, b, 1e-12, x);
  EXPECT_EQ(exact.iterations, 1);
  EXPECT_LT((matrix * x - b).norm(), 1e-12 * b.norm());
  const auto plain = gmres.solve(
      product, [](const VectorXd& y, VectorXd& z) { z = y; }, b, 1e-12, x);
  EXPECT_LE(plain.iterations, 12);
  EXPECT_LT((matrix * x - b).norm(), 1e-11 * b.norm());
  EXPECT_NEAR(plain.residual, (matrix * x - b).norm() / b.norm(), 1e-12);
}

TEST(Gmres, LeavesNothingToDoForZero) {
  VectorXd x;
  const auto same = [](const VectorXd& y, VectorXd& z) { z = y; };
  EXPECT_EQ(Gmres(5).solve(same, same, VectorXd::Zero(4), 1e-12, x).iterations, 0);
  EXPECT_EQ(x, VectorXd::Zero(4));
}

}  // namespace microslip::toeplitz_test
