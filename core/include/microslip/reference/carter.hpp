// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/material.hpp"

namespace microslip {

/// Carter's and Fromm's exact solution of steady rolling: plane strain, Hertzian bound. The stick
/// zone is the part of length 2 a' a next to the leading edge. Thesis (10.1), with a dimension.
class Carter {
 public:
  /// \param creepage  w, finite; |w| >= compliance * peak is full sliding  [1]
  static Carter from_creepage(const Material& material, const HertzBound& bound, double creepage);

  /// Under a positive creepage.
  /// \param stick_ratio  a', in [0, 1]
  /// \throws std::invalid_argument outside the range
  static Carter from_stick_ratio(const Material& material, const HertzBound& bound,
                                 double stick_ratio);

  /// \param force  F, at most full sliding in absolute value  [N/mm]
  /// \throws std::invalid_argument above that
  static Carter from_force(const Material& material, const HertzBound& bound, double force);

  const HertzBound& bound() const { return bound_; }

  /// 1 for a positive creepage, -1 for a negative one.
  double direction() const { return direction_; }

  /// a': stick length over contact length, in [0, 1].
  double stick_ratio() const { return stick_ratio_; }

  /// w, opposite in sign to the tractions; the least one in full sliding  [1]
  double creepage() const;

  /// F = -+(pi/2) a peak (1 - a'^2)  [N/mm]
  double force() const;

  /// p(x); zero outside the contact  [N/mm^2]
  double traction(double x) const;

  /// s(x) inside the contact, zero in the stick zone  [1]
  double slip(double x) const;

 private:
  Carter(const Material& material, const HertzBound& bound, double stick_ratio, double direction);

  double compliance_;
  HertzBound bound_;
  double stick_ratio_;
  double direction_;  ///< sign of the creepage
};

}  // namespace microslip
