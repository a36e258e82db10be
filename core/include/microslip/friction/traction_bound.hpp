// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <variant>

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

  /// The integral of g up to x, from the trailing edge  [N/mm]
  double integral(double x) const;

  /// The force of full sliding, (pi/2) a peak  [N/mm]
  double total() const;

 private:
  double half_width_;
  double peak_;
};

/// A bound known at points: linear between them, from the outermost ones to zero at the edges
/// -+half_width, and zero outside.
class TabulatedBound {
 public:
  /// \param half_width  a, in (0, inf)  [mm]
  /// \param x           at least one position, ascending, in [-a, a]  [mm]
  /// \param values      as many, >= 0, not all zero  [N/mm^2]
  /// \throws std::invalid_argument outside the ranges
  TabulatedBound(double half_width, const Eigen::VectorXd& x, const Eigen::VectorXd& values);

  double half_width() const { return half_width_; }

  /// g(x)  [N/mm^2]
  double operator()(double x) const;

  /// The integral of g up to x, from the trailing edge  [N/mm]
  double integral(double x) const;

  /// The force of full sliding: its integral  [N/mm]
  double total() const { return integral(half_width_); }

 private:
  double half_width_;
  Eigen::VectorXd x_;  ///< with the edges
  Eigen::VectorXd values_;
};

using TractionBound = std::variant<HertzBound, TabulatedBound>;

double half_width_of(const TractionBound& bound);

/// g at each position  [N/mm^2]
Eigen::VectorXd bound_at(const TractionBound& bound, const Eigen::VectorXd& x);

/// Means of g over intervals of the given width around each position  [N/mm^2]
/// \param width  in (0, inf)  [mm]
Eigen::VectorXd mean_bound_around(const TractionBound& bound, const Eigen::VectorXd& x,
                                  double width);

/// The force of full sliding  [N/mm]
double full_sliding_force(const TractionBound& bound);

}  // namespace microslip
