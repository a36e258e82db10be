// SPDX-License-Identifier: GPL-3.0-or-later
#include "slip_friction.hpp"

#include <string>
#include <vector>

#include "microslip/support/require.hpp"

namespace microslip {

namespace {

constexpr const char* law_key = "contact.friction_law";

FrictionLaw read_law(Scene& scene) {
  const std::string form = scene.word(law_key);
  if (form == "table") {
    const std::vector<FileColumn> wanted = {{"speed", "mm/s"}, {"ratio", "1"}};
    return scene.from_columns("contact.friction_file", wanted, [](const auto& columns) {
      return FrictionLaw(*columns[0], *columns[1]);
    });
  }
  const double kinetic = scene.number("contact.kinetic_ratio");
  const double half = scene.number("contact.half_speed");
  return {form == "linear"        ? FrictionLaw::Form::linear
          : form == "exponential" ? FrictionLaw::Form::exponential
                                  : FrictionLaw::Form::rational,
          kinetic, half};
}

/// \param speed  V of the rows of a run, if they have times  [mm/s]
SlipFriction read_friction_of(Scene& scene, const std::optional<double>& speed) {
  const FrictionLaw law = read_law(scene);
  SlipFriction friction{.law = law, .speed = speed ? *speed : scene.positive("load.speed")};
  if (scene.has("contact.friction_memory")) {
    friction.memory_length = scene.number("contact.friction_memory");
    friction.memory_speed = scene.number("contact.memory_speed");
  }
  friction.branch =
      scene.word("contact.slip_branch") == "least" ? SlipBranch::least : SlipBranch::most;
  validate(friction);
  return friction;
}

/// \param stops  whether the bodies turn or are shifted
std::optional<SlipFriction> read_friction_of_run(Scene& scene, const LoadHistory& loads,
                                                 bool stops) {
  if (!scene.has(law_key)) return std::nullopt;
  if (stops) {
    reject(law_key, scene.word(law_key),
           "none where the rows of load.file turn or shift the bodies");
  }
  if (!loads.time_at(0)) return read_friction_of(scene, std::nullopt);
  const double time = *loads.time_at(loads.distance()) - *loads.time_at(0);
  return read_friction_of(scene, loads.distance() / time);
}

}  // namespace

std::optional<SlipFriction> read_slip_friction(Scene& scene) {
  if (!scene.has(law_key)) return std::nullopt;
  return read_friction_of(scene, std::nullopt);
}

std::optional<SlipFriction> read_slip_friction(Scene& scene, const LoadHistory& loads) {
  return read_friction_of_run(scene, loads, !loads.stops().empty());
}

std::optional<SlipFriction> read_slip_friction(Scene& scene, const PatchHistory& loads) {
  return read_friction_of_run(scene, loads.rows(), !loads.stops().empty());
}

}  // namespace microslip
