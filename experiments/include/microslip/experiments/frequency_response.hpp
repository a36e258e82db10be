// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/kernel.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Response of the force to a small harmonic creepage or a small step, in closed form and by the
/// transient schemes of the catalogue.
struct FrequencyResponseParameters {
  HertzBound bound;
  PlaneKernel plane;
  StripKernel strip;
  double period = 0;                        ///< common period of all waves  [mm]
  std::vector<Eigen::Index> waves{};        ///< wave numbers: waves in the period, each 1 to 64
  double amplitude = 0;                     ///< of all waves over the creepage of a state, (0, 0.1]
  double adhesion_amplitude = 0;            ///< the same over the creepage of full sliding
  std::vector<Eigen::Index> sizes{};        ///< N for full adhesion, 3 to 2000, at least two
  std::vector<double> stick_ratios{};       ///< a' of Carter's states, each in [0.1, 0.99]
  std::vector<Eigen::Index> state_sizes{};  ///< N for these states; c != 1 has the first two
  int alignments = 0;                       ///< of the stick-slip point in an element, 1 to 20
  std::vector<double> step_ratios{};        ///< c, each in [0.01, 1], the first one 1
  std::vector<Eigen::Index> motion_sizes{};  ///< N of the steps, at least two
  double shortest = 0, longest = 0;          ///< wavelengths of the curves  [mm]
  int points = 0;                            ///< number of points of the curves, 2 to 10000
  double operations = 0;                     ///< a run that is expected to take more is left out
};

/// The keys that `frequency_response --print-keys` lists, each checked against its listed range.
FrequencyResponseParameters read_frequency_response(Scene& scene);

/// The ratio of dF/dw of a foundation of springs to its value for an infinite wavelength,
/// (1 - (1 - exp(-2 i kappa))/(2 i kappa))/(i kappa), where everything sticks.
/// \param kappa  2 pi a/L, in (0, inf); 1e-9 from 1e-6 on
std::complex<double> winkler_response(double kappa);

/// Tables: curves (exact H against the wavelength), measured (H and its error by each scheme),
/// errors (of H, against N), orders (fitted to these errors), steps (force and creepage after a
/// small step), step_errors, claims.
std::vector<Table> frequency_response(const FrequencyResponseParameters& parameters,
                                      const Progress& progress);

}  // namespace microslip::experiments
