// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/linalg/plane_convolution.hpp"

namespace microslip {

/// Equal rectangles of a grid about the origin, some of which are elements of the contact. The
/// order of elements is row by row, along the rolling first.
class Rectangles {
 public:
  using Index = Eigen::Index;
  using Mask = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

  /// \param dx,dy    sides along and across the rolling, > 0
  /// \param contact  which rectangles are elements: columns x rows
  /// \throws std::invalid_argument if a side is not positive, or there is no element
  Rectangles(double dx, double dy, const Mask& contact);

  /// The rectangles whose centres lie in an ellipse.
  /// \param a,b       half-widths along and across the rolling, > 0
  /// \param elements  N in the width 2 a, >= 1
  /// \param rows      M in the width 2 b, >= 1
  /// \throws std::invalid_argument outside the ranges
  static Rectangles in_ellipse(double a, double b, Index elements, Index rows);

  double dx() const { return dx_; }
  double dy() const { return dy_; }
  double area() const { return dx_ * dy_; }  ///< of an element
  Index columns() const { return columns_; }
  Index rows() const { return static_cast<Index>(first_.size()) - 1; }
  Index size() const { return static_cast<Index>(column_.size()); }  ///< number of elements

  Index column(Index element) const { return column_[static_cast<std::size_t>(element)]; }
  Index row(Index element) const { return row_[static_cast<std::size_t>(element)]; }
  Index first_of(Index row) const { return first_[static_cast<std::size_t>(row)]; }
  double x(Index element) const;  ///< of a centre
  double y(Index element) const;

 private:
  double dx_, dy_;
  Index columns_;
  std::vector<Index> column_, row_;
  std::vector<Index> first_;  ///< element of each row, and the number of elements
};

/// Integrals of 1/R, Y^2/R^3 and X Y/R^3 over a rectangle, in closed form, with X and Y from a
/// point of the rectangle to the point where the displacement is: for each distance on a grid.
struct RectangleKernels {
  Eigen::MatrixXd near, across, mixed;

  /// \param ahead  of the points from the centres, in elements along the rolling
  /// Order: as PlaneConvolution::symbol().
  RectangleKernels(const Rectangles& rectangles, double ahead);
};

/// Displacement differences of half-spaces with G = 1 by constant tractions in rectangles, or sums
/// and differences of them. Products take four transforms. One object serves one thread.
class RectangleInfluence {
 public:
  using Index = Eigen::Index;

  /// A factor times the displacements at points ahead of the centres, in elements.
  struct Part {
    double factor, ahead;
  };

  /// \param poisson_ratio  nu, in [0, 0.5]
  RectangleInfluence(const Rectangles& rectangles, double poisson_ratio,
                     const std::vector<Part>& parts);

  /// \param tractions  2n: along the rolling, then across
  /// \param values     out: 2n, in the same order; not in place
  void apply(const Eigen::VectorXd& tractions, Eigen::VectorXd& values) const;

  /// The coefficient of a traction along, or across, i columns behind in the same row, for the
  /// value in the same direction. In a row, tractions along have no part in values across.
  double along(Index i) const { return along_[i + columns_ - 1]; }
  double across(Index i) const { return across_[i + columns_ - 1]; }

 private:
  PlaneConvolution convolution_;
  Index columns_;
  std::vector<Index> places_;
  Eigen::VectorXcd symbol_along_, symbol_across_, symbol_mixed_;
  Eigen::VectorXd along_, across_;
};

}  // namespace microslip
