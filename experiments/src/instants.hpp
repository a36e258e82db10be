// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "microslip/scene/table.hpp"

namespace microslip::experiments {

/// Where a run is at the end of a step.
struct RunPlace {
  double distance;             ///< rolled, along the way  [mm]
  double position;             ///< of the bodies  [mm]
  std::optional<double> time;  ///< [s]
};

/// Tables at instants of a run, one below the other.
class InstantTables {
 public:
  /// \param steps  numbers of the steps at whose ends there are tables, rising; 0 is the start
  /// \param turns  whether the bodies turn or stand, so that places need the distance, too
  InstantTables(std::vector<std::size_t> steps, bool turns)
      : steps_(std::move(steps)), turns_(turns) {}

  bool wants(std::size_t step) const;

  /// Takes the tables after a step that is wanted, or after a shift behind it: the last ones of a
  /// step count. Its table `traction` becomes `instants`, and `edges` becomes `instants_edges`.
  void take(std::size_t step, const RunPlace& place, const std::vector<Table>& tables);

  /// Adds the tables; none if no step is wanted.
  void add_to(std::vector<Table>& tables);

 private:
  struct Pending {
    std::size_t step;
    RunPlace place;
    std::vector<Table> tables;
  };

  void write_pending();

  std::vector<std::size_t> steps_;
  bool turns_;
  double written_ = 0;
  std::optional<Pending> pending_;
  std::vector<Table> tables_;
};

}  // namespace microslip::experiments
