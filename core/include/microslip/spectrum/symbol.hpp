// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <vector>

#include "microslip/halfspace/kernel.hpp"
#include "microslip/halfspace/shape_function.hpp"

namespace microslip {

/// Fourier symbol of the strain operator (A - A') / (c dx) on an unbounded uniform grid: what it
/// does to the traction exp(i k theta), k counting the nodes.  [mm^2/N]
class Symbol {
 public:
  /// \param step_ratio  c, >= min_step_ratio
  Symbol(const Kernel& kernel, const ShapeFunction& shape, double spacing, double step_ratio);

  /// \param theta  in [pi/64, pi]
  /// The coefficients fall off as 1/k only; multiplied by (e^(i theta) - 1)^4 they fall off as
  /// k^-5. Accuracy: 1e-6 at pi/64, 1e-9 from pi/16, tests/unit/spectrum_test.cpp
  std::complex<double> operator()(double theta) const;

 private:
  std::vector<double> differences_;  ///< fourth differences of the coefficients
};

/// The least |symbol| over the frequencies [pi/64, pi]: 0 means that the strain cannot see one.
double least_magnitude(const Symbol& symbol);

}  // namespace microslip
