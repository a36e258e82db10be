// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <variant>

#include "microslip/halfspace/chebyshev_traction.hpp"

namespace microslip {

/// \file
/// Accuracy of values, integrals and means: 1e-15 relative, down to 1e-15 half-widths from the
/// edges and for elements down to that width. The error of a polynomial bound is 2e-15 up to degree
/// 2, and 3e-14 at degree 32, relative to Hertz's bound times the sum of the absolute coefficients;
/// the error of an integral is relative to the whole integral. tests/digits/bound_test.cpp

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

  /// The mean of g from x - width/2 to x + width/2, width in (0, inf)  [N/mm^2]
  double mean_around(double x, double width) const;

  /// The force of full sliding, (pi/2) a peak  [N/mm]
  double total() const;

 private:
  double height(double to_trailing, double to_leading) const;
  double integral(double heights, double length) const;

  double half_width_;
  double peak_;
};

/// A polynomial times Hertz's square roots: peak sqrt(1 - (x/a)^2) h(x/a), zero outside [-a, a].
class PolynomialBound {
 public:
  /// \param half_width    a, in (0, inf)  [mm]
  /// \param peak          in (0, inf)  [N/mm^2]
  /// \param coefficients  coefficients of h, from the constant up; 1 to 33 numbers, with h >= 0 in
  ///                      [-1, 1]  [1]
  /// \throws std::invalid_argument outside the ranges
  PolynomialBound(double half_width, double peak, const Eigen::VectorXd& coefficients);

  /// \param traction  centred at x = 0, and nowhere negative
  explicit PolynomialBound(const ChebyshevTraction& traction) : traction_(traction) {}

  double half_width() const { return traction_.half_length(); }

  /// g(x)  [N/mm^2]
  double operator()(double x) const { return traction_(x); }

  /// The integral of g up to x, from the trailing edge  [N/mm]
  double integral(double x) const { return traction_.integral(x); }

  /// The mean of g from x - width/2 to x + width/2, width in (0, inf)  [N/mm^2]
  double mean_around(double x, double width) const;

  /// The force of full sliding  [N/mm]
  double total() const { return traction_.force(); }

  const ChebyshevTraction& traction() const { return traction_; }

 private:
  ChebyshevTraction traction_;
};

/// A bound known at points. It is linear between points, linear from the outermost points to zero
/// at the edges -+half_width, and zero outside.
class TabulatedBound {
 public:
  /// \param half_width  a, in (0, inf)  [mm]
  /// \param x           ascending, in [-a, a]; edges may be off by 4 roundings  [mm]
  /// \param values      as many as x, >= 0, not all zero  [N/mm^2]
  /// \throws std::invalid_argument outside the ranges
  TabulatedBound(double half_width, const Eigen::VectorXd& x, const Eigen::VectorXd& values);

  double half_width() const { return half_width_; }

  /// g(x)  [N/mm^2]
  double operator()(double x) const;

  /// The integral of g up to x, from the trailing edge  [N/mm]
  double integral(double x) const;

  /// The mean of g from x - width/2 to x + width/2, width in (0, inf)  [N/mm^2]
  double mean_around(double x, double width) const;

  /// The force of full sliding: the integral of g  [N/mm]
  double total() const { return integral(half_width_); }

  // The ends of the straight pieces, the edges included, and the values at these ends.
  const Eigen::VectorXd& x() const { return x_; }            ///< [mm]
  const Eigen::VectorXd& values() const { return values_; }  ///< [N/mm^2]

 private:
  double half_width_;
  void integrate();

  Eigen::VectorXd x_;  ///< the points and the edges
  Eigen::VectorXd values_;
  Eigen::VectorXd integrals_;  ///< of g up to each of these points
};

using TractionBound = std::variant<HertzBound, PolynomialBound, TabulatedBound>;

double half_width_of(const TractionBound& bound);

/// The bound as a sum of Chebyshev polynomials; none for a tabulated bound.
std::optional<ChebyshevTraction> chebyshev_traction(const TractionBound& bound);

/// g at each position  [N/mm^2]
Eigen::VectorXd bound_at(const TractionBound& bound, const Eigen::VectorXd& x);

/// Means of g over intervals of the given width around each position  [N/mm^2]
/// \param width  in (0, inf)  [mm]
Eigen::VectorXd mean_bound_around(const TractionBound& bound, const Eigen::VectorXd& x,
                                  double width);

/// Element means of g. The elements fill the contact; the outermost ones extend to the edges. A
/// mean is the integral over an element divided by the element's length, so that means times
/// lengths sum up to full sliding.
///
/// \param x        nodes, ascending  [mm]
/// \param lengths  of the elements, (0, inf)  [mm]
Eigen::VectorXd element_means(const TractionBound& bound, const Eigen::VectorXd& x,
                              const Eigen::VectorXd& lengths);

/// The force of full sliding  [N/mm]
double full_sliding_force(const TractionBound& bound);

}  // namespace microslip
