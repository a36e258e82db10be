// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "microslip/halfspace/influence.hpp"
#include "microslip/halfspace/leading_edge.hpp"
#include "microslip/linalg/lu_factors.hpp"

namespace microslip::leading_edge_constants_test {

// The integrals by tanh-sinh quadrature in 60 digits, with Hurwitz' zeta functions in b.
TEST(LeadingEdgeConstants, AgreeWithKnownFigures) {
  EXPECT_NEAR(leading_edge_constants(constant_basis()).offset, 0.825346771483, 1e-12);
  EXPECT_NEAR(leading_edge_constants(linear_basis()).offset, 0.884947881413, 1e-12);
  EXPECT_NEAR(leading_edge_constants(constant_basis()).compliance, 0.862164110790, 1e-12);
  EXPECT_NEAR(leading_edge_constants(linear_basis()).compliance, 0.752064947520, 1e-12);
}

// Aliases summed one by one, the rest as an integral, and the midpoint rule.
TEST(LeadingEdgeConstants, AreThoseOfTheSymbol) {
  using std::numbers::pi;
  for (const int degree : {0, 1}) {
    const auto b = [&](double theta) {
      constexpr int terms = 500;
      double sum = 0;
      for (int m = -terms; m <= terms; ++m) {
        const double xi = theta + 2 * pi * m;
        const double end = m == -terms || m == terms ? 0.5 : 1;
        sum += end * std::pow(std::sin(xi / 2) / (xi / 2), degree + 1) / std::abs(xi);
      }
      return 2 * std::sin(theta / 2) * sum;
    };
    constexpr int intervals = 1000;
    double offset = 0.75, mean = 0;
    for (int i = 0; i < intervals; ++i) {
      const double theta = (i + 0.5) * pi / intervals;
      mean += std::log(b(theta)) / intervals;
      offset -= std::log(b(theta)) / std::pow(std::sin(theta / 2), 2) / (4 * intervals);
    }
    const auto constants = leading_edge_constants(degree == 0 ? constant_basis() : linear_basis());
    EXPECT_NEAR(constants.offset, offset, 1e-6) << degree;
    EXPECT_NEAR(constants.compliance, std::exp(mean), 1e-6) << degree;
  }
}

// Long rows of elements that stick to the edge, c = 1: at the next node the slip of a step is minus
// e0 times what that node gets when it is in contact, one step later.
TEST(LeadingEdgeConstants, TheNextNodeSlipsByTheCompliance) {
  const PlaneKernel kernel({1, 0}, 1);
  const Eigen::Index n = 400;
  const Eigen::MatrixXd strain = influence_difference_matrix(kernel, constant_basis(), 1, n + 1, 1);
  const Eigen::MatrixXd equations = strain.topLeftCorner(n, n);
  const Eigen::VectorXd traction = LuFactors(equations).solve(Eigen::VectorXd::Constant(n, -1));
  const double slip = 1 + strain.row(n).head(n) * traction;
  const double e0 = leading_edge_constants(constant_basis()).compliance;
  EXPECT_NEAR(slip / (-traction[n - 1] * compliance(kernel.material())), e0, 5e-3 * e0);
}

// In the same long row, the scheme does not give the square root itself next to the edge.
TEST(LeadingEdgeConstants, LayersAreThoseOfALongRow) {
  for (const Basis& basis : {constant_basis(), linear_basis()}) {
    const auto edge = leading_edge_constants(basis);
    const PlaneKernel kernel({1, 0}, 1);
    const Eigen::Index n = 800;
    const Eigen::MatrixXd strain = influence_difference_matrix(kernel, basis, 1, n, 1);
    const Eigen::VectorXd traction = LuFactors(strain).solve(Eigen::VectorXd::Constant(n, -1));
    // Exact: sqrt((1 - x)/(1 + x)), of a contact from the trailing edge on.
    const auto over_exact = [&](Eigen::Index j) {
      const double d = static_cast<double>(j) + edge.offset;
      const double length = static_cast<double>(n) - 0.5 + edge.offset;
      return -traction[n - 1 - j] / std::sqrt(d / (length - d));
    };
    for (Eigen::Index j = 0; j < 7; ++j) {
      EXPECT_NEAR(over_exact(j) / over_exact(40), edge.value(j, 0), 2e-3) << j;
      EXPECT_NEAR(edge.value(j - 1, 1 - 1e-12), edge.value(j, 0), j == 0 ? 1e-5 : 1e-11) << j;
    }
    EXPECT_GT(edge.value(0, 0), 1.02);
    EXPECT_EQ(edge.value(7, 0.3), 1);
  }
}

/// The part of a contact's length in elements beyond N - 1, where everything sticks and the strain
/// is 1: the force of sqrt((a - x)/(a + x)) is pi a.
double length_felt(const Basis& basis, Eigen::Index n) {
  const PlaneKernel kernel({2, 0}, 1);  // 2 (1 - nu)/G = 1
  const Eigen::MatrixXd strain = influence_difference_matrix(kernel, basis, 1, n, 1);
  const Eigen::VectorXd traction = LuFactors(strain).solve(Eigen::VectorXd::Constant(n, -1));
  return -2 * traction.sum() / std::numbers::pi - static_cast<double>(n - 1);
}

// The leading edge is felt by the offset beyond the last node, the trailing edge by half an element
// less beyond the first.
TEST(LeadingEdgeConstants, TheTrailingEdgeIsFeltHalfAnElementNearer) {
  for (const Basis& basis : {constant_basis(), linear_basis()}) {
    const double limit = 2 * leading_edge_constants(basis).offset - 0.5;
    const double coarse = length_felt(basis, 100) - limit, fine = length_felt(basis, 400) - limit;
    EXPECT_LT(std::abs(fine), 5e-5) << basis.name();
    EXPECT_GT(coarse / fine, 10) << basis.name();
  }
}

// Point loads, whose strain in the middle between nodes is that of 1/(x - x'), have b = 1: the
// tractions are the coefficients of (1 - z)^(-3/2) themselves.
TEST(LeadingEdgeConstants, PointLoadsFeelTheEdgeAtThreeQuarters) {
  const auto felt = [](Eigen::Index n) {
    // Strain x on n + 1 midpoints and an unknown constant, as for Carter's contact.
    Eigen::MatrixXd equations(n + 1, n + 1);
    for (Eigen::Index i = 0; i <= n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        equations(i, j) = 1 / (std::numbers::pi * (static_cast<double>(i - j) - 0.5));
      }
    }
    equations.rightCols(1).setOnes();
    const double half = static_cast<double>(n) / 2;
    const Eigen::VectorXd loads =
        LuFactors(equations).solve(Eigen::VectorXd::LinSpaced(n + 1, -half, half));
    return std::sqrt(2 * std::abs(loads.head(n).sum()) / std::numbers::pi) - (half - 0.5);
  };
  const double coarse = felt(100) - 0.75, fine = felt(400) - 0.75;
  EXPECT_LT(std::abs(fine), 1e-3);
  EXPECT_NEAR(coarse / fine, 4, 0.3);
}

// The midpoint rule for sqrt(d) with its first node alpha elements from the edge errs by
// zeta(-1/2, alpha) dx^(3/2), which vanishes at 0.656936.
TEST(TrailingEdge, MidpointRuleOfASquareRootHasTheErrorOfHurwitzZeta) {
  const auto error = [](double alpha) {
    constexpr int n = 1'000'000;
    double sum = 0;
    for (int j = n - 1; j >= 0; --j) sum += std::sqrt(j + alpha);
    return sum - 2.0 / 3 * std::pow(n - 0.5 + alpha, 1.5);
  };
  EXPECT_NEAR(error(0.656936), 0, 2e-4);
  EXPECT_NEAR(error(0.5), (1 / std::numbers::sqrt2 - 1) * -0.2078862250, 2e-4);
}

TEST(LeadingEdgeConstants, WantConstantOrLinearFunctions) {
  EXPECT_THROW(leading_edge_constants(quadratic_basis()), std::invalid_argument);
}

}  // namespace microslip::leading_edge_constants_test
