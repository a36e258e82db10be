// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/halfspace/kernel.hpp"
#include "microslip/halfspace/shape_function.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Which entries of B = A - A' remain for a small step, and what do the inverse, the eigenvalues
/// and the symbol of B look like then? Thesis Figs. 5.1, 6.1-6.6, for constant and linear
/// functions. Entries are in units of 2 (1 - nu) dx / G, so that in plane strain they depend on c
/// alone.
struct WiggleSpectrumParameters {
  Kernel kernel;
  double spacing = 0;                  ///< dx, in (0, inf)  [mm]
  Eigen::Index elements = 0;           ///< size of the matrices, in [3, 1000]
  std::vector<double> step_ratios{};   ///< c of the matrices shown  [1]
  double shift = 0;                    ///< of the functions shown, Fig. 5.1, in (0, 1)  [dx]
  Eigen::Index samples = 0;            ///< c = 1/samples ... 1 of the diagonals, in [1, 100000]
  double smallest_step_ratio = 0;      ///< of the spectra, in [1e-15, 1)  [1]
  Eigen::Index per_decade = 0;         ///< step ratios per decade of the spectra, in [1, 100]
  std::vector<double> strip_widths{};  ///< Dy/dx of further crossings, each in (0, inf)  [1]
};

/// The keys that `wiggle_spectrum --print-keys` lists, each checked against its listed range.
WiggleSpectrumParameters read_wiggle_spectrum(Scene& scene);

/// Tables: functions (Fig. 5.1), matrix (every entry of B and its inverse for each step ratio),
/// diagonals (B11, B21, B12 against c, unscaled and scaled by the largest), crossing (c where B11 =
/// B21), spectrum (condition number and least symbol against c, for an odd and an even number of
/// elements), eigenvalues, claims.
std::vector<Table> wiggle_spectrum(const WiggleSpectrumParameters& parameters,
                                   const Progress& progress);

/// The step ratio in (0.001, 1) at which B11 = B21, to rounding.
double diagonal_crossing(const Kernel& kernel, const ShapeFunction& shape, double spacing);

}  // namespace microslip::experiments
