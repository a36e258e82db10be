// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/patch_history.hpp"

#include <algorithm>
#include <cstddef>

namespace microslip {

namespace {

LoadHistory constant_component(const PatchComponent& component) {
  if (component.by_resultant) return PrescribedForce{component.value};
  return PrescribedCreepage{component.value};
}

/// \param load  of a component, a function of its history
template <class LoadOf>
PatchLoad patch_load(const std::array<LoadHistory, 3>& components, const LoadOf& load) {
  PatchLoad found;
  for (std::size_t j = 0; j < found.size(); ++j) {
    const Prescribed prescribed(load(components[j]));
    found[j] = {.by_resultant = prescribed.by_force, .value = prescribed.value};
  }
  return found;
}

}  // namespace

PatchHistory::PatchHistory(const PatchLoad& constant)
    : components_{constant_component(constant[0]), constant_component(constant[1]),
                  constant_component(constant[2])} {}

PatchHistory::PatchHistory(const std::array<LoadHistory, 3>& components)
    : components_(components) {}

bool PatchHistory::changes_size() const {
  if (!changes_contact()) return false;
  const double first = contact_at(0).half_width;
  return std::ranges::any_of(
      distances(), [&](double distance) { return contact_at(distance).half_width != first; });
}

PatchLoad PatchHistory::at(double distance) const {
  return patch_load(components_, [&](const LoadHistory& of) { return of.at(distance); });
}

PatchLoad PatchHistory::between(double from, double to) const {
  return patch_load(components_, [&](const LoadHistory& of) { return of.between(from, to); });
}

}  // namespace microslip
