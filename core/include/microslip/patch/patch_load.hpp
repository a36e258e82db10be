// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace microslip {

/// Prescribes one component of rolling: its motion, and the resultant follows; or its resultant, and
/// the motion follows.
struct PatchComponent {
  bool by_resultant = false;
  double value = 0;  ///< xi, eta [1] or phi [1/mm]; Fx, Fy [N] or Mz about the centre [N mm]

  bool operator==(const PatchComponent&) const = default;
};

/// The load of a patch that rolls: along the rolling, across it, and about the normal. A positive
/// creepage gives a negative force, and so does a positive spin on its own give a negative moment.
using PatchLoad = std::array<PatchComponent, 3>;

/// The name of the prescribed quantity in messages.
/// \param j  0, 1 or 2
inline const char* name_of(const PatchLoad& load, std::size_t j) {
  constexpr std::array<const char*, 3> motions{"creepage", "lateral_creepage", "spin"};
  constexpr std::array<const char*, 3> resultants{"force", "lateral_force", "spin_moment"};
  return (load[j].by_resultant ? resultants : motions)[j];
}

}  // namespace microslip
