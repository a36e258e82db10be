// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "microslip/linalg/solver.hpp"

namespace microslip {

/// What a result shows of its own correctness: by how much it misses the contact conditions.
struct Evidence {
  double residual = 0;  ///< slip left in adhesion, over the largest term of its equations [1]
  double bound_violation = 0;  ///< of |p| above the bound, over the largest bound  [1]
  double slip_violation = 0;   ///< of slip along the traction instead of against it, over the
                               ///< largest slip or the creepage  [1]

  /// The larger of the two.
  double violation() const { return std::max(bound_violation, slip_violation); }
};

/// The larger of each.
inline Evidence worst_of(const Evidence& a, const Evidence& b) {
  return {.residual = std::max(a.residual, b.residual),
          .bound_violation = std::max(a.bound_violation, b.bound_violation),
          .slip_violation = std::max(a.slip_violation, b.slip_violation)};
}

/// \param condition   of the equations in adhesion, estimate  [1]
/// \param iterations  for the message
/// \throws NotConverged if the evidence is worse than the solver accepts, naming what, by how much,
///                      and the key that accepts it
void require_evidence(const Evidence& evidence, double condition, int iterations,
                      const Solver& accepted);

}  // namespace microslip
