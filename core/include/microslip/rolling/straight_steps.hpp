// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "microslip/rolling/load_history.hpp"

namespace microslip {

/// Allowed distance of a load from the straight line through its values at both ends of a step. A
/// creepage is compared in terms of its integral, the rigid shift.
struct LoadTolerance {
  double shift;    ///< for a creepage, > 0  [mm]
  double force;    ///< for a force, > 0  [N/mm]
  double contact;  ///< for half-width and bound, over the problem's, > 0  [1]
};

/// Long steps over which a load is straight within a tolerance. A step only uses the mean of the
/// creepage, and force and contact at the end of the step. The steps do not depend on the distance
/// to roll, so that an interrupted run takes the steps of an uninterrupted one. Steps end at rows
/// or, where a load bends between rows, at dyadic fractions of the distance between rows. Cost: a
/// few values of the load for each row.
/// \param loads    with rows
/// \param longest  longest step, > 0; may be infinite  [mm]
/// \param most     the largest number of steps; one more is possible
/// \return lengths, which sum up to loads.distance(); none if there are more than `most`  [mm]
std::optional<std::vector<double>> straight_steps(const LoadHistory& loads,
                                                  const LoadTolerance& tolerance, double longest,
                                                  std::size_t most);

}  // namespace microslip
