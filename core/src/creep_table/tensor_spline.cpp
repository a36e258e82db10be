// SPDX-License-Identifier: GPL-3.0-or-later
#include "tensor_spline.hpp"

#include <Eigen/Core>
#include <algorithm>

#include "microslip/linalg/lu_factors.hpp"
#include "microslip/linalg/matrix_product.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

/// Coefficients of the spline through values on a closed circle.
MatrixXd spline_on_circle(Index nodes) {
  MatrixXd values = MatrixXd::Zero(nodes, nodes);
  for (Index i = 0; i < nodes; ++i) {
    values(i, (i + nodes - 1) % nodes) += 1.0 / 6;
    values(i, i) += 4.0 / 6;
    values(i, (i + 1) % nodes) += 1.0 / 6;
  }
  return LuFactors(values).inverse();
}

}  // namespace

MatrixXd spline_between_ends(Index nodes) {
  const Index n = nodes + 2;
  MatrixXd values = MatrixXd::Zero(n, n);
  for (Index i = 0; i < nodes; ++i) values.row(i + 1).segment(i, 3) << 1.0 / 6, 4.0 / 6, 1.0 / 6;
  const Eigen::Matrix<double, 1, 5> jump{1, -4, 6, -4, 1};  // of the third derivative
  values.row(0).head(5) = jump;
  values.row(n - 1).tail(5) = jump;
  return LuFactors(values).inverse().middleCols(1, nodes);
}

MatrixXd spline_between_mirrors(Index nodes, double parity) {
  const Index around = 2 * (nodes - 1);
  const MatrixXd circle = spline_on_circle(around);
  MatrixXd coefficients = MatrixXd::Zero(nodes + 2, nodes);
  for (Index i = -1; i <= nodes; ++i) {
    for (Index k = 0; k < around; ++k) {
      const bool is_mirrored = k >= nodes;
      coefficients(i + 1, is_mirrored ? around - k : k) +=
          (is_mirrored ? parity : 1) * circle((i + around) % around, k);
    }
  }
  return coefficients;
}

MeridianSpline spline_over_pole(Index nodes) {
  const Index quarter = nodes - 1, around = 4 * quarter;
  const MatrixXd circle = spline_on_circle(around);
  MeridianSpline spline{MatrixXd::Zero(nodes + 2, nodes), MatrixXd::Zero(nodes + 2, nodes)};
  for (Index i = -1; i <= nodes; ++i) {
    for (Index k = 0; k < around; ++k) {
      const double weight = circle((i + around) % around, k);
      if (k <= quarter) {
        spline.own(i + 1, k) += weight;
      } else if (k <= 2 * quarter) {
        spline.opposite(i + 1, 2 * quarter - k) -= weight;
      } else if (k <= 3 * quarter) {
        spline.own(i + 1, k - 2 * quarter) -= weight;
      } else {
        spline.opposite(i + 1, around - k) += weight;
      }
    }
  }
  return spline;
}

SplinePlace::SplinePlace(double place, std::size_t nodes)
    : first(std::min(static_cast<std::size_t>(place), nodes - 2)) {
  const double u = place - static_cast<double>(first), v = 1 - u;
  value = {v * v * v / 6, (4 - 6 * u * u + 3 * u * u * u) / 6, (4 - 6 * v * v + 3 * v * v * v) / 6,
           u * u * u / 6};
  slope = {-v * v / 2, (-12 * u + 9 * u * u) / 6, (12 * v - 9 * v * v) / 6, u * u / 2};
}

std::vector<double> along_axis(const std::vector<double>& values, const MatrixXd& matrix,
                               std::size_t before, std::size_t after) {
  const auto to = static_cast<std::size_t>(matrix.rows()),
             from = static_cast<std::size_t>(matrix.cols());
  std::vector<double> result(before * to * after);
  const auto columns = static_cast<Index>(after);
  const MatrixXd transposed = matrix.transpose();
  for (std::size_t i = 0; i < before; ++i) {
    const Eigen::Map<const MatrixXd> rows(values.data() + i * from * after, columns, matrix.cols());
    Eigen::Map<MatrixXd>(result.data() + i * to * after, columns, matrix.rows()) =
        matrix_product(rows, transposed);
  }
  return result;
}

}  // namespace microslip
