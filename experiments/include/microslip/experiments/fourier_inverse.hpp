// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "microslip/halfspace/kernel.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Why does the inverse of B = A - A' oscillate? The study measures the accuracy of its
/// approximation by Fourier transformation. Thesis 6.3, Figs. 6.7 and 6.8, for constant and linear
/// functions.
struct FourierInverseParameters {
  Kernel kernel;
  std::string basis{};                ///< of the tables: constant, linear or both; claims take both
  double spacing = 0;                 ///< dx, in (0, inf)  [mm]
  Eigen::Index elements = 0;          ///< size of the matrices shown, in [4, 10000]
  std::vector<double> step_ratios{};  ///< c, each >= 1e-15; the first large, the last small  [1]
  std::vector<Eigen::Index> sizes{};  ///< sizes for the errors, each in [4, 10000]
};

/// The keys that `fourier_inverse --print-keys` lists, each checked against its listed range.
FourierInverseParameters read_fourier_inverse(Scene& scene);

/// Tables: coefficients (steps 3 and 4), columns (step 6 and the exact inverse), errors (against
/// the exact inverse for rising sizes, with and without the boundary), claims.
std::vector<Table> fourier_inverse(const FourierInverseParameters& parameters,
                                   const Progress& progress);

}  // namespace microslip::experiments
