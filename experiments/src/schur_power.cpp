// SPDX-License-Identifier: GPL-3.0-or-later
#include "schur_power.hpp"

#include <cmath>

namespace microslip::experiments {

using Eigen::MatrixXd;

SchurPowers::SchurPowers(const MatrixXd& matrix) : matrix_(matrix), powers_(matrix) {}

MatrixXd SchurPowers::power(double c) { return powers_(c); }

double SchurPowers::residual(const MatrixXd& power, double c) {
  const MatrixXd rest = powers_(1 - c);
  return (power * rest - matrix_).cwiseAbs().maxCoeff() / matrix_.cwiseAbs().maxCoeff();
}

bool is_negative(const std::complex<double>& eigenvalue) {
  constexpr double rounding = 1e-9;
  return eigenvalue.real() < 0 && std::abs(eigenvalue.imag()) < rounding * std::abs(eigenvalue);
}

}  // namespace microslip::experiments
