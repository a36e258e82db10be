// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "microslip/rolling/steady.hpp"
#include "stick_zones.hpp"

namespace microslip {

/// The load in the units of StickZones.
struct ScaledLoad {
  std::optional<double> force;  ///< none if the creepage is prescribed
  double ratio;                 ///< beta/mu
};

/// The zones of elements, with stick between slip in both directions.
/// \param ratio  beta/mu
ZonePattern pattern_of(const SteadySolution& solution, double half_width, double ratio);

/// Finds the ends of zones by Newton's method. Where a traction is above the bound then, or slip
/// has the wrong direction, a zone is added, until there are no such places. Zones shorter than 1e-7
/// of the half-width, next to an edge, are none.
/// \param pattern  to begin with
/// \param level    to begin with; that of the solution if the creepage is prescribed
/// \return none if no zones meet the conditions
std::optional<StickZones> find_zones(const ScaledLoad& load, ZonePattern pattern, double level);

}  // namespace microslip
