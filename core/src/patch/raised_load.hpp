// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "microslip/patch/patch_load.hpp"

namespace microslip {

/// Raises a load from 0 by parts, which are doubled where one is solved and halved where not, for
/// methods that need a start nearby.
/// \param solves  whether a load is solved, from the last one that was
/// \returns the part of the load that was reached: 1 if it is all of it
template <class Solves>
double raise_load(const PatchLoad& load, const Solves& solves) {
  constexpr double first_step = 0.25, least_step = 1.0 / 64;
  double reached = 0, step = first_step;
  while (reached < 1 && step >= least_step) {
    const double next = std::min(1.0, reached + step);
    PatchLoad part = load;
    for (PatchComponent& component : part) component.value *= next;
    if (solves(part)) {
      reached = next;
      step *= 2;
    } else {
      step /= 2;
    }
  }
  return reached;
}

}  // namespace microslip
