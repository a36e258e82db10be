// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "microslip/rolling/steady.hpp"
#include "unlike_zones.hpp"

namespace microslip {

/// The load, in the units of UnlikeZones.
struct ScaledLoad {
  std::optional<double> force;  ///< none if the creepage is prescribed
  double ratio;                 ///< beta/mu
};

/// Returns the zones of a solution by elements, with a stick zone between slip in both directions.
/// \param ratio  beta/mu
ZonePattern pattern_of(const SteadySolution& solution, double half_width, double ratio);

/// Finds the zones of a load between bodies of different material, by Newton's method for the ends
/// of all zones. Where a traction is then above the bound, or slip has the wrong direction, a zone
/// is added, until there are no such places. Zones next to an edge that are shorter than 1e-7 of
/// the half-width do not count.
/// \param pattern  the first zones
/// \param level    the first level; if the creepage is prescribed, the level of the solution
/// \return none if no zones meet the conditions
std::optional<UnlikeZones> find_zones(const ScaledLoad& load, ZonePattern pattern, double level);

}  // namespace microslip
