// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/rectangles.hpp"

#include <cmath>
#include <numbers>

#include "microslip/support/require.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

/// The middle of column i of a grid of `count` columns about the origin.
double middle(Index i, Index count, double side) {
  return (static_cast<double>(2 * i + 1 - count) / 2) * side;
}

/// x arsinh(y/|x|), which is continuous at x = 0.
double times_arsinh(double x, double y) { return x == 0 ? 0 : x * std::asinh(y / std::abs(x)); }

}  // namespace

Rectangles::Rectangles(double dx, double dy, const Mask& contact)
    : dx_(dx), dy_(dy), columns_(contact.rows()) {
  require_positive("dx", dx);
  require_positive("dy", dy);
  first_.push_back(0);
  for (Index k = 0; k < contact.cols(); ++k) {
    for (Index i = 0; i < columns_; ++i) {
      if (!contact(i, k)) continue;
      column_.push_back(i);
      row_.push_back(k);
    }
    first_.push_back(size());
  }
  require(size() > 0, "contact", static_cast<double>(size()), "elements, at least one");
}

Rectangles Rectangles::in_ellipse(double a, double b, Index elements, Index rows) {
  require_positive("half_width", a);
  require_positive("lateral_half_width", b);
  require(elements >= 1, "elements", static_cast<double>(elements), "at least 1");
  require(rows >= 1, "rows", static_cast<double>(rows), "at least 1");
  Mask contact(elements, rows);
  for (Index k = 0; k < rows; ++k) {
    for (Index i = 0; i < elements; ++i) {
      contact(i, k) = std::hypot(middle(i, elements, 2.0 / static_cast<double>(elements)),
                                 middle(k, rows, 2.0 / static_cast<double>(rows))) < 1;
    }
  }
  return {2 * a / static_cast<double>(elements), 2 * b / static_cast<double>(rows), contact};
}

double Rectangles::x(Index element) const { return middle(column(element), columns_, dx_); }

double Rectangles::y(Index element) const { return middle(row(element), rows(), dy_); }

RectangleKernels::RectangleKernels(const Rectangles& rectangles, double ahead) {
  // Sums over corners are differences of differences along both axes.
  const Index columns = rectangles.columns(), rows = rectangles.rows();
  MatrixXd on_near(2 * columns, 2 * rows), on_across = on_near, on_mixed = on_near;
  count_work(3 * kernel_work * static_cast<double>(on_near.size()));
  for (Index k = 0; k < 2 * rows; ++k) {
    const double y = (static_cast<double>(k - rows) + 0.5) * rectangles.dy();
    for (Index i = 0; i < 2 * columns; ++i) {
      const double x = (static_cast<double>(i - columns) + 0.5 + ahead) * rectangles.dx();
      on_across(i, k) = times_arsinh(x, y);
      on_near(i, k) = on_across(i, k) + times_arsinh(y, x);
      on_mixed(i, k) = -std::hypot(x, y);
    }
  }
  const auto integral = [&](const MatrixXd& corners) -> MatrixXd {
    const MatrixXd along = corners.bottomRows(2 * columns - 1) - corners.topRows(2 * columns - 1);
    return along.rightCols(2 * rows - 1) - along.leftCols(2 * rows - 1);
  };
  near = integral(on_near);
  across = integral(on_across);
  mixed = integral(on_mixed);
}

RectangleInfluence::RectangleInfluence(const Rectangles& rectangles, double poisson_ratio,
                                       const std::vector<Part>& parts)
    : convolution_(rectangles.columns(), rectangles.rows()), columns_(rectangles.columns()) {
  const double nu = poisson_ratio;
  const Index rows = rectangles.rows();
  MatrixXd along = MatrixXd::Zero(2 * columns_ - 1, 2 * rows - 1), across = along, mixed = along;
  for (const auto& [factor, ahead] : parts) {
    const RectangleKernels kernels(rectangles, ahead);
    along += factor / pi * (kernels.near - nu * kernels.across);
    across += factor / pi * ((1 - nu) * kernels.near + nu * kernels.across);
    mixed += factor / pi * nu * kernels.mixed;
  }
  along_ = along.col(rows - 1);
  across_ = across.col(rows - 1);
  symbol_along_ = convolution_.symbol(along);
  symbol_across_ = convolution_.symbol(across);
  symbol_mixed_ = convolution_.symbol(mixed);
  for (Index element = 0; element < rectangles.size(); ++element) {
    places_.push_back(convolution_.place(rectangles.column(element), rectangles.row(element)));
  }
}

void RectangleInfluence::apply(const VectorXd& tractions, VectorXd& values) const {
  const auto n = static_cast<Index>(places_.size());
  RealFft& fft = convolution_.fft();
  const auto transformed = [&](Index begin) -> VectorXcd {
    auto on_grid = fft.values();
    on_grid.setZero();
    for (Index i = 0; i < n; ++i)
      on_grid[places_[static_cast<std::size_t>(i)]] = tractions[begin + i];
    fft.forward();
    return fft.spectrum();
  };
  const VectorXcd x = transformed(0), y = transformed(n);
  values.resize(2 * n);
  const auto take = [&](const VectorXcd& by_x, const VectorXcd& by_y, Index begin) {
    fft.spectrum().array() = by_x.array() * x.array() + by_y.array() * y.array();
    fft.backward();
    const auto on_grid = fft.values();
    for (Index i = 0; i < n; ++i) values[begin + i] = on_grid[places_[static_cast<std::size_t>(i)]];
  };
  take(symbol_along_, symbol_mixed_, 0);
  take(symbol_mixed_, symbol_across_, n);
}

}  // namespace microslip
