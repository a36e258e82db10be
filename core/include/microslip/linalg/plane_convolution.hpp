// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/linalg/real_fft.hpp"

namespace microslip {

/// Transforms for convolutions of values on a grid of columns and rows with coefficients of the
/// distance in columns and rows. The rows lie one behind another in one array, with gaps as long as
/// a distance, so that one transform of one dimension serves the plane.
class PlaneConvolution {
 public:
  using Index = Eigen::Index;

  /// \param columns,rows  >= 1
  PlaneConvolution(Index columns, Index rows);

  /// The place of column i in row k in the values of the transform.
  Index place(Index i, Index k) const { return i + stride_ * k; }

  /// The factors of the spectrum that make the convolution, for transforms there and back.
  /// \param coefficients  of i - j columns and k - l rows at (i - j + columns - 1, k - l + rows - 1)
  Eigen::VectorXcd symbol(const Eigen::MatrixXd& coefficients) const;

  /// The transform; values at all other places than those of the grid are to be 0.
  RealFft& fft() const { return fft_; }

 private:
  Index columns_, rows_, stride_;
  mutable RealFft fft_;
};

}  // namespace microslip
