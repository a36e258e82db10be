// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <variant>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/chebyshev_field.hpp"

namespace microslip {

/// Strain and displacement by a TabulatedBound, with integrals of the kernel. Cost: O(rows).
/// Accuracy: 3e-15 as of ChebyshevField, up to three half-widths from the middle; farther on,
/// displacements lose digits with the square of the distance. tests/digits/field_test.cpp
class PolygonField {
 public:
  PolygonField(const Kernel& kernel, const TabulatedBound& bound);

  double strain(double x) const;        ///< infinite at an edge where the bound jumps  [1]
  double displacement(double x) const;  ///< [mm]

 private:
  Kernel kernel_;
  TabulatedBound bound_;
};

/// What the bound itself, as a traction, does to the half-space: exactly, not by elements. A
/// contact that slips is this, so that only what adhesion takes away from it needs elements.
///
/// `continued` as in ChebyshevField; a tabulated bound is not continued.
class FullSliding {
 public:
  /// \throws std::invalid_argument as ChebyshevField
  FullSliding(const Kernel& kernel, const TractionBound& bound);

  double force() const { return force_; }  ///< [N/mm]

  /// -du/dx, inside and behind the contact, and continued before it  [1]
  double strain(double x) const;

  /// The same at ascending places inside the contact, many of which are interpolated where that is
  /// cheaper: to 1e-13.
  Eigen::VectorXd strain(const Eigen::VectorXd& x) const;

  /// u, likewise  [mm]
  double displacement(double x) const;

  /// u(x) - u(x + shift), likewise, without cancellation for small shifts  [mm]
  /// \param shift  >= 0  [mm]
  /// Accuracy: 1e-12 of the shift times the largest strain, by a bound that is no table; up to and
  /// across the trailing edge. tests/digits/field_test.cpp
  double difference(double x, double shift) const;

 private:
  double force_;
  double half_width_;
  double clear_distance_;
  std::variant<ChebyshevField, PolygonField> field_;
};

}  // namespace microslip
