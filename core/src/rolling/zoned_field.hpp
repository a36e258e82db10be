// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "stick_zones.hpp"

namespace microslip {

/// Tractions, slip and displacement of given stick zones, under a positive creepage, with tractions
/// counted as positive.
class ZonedField {
 public:
  /// \param zones  with StickZones::for_places; none in full sliding
  /// \param level  creepage over k  [N/mm^2]
  ZonedField(StickZones zones, double level);

  const StickZones& zones() const { return zones_; }
  double level() const { return level_; }                        ///< creepage over k  [N/mm^2]
  double creepage() const;                                       ///< [1]
  double traction(double x) const;                               ///< [N/mm^2]
  double slip(double x) const;                                   ///< [1]
  Eigen::VectorXd displacement(const Eigen::VectorXd& x) const;  ///< at ascending places  [mm]

  /// The strain over k that the smooth part of a strip's kernel adds to plane strain  [N/mm^2]
  double regular_strain(double x) const;

  /// The zones with the parts that break the conditions as zones of their own; none if there is no
  /// such part.
  std::optional<std::vector<ZoneEnds>> repaired() const;

  /// Sums over all Gauss points, for evidence.
  struct Sums {
    double excess = 0;      ///< force above the bound  [N/mm]
    double backward = 0;    ///< power gained by slip in the wrong direction  [N/mm]
    double dissipated = 0;  ///< [N/mm]
  };
  Sums sums() const;

 private:
  double slip_over_k(const BoundaryPlace& place) const;

  StickZones zones_;
  double level_;
  StickZones::Points stick_;
  Eigen::ArrayXd traction_;              ///< P at the stick points  [N/mm^2]
  std::optional<SlidingField> sliding_;  ///< in plane strain; none for a table
};

}  // namespace microslip
