// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/patch_history.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

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

PatchHistory::PatchHistory(const std::array<LoadHistory, 3>& components) : components_(components) {
  for (const LoadHistory& component : components_) {
    stops_.insert(stops_.end(), component.stops().begin(), component.stops().end());
  }
  std::ranges::sort(stops_);
  stops_.erase(std::unique(stops_.begin(), stops_.end()), stops_.end());
}

std::vector<double> PatchHistory::ends_of_steps() const {
  std::vector<double> ends;
  std::ranges::set_union(stops_, rows().ends_of_steps(), std::back_inserter(ends));
  return ends;
}

bool PatchHistory::changes_size() const {
  if (!changes_contact()) return false;
  const double first = contact_at(0).half_width;
  return std::ranges::any_of(
      rows().contacts(), [&](const ContactScale& contact) { return contact.half_width != first; });
}

PatchLoad PatchHistory::of_row(std::size_t row) const {
  return patch_load(components_, [&](const LoadHistory& of) { return of.of_row(row); });
}

std::vector<PatchHistory::Standing> PatchHistory::standing_at(double distance) const {
  std::array<std::vector<LoadHistory::Standing>, 3> parts;
  for (std::size_t j = 0; j < parts.size(); ++j) parts[j] = components_[j].standing_at(distance);
  std::vector<Standing> found;
  for (std::size_t i = 0; i < parts[0].size(); ++i) {
    Standing standing{.load = {}, .contact = {}, .time = parts[0][i].time};
    if (changes_contact()) standing.contact = parts[0][i].contact;
    bool changes = false;
    for (std::size_t j = 0; j < parts.size(); ++j) {
      const Prescribed prescribed(parts[j][i].load);
      standing.load[j] = {.by_resultant = prescribed.by_force, .value = prescribed.value};
      changes = changes || parts[j][i].changes;
    }
    if (changes) found.push_back(standing);
  }
  return found;
}

PatchLoad PatchHistory::at(double distance) const {
  return patch_load(components_, [&](const LoadHistory& of) { return of.at(distance); });
}

PatchLoad PatchHistory::between(double from, double to) const {
  return patch_load(components_, [&](const LoadHistory& of) { return of.between(from, to); });
}

}  // namespace microslip
