// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// A traction with square roots at both ends of an interval: sqrt(1 - t^2) times the sum of c_n
/// U_n(t), with t from -1 to 1 and U_n Chebyshev's polynomials of the second kind. In plane strain
/// the strain due to each term is a polynomial inside the interval, 2 (1 - nu)/G T_(n+1)(t).
class ChebyshevTraction {
 public:
  /// \param begin, end     begin < end  [mm]
  /// \param coefficients   c_n, at least one  [N/mm^2]
  ChebyshevTraction(double begin, double end, Eigen::VectorXd coefficients);

  double begin() const { return begin_; }
  double end() const { return end_; }
  double centre() const { return (begin_ + end_) / 2; }
  double half_length() const { return (end_ - begin_) / 2; }
  const Eigen::VectorXd& coefficients() const { return coefficients_; }

  /// p(x), zero outside the interval  [N/mm^2]
  double operator()(double x) const;

  /// The integral of p up to x  [N/mm]
  double integral(double x) const;

  /// The integral from x - behind to x + before, both inside the interval. For small lengths it
  /// does not cancel as a difference of two integrals does  [N/mm]
  double integral(double x, double behind, double before) const;

  /// The whole integral  [N/mm]
  double force() const;

  /// The sum of c_n U_n(t): the traction without its square roots, also beyond the ends  [N/mm^2]
  double polynomial(double x) const;

 private:
  double position(double x) const { return (x - centre()) / half_length(); }

  double begin_;
  double end_;
  Eigen::VectorXd coefficients_;
};

}  // namespace microslip
