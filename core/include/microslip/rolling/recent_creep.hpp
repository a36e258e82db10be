// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace microslip {

/// Creep, the integral of the creepage over the distance, over the last element that was travelled.
class RecentCreep {
 public:
  /// \param element  dx  [mm]
  explicit RecentCreep(double element);

  /// Nothing rolled.
  void start();

  /// A step was made. Nothing is allocated.
  void include(double length, double creepage);

  /// Mean of the creepage over the last element's travel if this step is made, too: over the step
  /// itself if it is longer, and over the distance from the start if that is shorter. Creep is
  /// taken as linear between points that are an element's thousandth apart, or a step.
  double mean_with(double length, double creepage) const;

  /// Writes or reads the points.
  void archive(class Archive& archive);

 private:
  struct Point {
    double distance;  ///< backwards from now  [mm]
    double creep;     ///< from there up to now  [mm]
  };

  double element_;
  std::vector<Point> points_;  ///< the farthest first, and one of them an element away or farther
};

}  // namespace microslip
