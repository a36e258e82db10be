// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/standard_patch.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <vector>

namespace microslip::experiments {

using Eigen::Index;

namespace {

/// The integrals of 1/R, Y^2/R^3 and X Y/R^3 over a rectangle about a distance.
struct Rectangle {
  double near = 0, across = 0, mixed = 0;

  Rectangle(double x, double y, double dx, double dy) {
    for (const int i : {-1, 1}) {
      for (const int j : {-1, 1}) {
        const double X = x + i * dx / 2, Y = y + j * dy / 2, R = std::hypot(X, Y);
        const double along_y = X * std::asinh(Y / std::abs(X));
        near += i * j * (along_y + Y * std::asinh(X / std::abs(Y)));
        across += i * j * along_y;
        mixed -= i * j * R;
      }
    }
  }
};

}  // namespace

StandardPatch standard_patch(double ratio, Index elements, double nu) {
  const double a = std::sqrt(ratio), b = 1 / a;
  const auto n = static_cast<double>(elements);
  const double dx = 2 * a / n, dy = 2 * b / n;
  std::vector<Eigen::Vector2d> centres;
  for (Index k = 0; k < elements; ++k) {
    for (Index i = 0; i < elements; ++i) {
      const Eigen::Vector2d at((static_cast<double>(i) + 0.5) * dx - a,
                               (static_cast<double>(k) + 0.5) * dy - b);
      if (std::hypot(at[0] / a, at[1] / b) < 1) centres.push_back(at);
    }
  }
  const auto size = static_cast<Index>(centres.size());
  Eigen::MatrixXd slip(2 * size, 2 * size);
  Eigen::MatrixX3d motion(2 * size, 3);
  Eigen::Matrix3Xd resultants = Eigen::Matrix3Xd::Zero(3, 2 * size);
  for (Index i = 0; i < size; ++i) {
    const Eigen::Vector2d& at = centres[static_cast<std::size_t>(i)];
    for (Index j = 0; j < size; ++j) {
      const Eigen::Vector2d away = at - centres[static_cast<std::size_t>(j)];
      const Rectangle here(away[0], away[1], dx, dy), ahead(away[0] + dx, away[1], dx, dy);
      const double scale = 1 / (std::numbers::pi * dx);
      const double near = scale * (here.near - ahead.near);
      const double across = scale * (here.across - ahead.across);
      slip(i, j) = near - nu * across;
      slip(size + i, size + j) = (1 - nu) * near + nu * across;
      slip(i, size + j) = slip(size + i, j) = nu * scale * (here.mixed - ahead.mixed);
    }
    motion.row(i) << 1, 0, -at[1];
    motion.row(size + i) << 0, 1, at[0] + dx / 6;
    resultants(0, i) = resultants(1, size + i) = dx * dy;
    resultants(2, i) = -at[1] * dx * dy;
    resultants(2, size + i) = at[0] * dx * dy;
  }
  const Eigen::MatrixX3d tractions = -slip.partialPivLu().solve(motion);
  return {size, resultants * tractions};
}

}  // namespace microslip::experiments
