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

  /// Distances of the rows of the file alone  [mm]
  std::vector<double> row_distances() const { return rows().row_distances(); }

  /// The load and the contact of a row, as LoadHistory::of_row().
  PatchLoad of_row(std::size_t row) const;
  ContactScale contact_of_row(std::size_t row) const { return rows().contact_of_row(row); }

  /// The load at a distance within the rows  [mm]
  PatchLoad at(double distance) const;

  /// Distances at which the bodies turn or are shifted, ascending; steps end there  [mm]
  const std::vector<double>& stops() const { return stops_; }

  /// Distances at which a step has to end, as LoadHistory has them.
  std::vector<double> ends_of_steps() const;

  /// A shift without rolling: shifts [mm] and a rotation [rad] in the place of motions, or
  /// resultants at its end.
  struct Standing {
    PatchLoad load;
    std::optional<ContactScale> contact;  ///< at the end, if the rows have it
    std::optional<double> time;           ///< at the end, if the rows have times  [s]
  };

  /// The shifts at a distance, in turn.
  std::vector<Standing> standing_at(double distance) const;

  /// The load of a step: exact means of motions over the step, and resultants at its end.
  /// \param from, to  distances from the first row, in [0, distance()], from < to  [mm]
  PatchLoad between(double from, double to) const;

  /// Direction and place along the way, as LoadHistory has them.
  int direction_to(double distance) const { return rows().direction_to(distance); }
  double position_at(double distance) const { return rows().position_at(distance); }

  /// The time at which a distance is reached, if the rows have times  [s]
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
  std::vector<double> stops_;
};

}  // namespace microslip
