// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/halfspace/chebyshev_traction.hpp"
#include "microslip/halfspace/kernel.hpp"

namespace microslip {

/// Strain and displacement of the half-space under a ChebyshevTraction. The logarithm of the kernel
/// is integrated in closed form, its regular part by Gauss-Chebyshev quadrature; the number of
/// points follows from the distance of the regular part's nearest singularity. Accuracy: 2e-15 of 2
/// (1 - nu)/G times the sum of the absolute coefficients; for displacements, also times the
/// half-length and the logarithm of (strip width or L0)/half-length. It holds from 1e-15 to 1e6
/// half-lengths from the ends, for strips of at least 0.02 half-lengths:
/// tests/digits/field_test.cpp
class ChebyshevField {
 public:
  /// \throws std::invalid_argument if a strip is narrower than 0.02 half-lengths of the traction
  ///                               interval
  ChebyshevField(const Kernel& kernel, const ChebyshevTraction& traction);

  const ChebyshevTraction& traction() const { return traction_; }

  /// -du/dx, at any x  [1]
  double strain(double x) const;

  /// u, at any x  [mm]
  double displacement(double x) const;

  // Strain and displacement as inside, continued analytically beyond the ends, without the square
  // roots that they have there. A scheme that takes a difference across the leading edge sees these
  // continued functions.
  double continued_strain(double x) const;        ///< [1]
  double continued_displacement(double x) const;  ///< [mm]

 private:
  double position(double x) const { return (x - traction_.centre()) / traction_.half_length(); }
  double beyond_ends(double x) const;
  template <class Part>
  double integrate(double x, const Part& part) const;
  double regular_strain(double x) const;
  double regular_displacement(double x) const;

  Kernel kernel_;
  ChebyshevTraction traction_;
  double log_strain_;           ///< 2 (1 - nu) / G
  Eigen::VectorXd points_;      ///< of the quadrature  [mm]
  Eigen::VectorXd line_loads_;  ///< at these points  [N/mm]
};

}  // namespace microslip
