// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a contact patch: the start, the load and the lengths of steps.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "few_steps.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "patch_parts.hpp"

namespace microslip {

namespace {

/// A component's keys of shifts before rolling.
struct ShiftKeys {
  const char* motion;
  const char* resultant;
};

constexpr std::array<ShiftKeys, 3> shift_components{{
    {"start.shift", "start.force"},
    {"start.lateral_shift", "start.lateral_force"},
    {"start.rotation", "start.spin_moment"},
}};

/// The residual at which steps end, over the bound.
constexpr double residual_of_steps = 1e-9;

/// Calls an action; a message about a component is then about its key.
/// \param names  of the component's motion or resultant in `load`
template <class Action, class Name>
void with_names(const PatchLoad& load, const Action& action, const Name& name) {
  try {
    action();
  } catch (const BadParameter& error) {
    for (std::size_t j = 0; j < load.size(); ++j) {
      const std::string known = name_of(load, j);
      if (error.name() != known) continue;
      throw BadParameter(name(j), name(j) + std::string(error.what()).substr(known.size()));
    }
    throw;
  }
}

void require_lengths(const std::vector<double>& numbers, const std::string& key,
                     const std::vector<double>& first, const std::string& first_key) {
  require(numbers.size() == first.size(), key, numbers.front(), [&] {
    return fmt::format("{} number{}, as {} has", first.size(), first.size() == 1 ? "" : "s",
                       first_key);
  });
}

/// The resultants of the load, to which the bodies are shifted.
PatchLoad shift_to(Scene& scene, const PatchLoad& load) {
  PatchLoad shift;
  bool has_resultant = false;
  for (std::size_t j = 0; j < load.size(); ++j) {
    if (!load[j].by_resultant) continue;
    shift[j] = load[j];
    has_resultant = true;
  }
  if (!has_resultant) {
    scene.one_of({"start.force", "start.lateral_force", "start.spin_moment", "start.shift",
                  "start.lateral_shift", "start.rotation"});
  }
  return shift;
}

std::vector<PatchLoad> read_patch_shifts(Scene& scene, const PatchBound& bound,
                                         const PatchLoad& load) {
  std::array<std::string, 3> given;
  std::string first_key;
  std::vector<double> first;
  std::vector<PatchLoad> shifts;
  for (std::size_t j = 0; j < given.size(); ++j) {
    const auto& [motion, resultant] = shift_components[j];
    given[j] = scene.at_most_one_of({motion, resultant});
    if (given[j].empty()) continue;
    const std::vector<double> numbers = scene.numbers(given[j]);
    if (first.empty()) {
      first = numbers;
      first_key = given[j];
      shifts.resize(first.size());
    }
    require_lengths(numbers, given[j], first, first_key);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      shifts[k][j] = {.by_resultant = given[j] == resultant, .value = numbers[k]};
    }
  }
  if (shifts.empty()) return {shift_to(scene, load)};
  for (const PatchLoad& shift : shifts) {
    with_names(
        shift, [&] { validate(shift, bound.total(), bound.turning_moment()); },
        [&](std::size_t j) { return given[j]; });
  }
  return shifts;
}

std::vector<PatchLoad> read_patch_start(Scene& scene, const PatchBound& bound,
                                        const PatchLoad& load) {
  const std::string type = scene.word("start.type");
  if (type == "rest") return {};
  if (type == "cattaneo") return read_patch_shifts(scene, bound, load);
  reject("start.type", type, "rest or cattaneo, as the contact has three dimensions");
}

void warn_of_sudden_resultants(Scene& scene, const PatchLoad& load, double first_step) {
  if (scene.word("start.type") != "rest") return;
  for (std::size_t j = 0; j < load.size(); ++j) {
    const auto& [by_resultant, value] = load[j];
    if (!by_resultant || value == 0) continue;
    scene.warn(patch_components[j].resultant, value,
               fmt::format("from a start at rest, it is reached over the first step, of {} mm; "
                           "start.type cattaneo starts under it",
                           format_roughly(first_step)));
  }
}

/// Refuses steps that PatchRolling does not take.
void require_step_lengths(const PatchTransient& read) {
  const double c = read.patch.bound.size(), dx = read.spacing();
  const double least = 1e-6 * (c + read.distance), most = 1e6 * c;
  for (const double ratio : read.step_ratios) {
    require(ratio * dx >= least && ratio * dx <= most, "step.ratio", ratio, [&] {
      return fmt::format("a number from {} to {}, by the size of the contact and the distance",
                         format_roughly(least / dx), format_roughly(most / dx));
    });
  }
  const double last = last_step(read.distance, read.step_lengths());
  require(last >= least, "motion.distance", read.distance, [&] {
    return fmt::format("another distance: the last step would be {} mm long, shorter than {} mm",
                       format_roughly(last), format_roughly(least));
  });
}

}  // namespace

double PatchTransient::spacing() const {
  return 2 * patch.bound.half_width() / static_cast<double>(patch.elements);
}

std::vector<double> PatchTransient::step_lengths() const {
  std::vector<double> lengths = step_ratios;
  for (double& length : lengths) length *= spacing();
  return lengths;
}

PatchTransient read_patch_transient(Scene& scene) {
  SteadyPatch patch = read_unloaded_patch(scene);
  patch.accepted.residual = residual_of_steps;
  const std::string scheme = scene.word("step.scheme");
  if (scheme != "remembered") {
    reject("step.scheme", scheme, "remembered, as the contact has three dimensions");
  }
  if (!has_patch_load(scene)) scene.one_of(keys_of_patch_loads());  // says which are missing
  patch.load = read_patch_load(scene, patch.bound);
  validate(patch);
  warn_of_large_creepages(scene, patch);
  PatchTransient read{.patch = patch, .loads = patch.load};
  read.step_ratios = read_step_ratios(scene);
  read.shifts = read_patch_start(scene, patch.bound, patch.load);
  read.distance = read_distance(scene, read.loads.distance());
  const double mean = std::accumulate(read.step_ratios.begin(), read.step_ratios.end(), 0.0) /
                      static_cast<double>(read.step_ratios.size());
  require_few_steps(read.distance, 0, mean * read.spacing(), [] { return ""; });
  require_step_lengths(read);
  warn_of_sudden_resultants(scene, patch.load, read.step_lengths().front());
  return read;
}

}  // namespace microslip
