// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// g(x) = mu p_n(x) of a Hertzian line contact: peak sqrt(1 - (x/a)^2), zero outside [-a, a].
class HertzBound {
 public:
  /// \param half_width  a, in (0, inf)  [mm]
  /// \param peak        mu p_0, in (0, inf)  [N/mm^2]
  /// \throws std::invalid_argument outside the ranges
  HertzBound(double half_width, double peak);

  double half_width() const { return half_width_; }
  double peak() const { return peak_; }

  /// g(x)  [N/mm^2]
  double operator()(double x) const;
  Eigen::VectorXd operator()(const Eigen::VectorXd& x) const;

  /// The force of full sliding, (pi/2) a peak  [N/mm]
  double total() const;

 private:
  double half_width_;
  double peak_;
};

}  // namespace microslip
