// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace microslip {

/// Hertz's traction bound on an ellipse, mu p0 (1 - x^2/a^2 - y^2/b^2)^(1/2).
class EllipticBound {
 public:
  /// \param half_width          a, along the rolling  [mm]
  /// \param lateral_half_width  b, across it  [mm]
  /// \param peak                mu p0  [N/mm^2]
  /// \throws std::invalid_argument unless all are in [1e-50, 1e50]
  EllipticBound(double half_width, double lateral_half_width, double peak);

  double half_width() const { return a_; }
  double lateral_half_width() const { return b_; }
  double peak() const { return peak_; }

  /// c = (a b)^(1/2)  [mm]
  double size() const;

  /// a/b  [1]
  double ratio() const { return a_ / b_; }

  /// The bound at a point; 0 outside the contact  [N/mm^2]
  double operator()(double x, double y) const;

  /// The force of full sliding, 2/3 pi a b mu p0  [N]
  double total() const;

  /// The moment if all turns about the centre, the largest that friction carries  [N mm]
  double turning_moment() const;

 private:
  double a_, b_, peak_;
};

}  // namespace microslip
