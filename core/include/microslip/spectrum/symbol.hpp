// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "microslip/halfspace/kernel.hpp"
#include "microslip/halfspace/shape_function.hpp"

namespace microslip {

/// Fourier symbol of an operator on an unbounded uniform grid: what it does to the traction
/// exp(i k theta), k counting the nodes.
class Symbol {
 public:
  /// The strain operator (A - A') / (c dx)  [mm^2/N]
  /// \param step_ratio  c, >= min_step_ratio
  static Symbol of_strain(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                          double step_ratio);

  /// The influence operator A  [mm^3/N]
  static Symbol of_influence(const Kernel& kernel, const ShapeFunction& shape, double spacing);

  /// \param theta  in [pi/64, pi]
  /// The coefficients fall off as 1/k only, or grow as a logarithm; multiplied by
  /// (e^(i theta) - 1)^4 they fall off as k^-5 or k^-4.
  /// Accuracy: strain 1e-6 at pi/64, 1e-9 from pi/16; influence 1e-5 and 1e-7 of its value,
  /// tests/unit/spectrum_test.cpp
  std::complex<double> operator()(double theta) const;

 private:
  explicit Symbol(const std::function<double(double)>& coefficient);

  std::vector<double> differences_;  ///< fourth differences of the coefficients
};

/// What a transient step of the direct scheme does to the traction exp(i k theta) in adhesion: it
/// multiplies it by g = 1 - c dx strain / influence, the symbol of A^-1 A'. Exact is
/// exp(i c theta), a translation by c towards the trailing edge.
class Amplification {
 public:
  Amplification(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                double step_ratio);

  /// \param theta  in [pi/64, pi]
  std::complex<double> operator()(double theta) const;

 private:
  Symbol strain_;
  Symbol influence_;
  double length_;  ///< c dx
};

/// The least |symbol| over the frequencies [pi/64, pi]: 0 means that the strain cannot see one.
double least_magnitude(const Symbol& symbol);

}  // namespace microslip
