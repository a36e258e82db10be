// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/thesis/schur_powers.hpp"

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace microslip {

using Eigen::MatrixXd;

class SchurPowers::Method : public Eigen::MatrixPower<MatrixXd> {
  using MatrixPower::MatrixPower;
};

SchurPowers::SchurPowers(const MatrixXd& matrix)
    : matrix_(matrix), method_(std::make_unique<Method>(matrix)) {}
SchurPowers::~SchurPowers() = default;

MatrixXd SchurPowers::power(double c) { return (*method_)(c); }

double SchurPowers::residual(const MatrixXd& power, double c) {
  const MatrixXd rest = (*method_)(1 - c);
  return (power * rest - matrix_).cwiseAbs().maxCoeff() / matrix_.cwiseAbs().maxCoeff();
}

bool is_negative(const std::complex<double>& eigenvalue) {
  constexpr double rounding = 1e-9;
  return eigenvalue.real() < 0 && std::abs(eigenvalue.imag()) < rounding * std::abs(eigenvalue);
}

}  // namespace microslip
