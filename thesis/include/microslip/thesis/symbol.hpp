// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <vector>

#include "microslip/halfspace/kernel.hpp"
#include "microslip/halfspace/shape_function.hpp"

namespace microslip {

/// Fourier symbol of an operator on an unbounded uniform grid: the factor by which it multiplies
/// the traction exp(i k theta), where k counts the nodes. The coefficients next to the node are
/// summed directly, and the coefficients beyond by the Abel-Plana formula, along a line in the
/// complex plane on which they fall off exponentially.
class Symbol {
 public:
  /// The strain operator (A - A') / (c dx)  [mm^2/N]
  /// \param step_ratio  c, >= min_step_ratio
  static Symbol of_strain(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                          double step_ratio);

  /// The influence operator A  [mm^3/N]
  static Symbol of_influence(const Kernel& kernel, const ShapeFunction& shape, double spacing);

  /// \param theta  in [1e-6, pi]
  /// Accuracy: strain 5e-13, of the largest coefficient where it is more than the symbol, for c
  /// from 1e-12 to 6; influence 1e-13 relative from 1e-3 on, less in proportion to theta below;
  /// strips from 0.1 dx to 1e4 dx and plane strain. tests/digits/spectrum_test.cpp
  std::complex<double> operator()(double theta) const;

 private:
  Symbol(const Kernel& kernel, const ShapeFunction& shape, double spacing, double step_ratio);

  /// The coefficients at distances from first_ elements on, to one side of the node.
  struct Side {
    double first;                              ///< the coefficient there
    std::vector<std::complex<double>> values;  ///< its continuation to first_ + i y
  };

  std::complex<double> sum(const Side& side, double theta) const;

  int first_;
  std::vector<double> near_;               ///< coefficients from 1 - first_ to first_ - 1
  std::vector<double> heights_, weights_;  ///< y and the weights of its quadrature
  Side ahead_, behind_;
  double influence_spacing_ = 0;  ///< dx if it is the symbol of A, else 0
};

/// Amplification of the traction exp(i k theta) in adhesion by a step of the direct scheme, the
/// factor \f$ 1-c\,\Delta x\,\hat\varepsilon/\hat A \f$, the symbol of A^-1 A',
/// from the symbols of strain and influence. The exact factor is \f$ e^{ic\theta} \f$, a
/// translation by c towards the trailing edge.
class Amplification {
 public:
  Amplification(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                double step_ratio);

  /// \param theta  in [1e-6, pi]
  std::complex<double> operator()(double theta) const;

 private:
  Symbol strain_;
  Symbol influence_;
  double length_;  ///< c dx
};

/// The least |symbol| over the frequencies [pi/64, pi]: 0 means that the strain does not respond to
/// one of these frequencies.
double least_magnitude(const Symbol& symbol);

}  // namespace microslip
