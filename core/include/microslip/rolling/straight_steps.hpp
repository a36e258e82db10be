// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "microslip/rolling/load_history.hpp"

namespace microslip {

/// How far a load may be from the straight line through its values at both ends of a step. A
/// creepage is taken by its integral, the rigid shift.
struct LoadTolerance {
  double shift;    ///< of a creepage, > 0  [mm]
  double force;    ///< of a force, > 0  [N/mm]
  double contact;  ///< of half-width and bound over those of the problem, > 0  [1]
};

/// Long steps over which a load is straight within a tolerance: a step knows the mean of the
/// creepage, and force and contact at its end. They do not depend on how far the contact rolls, so
/// that a run in parts takes the steps of one run. They end at rows or, where a load bends between
/// rows, at dyadic fractions of them.
/// Cost: linear in the number of rows, for each of which a few values of the load are taken.
/// \param loads    with rows
/// \param longest  of the steps, > 0; may be infinite  [mm]
/// \param most     steps, or one more
/// \return lengths, of which the sum is loads.distance(); none if there are more than most  [mm]
std::optional<std::vector<double>> straight_steps(const LoadHistory& loads,
                                                  const LoadTolerance& tolerance, double longest,
                                                  std::size_t most);

}  // namespace microslip
