// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Which forces do small creepages and spin of a contact ellipse make? Kalker's coefficients by
/// Galin's theorem, the errors of joined rows and of the standard scheme, and the table that Kalker
/// printed.
struct KalkerCoefficientsParameters {
  std::vector<double> aspects{};            ///< a/b
  std::vector<double> poisson_ratios{};     ///< nu
  Eigen::Index elements = 0;                ///< joined rows, and cells of each
  std::vector<double> converged_aspects{};  ///< a/b of the convergence
  double poisson_ratio = 0;                 ///< of the convergence
  std::vector<Eigen::Index> sizes{};        ///< joined rows, and cells of each, rising
  std::vector<Eigen::Index> rectangles{};   ///< N, rising
};

/// The keys that `kalker_coefficients --print-keys` lists, each checked against its listed range.
KalkerCoefficientsParameters read_kalker_coefficients(Scene& scene);

/// Tables: coefficients (with the printed ones), errors (joined rows and standard scheme), orders,
/// claims.
std::vector<Table> kalker_coefficients(const KalkerCoefficientsParameters& parameters,
                                       const Progress& progress);

}  // namespace microslip::experiments
