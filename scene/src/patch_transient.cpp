// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a contact patch: the start, the load and the lengths of steps.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "doubts.hpp"
#include "few_steps.hpp"
#include "instants.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/patch/standard_patch.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "patch_files.hpp"
#include "patch_parts.hpp"
#include "patch_run.hpp"
#include "run_file.hpp"
#include "slip_friction.hpp"

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

/// \param load, contact  at the start
std::vector<PatchLoad> read_patch_shifts(Scene& scene, const SteadyPatch& patch,
                                         const PatchLoad& load, const ContactScale& contact) {
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
    with_names_of(
        shift,
        [&] {
          require_carried(shift, patch.bound, contact);
          require_motions(shift, patch, true);
        },
        [&](std::size_t j) { return given[j]; });
  }
  return shifts;
}

void read_patch_start(Scene& scene, PatchTransient& read) {
  const std::string type = scene.word("start.type");
  if (type == "rest") return;
  if (type == "cattaneo") {
    read.shifts = read_patch_shifts(scene, read.patch, read.loads.at(0), read.loads.contact_at(0));
    return;
  }
  if (type == "file") {
    read.start = read_start_tractions(scene, read.patch.bound, read.loads.contact_at(0));
    return;
  }
  if (!std::holds_alternative<Remembered>(read.scheme)) {
    reject("step.scheme", scene.text("step.scheme"), "remembered with start.type state");
  }
  scene.with_file("start.state", [&] {
    read.state = SavedState{scene.file("start.state")};
    read.from = distance_of(*read.state, read.patch);
  });
}

/// Forces and the moment of tractions in the contact at the start.
Eigen::Vector3d resultants_of(const TractionTable& tractions, const PatchBound& bound,
                              const ContactScale& contact) {
  const PatchShape& shape = bound.shape();
  const auto integral = [&](const auto& of) {
    return integral_over(shape, [&](std::size_t lobe, double psi, double theta) {
      const Lobe& in = shape.lobes()[lobe];
      const Lobe::Row row = in.row(psi);
      const double x = row.middle + row.half_length * std::cos(theta), y = in.y(psi);
      return bound(lobe, psi, theta) * of(x, y, tractions(x, y));
    });
  };
  using Pair = Eigen::Vector2d;
  const Eigen::Vector3d found(
      integral([](double, double, const Pair& p) { return p[0]; }),
      integral([](double, double, const Pair& p) { return p[1]; }),
      integral([](double x, double y, const Pair& p) { return x * p[1] - y * p[0]; }));
  const double force = contact.half_width * contact.half_width * contact.bound;
  return force * found.cwiseProduct(Eigen::Vector3d(1, 1, contact.half_width));
}

/// Warns of resultants that the start does not carry: those of a start at rest, and of tractions from
/// a file by more than 2 % of the largest.
void warn_of_sudden_resultants(Scene& scene, const PatchTransient& read) {
  constexpr double sudden = 0.02;
  const std::string type = scene.word("start.type");
  if (type != "rest" && type != "file") return;
  if (shifts_first(read.loads.stops())) return;
  const PatchLoad load = read.loads.at(0);
  const ContactScale contact = read.loads.contact_at(0);
  const Eigen::Vector3d largest = largest_resultants(read.patch.bound, contact);
  Eigen::Vector3d at_start = Eigen::Vector3d::Zero();
  if (read.start) at_start = resultants_of(*read.start, read.patch.bound, contact);
  for (std::size_t j = 0; j < load.size(); ++j) {
    const auto& [by_resultant, value] = load[j];
    const auto i = static_cast<Eigen::Index>(j);
    const double least = read.start ? sudden * largest[i] : 0;
    if (!by_resultant || std::abs(value - at_start[i]) <= least) continue;
    const std::string key = patch_components[j].resultant;
    const bool is_given = scene.has(key) || scene.has(patch_components[j].ratio);
    const std::string from = read.start
                                 ? fmt::format("the tractions of start.file, which carry {},",
                                               format_roughly(at_start[i]))
                                 : "a start at rest,";
    scene.warn(is_given ? key : key.substr(5) + " of load.file", value,
               fmt::format("from {} it is reached over the first step, of {} mm; start.type "
                           "cattaneo starts under it",
                           from, format_roughly(read.step_lengths().front())));
  }
}

/// \return dq/dx; of load.file without step.ratio from row to row
std::vector<double> read_patch_steps(Scene& scene, const PatchTransient& read) {
  const std::vector<double>& rows = read.loads.distances();
  if (scene.has("step.ratio") || rows.empty()) return read_step_ratios(scene);
  const auto steps = static_cast<double>(rows.size()) - 1;
  scene.with_file("load.file", [&] {
    if (steps > most_steps && !scene.has("motion.distance")) {
      throw std::invalid_argument(fmt::format("expected at most {} steps, and its rows make {:.0f}",
                                              format_short(most_steps), steps));
    }
  });
  return row_ratios(rows, read.spacing());
}

/// Whether a spin is so strong that the slip turns within the contact, or a moment so large.
bool has_strong_spin(const PatchTransient& read) {
  const PatchBound& bound = read.patch.bound;
  const double strain = bound.peak() / read.patch.material.shear_modulus;
  return std::ranges::any_of(read.loads.distances(), [&](double distance) {
    const auto [by_resultant, value] = read.loads.at(distance)[2];
    const double part =
        by_resultant ? 2 * value / bound.turning_moment() : value * bound.size() / strain;
    return std::abs(part) > 1;
  });
}

/// The longest steps in which forces are right to 1 % of the largest ones, over the least half-width.
/// At 0.9 a they have errors of 1 %, and creepages of 6 %. Where the size of a contact changes, steps
/// longer than a cell have the mean direction of the slip on their way: at 0.3 a and a strong spin
/// forces were off by 0.6 to 4 %, at 0.5 a by 1.3 to 13 %.
double longest_right_step(const PatchTransient& read, double least_half_width) {
  if (!read.loads.changes_size() || !has_strong_spin(read)) return 0.5 * least_half_width;
  return std::max(0.25 * least_half_width, 1.2 * read.spacing());
}

void warn_of_long_steps(Scene& scene, const PatchTransient& read) {
  double size = 1;
  for (const ContactScale& contact : read.loads.rows().contacts()) {
    if (contact.carries()) size = std::min(size, contact.half_width);
  }
  const double least = size * read.patch.bound.half_width();
  const double most = longest_right_step(read, least);
  const double longest = std::min(std::ranges::max(read.step_lengths()), read.distance);
  if (longest <= (1 + 1e-9) * most) return;
  const bool is_half = most == 0.5 * least;
  const bool by_rows = !scene.has("step.ratio");
  const std::string key = by_rows ? "load.file" : "step.ratio";
  scene.warn(key, scene.text(key),
             fmt::format("steps are up to {} mm long: above {} of the {}half-width, {} mm, "
                         "forces may have errors of more than 1 % of full sliding{}{}",
                         format_roughly(longest), is_half ? "half" : format_roughly(most / least),
                         size < 1 ? "least " : "", format_roughly(most),
                         is_half ? "" : " where a contact changes its size under a strong spin",
                         by_rows ? "; step.ratio 1 has steps of an element" : ""));
}

/// Refuses a step that ends so close to a place without contact that PatchRolling does not take it.
void require_contact_at(const PatchTransient& read, double distance) {
  using Ranges = PatchStepRanges;
  const ContactScale contact = read.loads.contact_at(distance);
  const double size = contact.half_width, bound = contact.bound;
  const bool is_small = size > 0 && size < Ranges::least_size;
  if (!is_small && !(bound > 0 && bound < Ranges::least_bound)) return;
  require(false, "step.ratio", read.step_ratios.front(), [&] {
    return fmt::format(
        "another one: a step would end at q = {} mm, next to where contact is lost, with {} of {}",
        format_roughly(read.loads.position_at(distance)), format_roughly(is_small ? size : bound),
        is_small ? "the half-widths of the scene" : "its bound");
  });
}

/// Refuses steps that PatchRolling does not take.
void require_step_lengths(const Scene& scene, const PatchTransient& read) {
  const double c = read.patch.bound.size(), dx = read.spacing();
  const double least = PatchStepRanges::least_step * c;
  const double most = PatchStepRanges::longest_step * c;
  for (const double ratio : read.step_ratios) {
    if (ratio * dx >= least && ratio * dx <= most) continue;
    if (scene.has("step.ratio")) {
      require(false, "step.ratio", ratio,
              fmt::format("a number from {} to {}, by the size of the contact",
                          format_roughly(least / dx), format_roughly(most / dx)));
    }
    scene.with_file("load.file", [&] {
      throw std::invalid_argument(fmt::format(
          "expected rows that are {} to {} mm apart, not {}; step.ratio makes other steps",
          format_roughly(least), format_roughly(most), format_roughly(ratio * dx)));
    });
  }
  double first = 0, last = 0, shortest = std::numeric_limits<double>::infinity();
  const bool changes = read.loads.changes_contact();
  for_steps(read.distance, read.step_lengths(), read.from, read.loads.ends_of_steps(),
            [&](double, double to, double length) {
              if (changes) require_contact_at(read, to);
              if (first == 0) first = length;
              last = length;
              shortest = std::min(shortest, length);
            });
  require(last >= least, "motion.distance", read.distance, [&] {
    return fmt::format("another distance: the last step would be {} mm long, shorter than {} mm",
                       format_roughly(last), format_roughly(least));
  });
  require(first >= least, "motion.distance of start.state", read.from, [&] {
    return fmt::format("the end of a step: the next step would be {} mm long, shorter than {} mm",
                       format_roughly(first), format_roughly(least));
  });
  require(shortest >= least, "step.ratio", read.step_ratios.front(), [&] {
    return fmt::format(
        "another one: a step that ends where the bodies turn, are shifted or part would be "
        "{} mm long, shorter than {} mm",
        format_roughly(shortest), format_roughly(least));
  });
}

AdvectionScheme read_patch_scheme(Scene& scene) {
  const std::string scheme = scene.word("step.scheme");
  if (scheme == "remembered") return Remembered{};
  if (scheme != "direct" && scheme != "relaxed") {
    reject("step.scheme", scheme,
           "remembered, direct or relaxed, as the contact has three dimensions");
  }
  for (const char* key : {patch_file, bound_file}) {
    if (!scene.has(key)) continue;
    reject("step.scheme", scheme,
           fmt::format("remembered with {}, as others have Hertz's bound", key));
  }
  if (scheme == "direct") return Direct{};
  return Relaxed{scene.positive("step.relaxation")};
}

void require_relaxation(const Scene& scene, const PatchTransient& read) {
  const auto* relaxed = std::get_if<Relaxed>(&read.scheme);
  if (relaxed == nullptr) return;
  require(relaxed->step_ratio <= StandardPatch::largest_relaxation, "step.relaxation",
          relaxed->step_ratio, "at most 1e6");
  const double most = std::ranges::max(read.step_ratios);
  if (is_within_relaxation(most, relaxed->step_ratio)) return;
  const bool has_ratio = scene.has("step.ratio");
  require(false, has_ratio ? "step.ratio" : "step.relaxation",
          has_ratio ? most : relaxed->step_ratio, [&] {
            return has_ratio ? "at most step.relaxation, " + format_short(relaxed->step_ratio)
                             : "at least the c of the steps from row to row of load.file, " +
                                   format_short(most);
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
  const AdvectionScheme scheme = read_patch_scheme(scene);
  const bool has_file = scene.has("load.file");
  if (!has_file && !has_patch_load(scene)) {
    std::vector<std::string> all = keys_of_patch_loads();
    all.emplace_back("load.file");
    scene.one_of(all);  // says which are missing
  }
  patch.load = read_patch_load(scene, patch.bound);
  warn_of_large_motions(scene, patch);
  PatchTransient read{.patch = patch, .scheme = scheme, .loads = patch.load};
  read.patch.load = {};
  validate(read.patch);
  if (has_file) {
    read.loads = read_patch_run(scene, patch, scheme);
  } else {
    validate(patch);
    require_motions(patch.load, patch);
  }
  if (std::holds_alternative<Remembered>(scheme)) {
    read.patch.friction = read_slip_friction(scene, read.loads);
  }
  read.step_ratios = read_patch_steps(scene, read);
  read_patch_start(scene, read);
  read.distance = read_distance(scene, read.loads.distance(), read.from);
  const double mean = std::accumulate(read.step_ratios.begin(), read.step_ratios.end(), 0.0) /
                      static_cast<double>(read.step_ratios.size());
  require_few_steps(read.distance, read.from, mean * read.spacing(), [] { return ""; });
  if (std::holds_alternative<Remembered>(scheme)) {
    require_step_lengths(scene, read);
  } else {
    require_relaxation(scene, read);
    const auto [least, most] = std::ranges::minmax(read.step_ratios);
    for (const double ratio : {least, most}) {
      warn_outside(scene, entry_of(scheme).safe_steps, "step.ratio", ratio,
                   "step.scheme remembered");
    }
  }
  const std::vector<double> lengths = read.step_lengths(), ends = read.loads.ends_of_steps();
  const RunSteps steps{read.distance, lengths, read.from, ends};
  read.instants = read_instants(scene, steps);
  const Eigen::Vector3d most = largest_resultants(read.patch.bound, {});
  warn_of_missed_rows(scene, steps, read.loads.rows(), [&](double at) {
    const PatchLoad there = read.loads.at(at);
    Eigen::Vector3d resultants = Eigen::Vector3d::Zero();
    for (std::size_t j = 0; j < there.size(); ++j) {
      const auto i = static_cast<Eigen::Index>(j);
      if (there[j].by_resultant) resultants[i] = there[j].value / most[i];
    }
    return resultants;
  });
  warn_of_long_steps(scene, read);
  warn_of_sudden_resultants(scene, read);
  return read;
}

}  // namespace microslip
