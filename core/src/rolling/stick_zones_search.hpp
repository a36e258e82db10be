// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "stick_zones.hpp"

namespace microslip {

/// A prescribed force or creepage, in absolute value.
struct ZonesLoad {
  std::optional<double> force;  ///< [N/mm]
  std::optional<double> level;  ///< creepage over k  [N/mm^2]
};

/// A smooth strain over k that is added to plane strain; empty without one.
struct AddedStrain {
  std::shared_ptr<const ChebyshevSeries> series;
  Eigen::Index terms = 0;  ///< that resolve it in a zone without neighbours
};

/// Given zones, with the strain.
StickZones zones_with(const std::shared_ptr<const ZonedContact>& contact,
                      const std::vector<ZoneEnds>& zones, const AddedStrain& strain, int refined);

/// Moves the ends of zones until levels, load and leading roots are met: each leading end by a
/// bracket on its own condition, then Newton's method on all ends. Zones that shrink to nothing are
/// dropped.
/// \param zones  in: ascending, disjoint, close to the solution; out: the solution
/// \return whether there is one; the contact conditions between the ends are not checked
bool move_ends(const std::shared_ptr<const ZonedContact>& contact, const ZonesLoad& load,
               const AddedStrain& strain, std::vector<ZoneEnds>& zones);

/// Finds zones from a guess that has the right number of zones or is close to it. Parts that break
/// the contact conditions become zones, and the search goes on.
/// \return zones that meet all conditions, with `StickZones::for_places`; none if they are not
///         found
std::optional<StickZones> find_stick_zones(const std::shared_ptr<const ZonedContact>& contact,
                                           const ZonesLoad& load, std::vector<ZoneEnds> guess,
                                           const AddedStrain& strain = {});

}  // namespace microslip
