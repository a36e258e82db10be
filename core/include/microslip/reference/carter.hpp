// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/material.hpp"

namespace microslip {

/// Carter's and Fromm's exact solution of steady rolling: plane strain, Hertzian bound. The stick
/// zone is the part of length 2 a' a next to the leading edge. Thesis (10.1), with dimensions:
/// \f[ |F| = (1-a'^2)\,F_{\max}, \qquad |w| = (1-a')\,\frac{2(1-\nu)}{G}\,\mu p_0 \f]
/// Accuracy: 2e-15 relative, besides the effect of rounding the load and the distance from the
/// nearer edge. It holds for loads from 1e-12 of full sliding to 1e-12 below it, and at positions
/// down to 1e-15 a from the edges: tests/digits/closed_form_test.cpp
class Carter {
 public:
  /// \param creepage  w, finite; |w| >= compliance * peak is full sliding  [1]
  static Carter from_creepage(const Material& material, const HertzBound& bound, double creepage);

  /// The state under a positive creepage.
  /// \param stick_ratio  a', in [0, 1]
  /// \throws std::invalid_argument outside the range
  static Carter from_stick_ratio(const Material& material, const HertzBound& bound,
                                 double stick_ratio);

  /// \param force  F, at most full sliding in absolute value  [N/mm]
  /// \throws std::invalid_argument above full sliding
  static Carter from_force(const Material& material, const HertzBound& bound, double force);

  const HertzBound& bound() const { return bound_; }

  /// 1 for a positive creepage, -1 for a negative one.
  double direction() const { return direction_; }

  /// a': stick length over contact length, in [0, 1].
  double stick_ratio() const { return stick_ratio_; }

  /// 1 - a', to all digits next to full adhesion, too.
  double slip_ratio() const { return slip_ratio_; }

  /// w, opposite in sign to the tractions; in full sliding, the least such |w|  [1]
  double creepage() const;

  /// F = -+(pi/2) a peak (1 - a'^2)  [N/mm]
  double force() const;

  /// p(x); zero outside the contact  [N/mm^2]
  double traction(double x) const;

  /// s(x) inside the contact, zero in the stick zone  [1]
  double slip(double x) const;

 private:
  Carter(const Material& material, const HertzBound& bound, double stick_ratio, double slip_ratio,
         double direction);
  double into_adhesion(double x) const;

  double compliance_;
  HertzBound bound_;
  double stick_ratio_;
  double slip_ratio_;
  double direction_;  ///< sign of the creepage
};

}  // namespace microslip
