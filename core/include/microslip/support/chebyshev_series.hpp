// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// n Chebyshev points in (-half_length, half_length), descending.
Eigen::VectorXd chebyshev_points(double half_length, Eigen::Index n);

/// Interpolates between values at the Chebyshev points of an interval about 0.
class ChebyshevSeries {
 public:
  /// \param values       at chebyshev_points(half_length, values.size()), at least one
  /// \param half_length  > 0
  /// \throws std::invalid_argument outside the range
  ChebyshevSeries(const Eigen::VectorXd& values, double half_length);

  double operator()(double x) const;
  /// Returns the values at many points, each in a fifth of the time.
  Eigen::VectorXd operator()(const Eigen::Ref<const Eigen::VectorXd>& x) const;

 private:
  double half_length_;
  Eigen::VectorXd coefficients_;  ///< of T_0, of which half counts, T_1, ...
};

}  // namespace microslip
