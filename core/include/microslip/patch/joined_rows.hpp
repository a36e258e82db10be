// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/patch/patch_shape.hpp"

namespace microslip {

/// M rows of N cells along the rolling have the tractions on a patch of the size c = 1, such as an
/// ellipse a/b with a b = 1.
///
/// Each lobe of the patch has rows of its own; with m of them, row k of the lobe is the strip of psi
/// about psi_k = -pi/2 + (k + 1/2) pi/m of the height pi/m; y = middle + height sin(psi). Its cells
/// are edge to edge in s = cos(theta), x = middle(y) + a(y) s with the half-length a(y) of the row,
/// and have centres at theta_i = (i + 1/2) pi/N from the leading edge, theta = 0, on. A traction is
///   p = sqrt((1 - s)/(1 + s)) v(theta, psi) = tan(theta/2) v,
/// which vanishes at the leading edge, and is singular at a trailing edge that sticks. The unknown
/// v is smooth: it is nearly constant if all sticks under a creepage. Between the centres, v follows
/// by stencils that are exact for 1, cos and sin, within a lobe.
///
/// Displacements are at 2N + 1 points a row, theta_j = j pi/2N: the sides of cell i are j = 2i and
/// 2i + 2, its centre is 2i + 1. Order of cells: i + N k; of points: j + (2N + 1) k; of rows: lobe
/// by lobe.
///
/// Accuracy: Kalker's coefficients to 2e-4 with 5 x 5 cells on a circle, tests/unit/patch_test.cpp
class JoinedRows {
 public:
  using Index = Eigen::Index;

  /// Integrals of v = 1 in a cell over the contact, a row for each point. R is the distance of the
  /// point, X and Y its parts along and across.
  struct Kernels {
    Eigen::MatrixXd near;    ///< of p/R
    Eigen::MatrixXd across;  ///< of p Y^2/R^3
    Eigen::MatrixXd mixed;   ///< of p X Y/R^3
  };

  /// Makes rows on an ellipse.
  /// \param ratio     a/b, > 0
  /// \param rows      M, >= 1
  /// \param elements  N, >= 1
  /// \throws std::invalid_argument outside the ranges
  JoinedRows(double ratio, Index rows, Index elements);

  /// Makes rows on any shape. Lobes have rows in proportion to their heights, and at least three if
  /// there are as many.
  /// \param rows  M of all lobes together, not less than there are lobes
  /// \throws std::invalid_argument outside the ranges
  JoinedRows(const PatchShape& shape, Index rows, Index elements);

  Index rows() const { return rows_; }
  Index elements() const { return elements_; }
  Index cells() const { return rows_ * elements_; }
  Index points() const { return rows_ * (2 * elements_ + 1); }

  Index cell(Index i, Index k) const { return i + elements_ * k; }
  Index point(Index j, Index k) const { return j + (2 * elements_ + 1) * k; }

  const PatchShape& shape() const { return shape_; }

  std::size_t lobe(Index k) const { return row_of(k).lobe; }           ///< of a row
  double psi(Index k) const { return row_of(k).psi; }                  ///< of the middle of a row
  double height(Index k) const { return row_of(k).height; }            ///< of a row, in psi
  double theta(Index i) const;                                         ///< of the centre of a cell
  double half_length(Index k) const { return row_of(k).half_length; }  ///< of a row at its middle
  double y(Index k) const { return row_of(k).y; }
  double x(Index j, Index k) const;          ///< of a point
  double theta_of(double x, Index k) const;  ///< of a place in a row; 0 or pi beyond its edges
  Eigen::VectorXd areas() const;             ///< of the cells
  Kernels kernels() const;

  /// The force, and the first moments in x and in y, of v = 1 in a cell: 3 x cells.
  Eigen::Matrix3Xd moments() const;

 private:
  struct Row {
    std::size_t lobe;
    double psi, height, y, middle, half_length;
  };

  const Row& row_of(Index k) const { return placed_[static_cast<std::size_t>(k)]; }

  Index rows_, elements_;
  PatchShape shape_;
  std::vector<Index> first_rows_;  ///< of each lobe, and M at last
  std::vector<Row> placed_;        ///< all rows, at their middles
};

}  // namespace microslip
