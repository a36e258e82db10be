// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/edge_calibration.hpp"

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "microslip/halfspace/influence.hpp"
#include "microslip/halfspace/leading_edge.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/linalg/toeplitz_inverse.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr Material unit_material{.shear_modulus = 2, .poisson_ratio = 0};

/// Differences of the strain of a function over elements 0 ... n, which begin with node -1.
Toeplitz strain_of(const ShapeFunction& shape, Index n) {
  return influence_difference_toeplitz(PlaneKernel(unit_material, 1), shape, 1, n + 1, 1)
      .times(1 / compliance(unit_material));
}

/// n elements that make this strain, and a constant one, in n + 1 elements. Node -1 has no element:
/// that determines the constant.
VectorXd elements_by_fft(const Basis& basis, const VectorXd& strain) {
  const Index n = strain.size() - 1;
  const ToeplitzInverse inverse(strain_of(basis.shapes().front(), n));
  VectorXd by_strain, by_one;
  inverse.apply(strain, by_strain);
  inverse.apply(VectorXd::Ones(n + 1), by_one);
  return by_strain.tail(n) - by_strain[0] / by_one[0] * by_one.tail(n);
}

VectorXd elements_by_factors(const Basis& basis, const VectorXd& strain) {
  const Index n = strain.size() - 1;
  require_dense(n);
  std::vector<Toeplitz> strains;
  for (const ShapeFunction& shape : basis.shapes()) strains.push_back(strain_of(shape, n));
  MatrixXd matrix(n + 1, n + 1);
  for (Index j = 0; j < n; ++j) {
    const Toeplitz& column = strains[basis.shape_of(j, n)];
    for (Index i = 0; i <= n; ++i) matrix(i, j) = column(i, j + 1);
  }
  matrix.rightCols(1).setOnes();
  count_work(2.0 / 3 * std::pow(n + 1, 3));
  return LuFactors(matrix).solve(strain).head(n);
}

}  // namespace

double calibrated_offset(const Basis& basis, Index elements, const Solver& solver) {
  const double half = static_cast<double>(elements) / 2;
  const VectorXd strain = VectorXd::LinSpaced(elements + 1, -half, half);
  const VectorXd coefficients = by_fft(solver, basis, elements)
                                    ? elements_by_fft(basis, strain)
                                    : elements_by_factors(basis, strain);
  // With sqrt(r^2 - x^2) the strain is x, and the force pi r^2/2.
  const double force = basis.weights(1, elements).dot(coefficients);
  return std::sqrt(2 * force / std::numbers::pi) - static_cast<double>(elements - 1) / 2;
}

double calibrated_offset(const Basis& basis, Index elements, double softness,
                         const Solver& solver) {
  if (std::isinf(softness)) return 1;
  const double alone = calibrated_offset(basis, elements, solver);
  if (softness == 0) return alone;
  return alone + leading_edge_constants(basis, softness).offset -
         leading_edge_constants(basis).offset;
}

}  // namespace microslip
