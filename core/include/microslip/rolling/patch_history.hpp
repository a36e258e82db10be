// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "microslip/patch/patch_load.hpp"
#include "microslip/rolling/load_history.hpp"

namespace microslip {

/// The load of a patch that changes on the way: each component is a motion or a resultant, and
/// linear between the same rows.
class PatchHistory {
 public:
  /// A constant load.
  PatchHistory(const PatchLoad& constant);

  /// \param components  along the rolling, across it and about the normal; of equal rows. A creepage
  ///                    is a motion, a force a resultant. The first one has the contact
  explicit PatchHistory(const std::array<LoadHistory, 3>& components);

  /// The distance from the first row to the last; infinite for a constant load  [mm]
  double distance() const { return rows().distance(); }

  /// Distances of the rows, from 0 on; none for a constant load  [mm]
  const std::vector<double>& distances() const { return rows().distances(); }

  /// The load at a distance within the rows  [mm]
  PatchLoad at(double distance) const;

  /// The load of a step: exact means of motions over the step, and resultants at its end.
  /// \param from, to  distances from the first row, in [0, distance()], from < to  [mm]
  PatchLoad between(double from, double to) const;

  /// The time at a distance, if the rows have times  [s]
  std::optional<double> time_at(double distance) const { return rows().time_at(distance); }

  /// Whether the rows have columns of the contact.
  bool changes_contact() const { return rows().changes_contact(); }

  /// Whether the contact has another size in some row than in the first.
  bool changes_size() const;

  /// The contact at a distance within the rows; the problem's contact if the rows have none.
  ContactScale contact_at(double distance) const { return rows().contact_at(distance); }

  /// The first component, with distances, times and the contact of all.
  const LoadHistory& rows() const { return components_[0]; }

 private:
  std::array<LoadHistory, 3> components_;
};

}  // namespace microslip
