// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/halfspace/kernel.hpp"
#include "microslip/halfspace/shape_function.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Which entries of M = A - A' survive a small step, and what does its inverse look like then?
/// Thesis Figs. 6.1-6.3. Entries are given in units of 2 (1 - nu) dx / G, so for plane strain they
/// depend on nothing but c, and for a strip on Dy/dx and nu besides.
struct WiggleSpectrumParameters {
  Kernel kernel;
  ShapeFunction shape;
  double spacing;                    ///< dx, in (0, inf)  [mm]
  Eigen::Index elements;             ///< size of the matrices shown, in [3, 1000]
  std::vector<double> step_ratios;   ///< c of the matrices shown, each in (0, inf)  [1]
  Eigen::Index samples;              ///< c = 1/samples ... 1 of the diagonals, in [1, 100000]
  std::vector<double> strip_widths;  ///< Dy/dx of further crossings, each in (0, inf)  [1]
};

/// material.*, kernel.*, basis, grid.spacing, grid.elements, step.ratios, step.samples,
/// crossing.strip_widths
WiggleSpectrumParameters read_wiggle_spectrum(Scene& scene);

/// Tables: matrix (every entry of M and its inverse for each step ratio), diagonals (M11, M21, M12
/// against c, as they are and scaled by the largest), crossing (c where M11 = M21).
std::vector<Table> wiggle_spectrum(const WiggleSpectrumParameters& parameters,
                                   const Progress& progress);

/// The step ratio in (0.001, 1) at which M11 = M21, to rounding.
double diagonal_crossing(const Kernel& kernel, const ShapeFunction& shape, double spacing);

}  // namespace microslip::experiments
