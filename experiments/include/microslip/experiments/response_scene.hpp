// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "microslip/rolling/target_error.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// The response of the force of a scene to a small harmonic creepage.
struct ResponseScene {
  SteadyContact contact;
  std::optional<double> shortest;  ///< wavelength [mm]; none for 0.3 half-lengths of the stick zone
  std::optional<double> longest;   ///< likewise; none for 300
  Eigen::Index wavelengths;        ///< 2 to 100 000
};

/// All keys of a steady or transient scene, and response.shortest, response.longest,
/// response.wavelengths (60). Method, grid, steps and start have no part in it.
/// \throws std::invalid_argument for a cylinder, which has no load
ResponseScene read_response(Scene& scene);

/// Tables: response (dF/dw against the wavelength) and summary, about the steady state by
/// inversion.
///
/// \throws std::invalid_argument without a stick zone, and with more zones than the inversion takes
std::vector<Table> response_tables(const ResponseScene& scene, const Progress& progress);

}  // namespace microslip::experiments
