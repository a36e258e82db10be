// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// M rows of N cells along the rolling have the tractions on an ellipse a/b with a b = 1.
///
/// Row k is the strip between y = b sin(psi) at psi_k -+ pi/2M; psi_k = -pi/2 + (k + 1/2) pi/M. Its
/// cells are edge to edge in s = x/a(y) = cos(theta), a(y) = a cos(psi), with centres at theta_i =
/// (i + 1/2) pi/N from the leading edge, theta = 0, on. A traction is
///   p = sqrt((1 - s)/(1 + s)) v(theta, psi) = tan(theta/2) v,
/// which vanishes at the leading edge, and is singular at a trailing edge that sticks. The unknown
/// v is smooth: it is nearly constant if all sticks under a creepage. Between the centres, v follows
/// by stencils that are exact for 1, cos and sin.
///
/// Displacements are at 2N + 1 points a row, theta_j = j pi/2N: the sides of cell i are j = 2i and
/// 2i + 2, its centre is 2i + 1. Order of cells: i + N k; of points: j + (2N + 1) k.
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

  /// \param ratio     a/b, > 0
  /// \param rows      M, >= 1
  /// \param elements  N, >= 1
  /// \throws std::invalid_argument outside the ranges
  JoinedRows(double ratio, Index rows, Index elements);

  Index rows() const { return rows_; }
  Index elements() const { return elements_; }
  Index cells() const { return rows_ * elements_; }
  Index points() const { return rows_ * (2 * elements_ + 1); }

  Index cell(Index i, Index k) const { return i + elements_ * k; }
  Index point(Index j, Index k) const { return j + (2 * elements_ + 1) * k; }

  double a() const { return a_; }
  double b() const { return 1 / a_; }
  double psi(Index k) const;    ///< of the middle of a row
  double theta(Index i) const;  ///< of the centre of a cell
  double y(Index k) const;
  double x(Index j, Index k) const;  ///< of a point
  Eigen::VectorXd areas() const;     ///< of the cells
  Kernels kernels() const;

  /// The force, and the first moments in x and in y, of v = 1 in a cell: 3 x cells.
  Eigen::Matrix3Xd moments() const;

 private:
  Index rows_, elements_;
  double a_;
};

}  // namespace microslip
