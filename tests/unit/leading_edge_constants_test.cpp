// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "microslip/halfspace/influence.hpp"
#include "microslip/halfspace/leading_edge.hpp"

namespace microslip {
namespace {

// Figures of an independent program, which has six digits less one.
TEST(LeadingEdgeConstants, AgreeWithKnownFigures) {
  EXPECT_NEAR(leading_edge_constants(constant_basis()).offset, 0.825344, 5e-6);
  EXPECT_NEAR(leading_edge_constants(linear_basis()).offset, 0.884944, 5e-6);
  EXPECT_NEAR(leading_edge_constants(constant_basis()).compliance, 0.862164, 1e-6);
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
  const Eigen::VectorXd traction = equations.lu().solve(Eigen::VectorXd::Constant(n, -1));
  const double slip = 1 + strain.row(n).head(n) * traction;
  const double e0 = leading_edge_constants(constant_basis()).compliance;
  EXPECT_NEAR(slip / (-traction[n - 1] * compliance(material_of(Kernel(kernel)))), e0, 5e-3 * e0);
}

// Of the same long row: next to the edge the scheme does not give the square root itself.
TEST(LeadingEdgeConstants, LayersAreThoseOfALongRow) {
  for (const Basis& basis : {constant_basis(), linear_basis()}) {
    const auto edge = leading_edge_constants(basis);
    const PlaneKernel kernel({1, 0}, 1);
    const Eigen::Index n = 800;
    const Eigen::MatrixXd strain = influence_difference_matrix(kernel, basis, 1, n, 1);
    const Eigen::VectorXd traction = strain.lu().solve(Eigen::VectorXd::Constant(n, -1));
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

TEST(LeadingEdgeConstants, WantConstantOrLinearFunctions) {
  EXPECT_THROW(leading_edge_constants(quadratic_basis()), std::invalid_argument);
}

}  // namespace
}  // namespace microslip
