// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of a scene: in its keys, and with all keys that are missing.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "microslip/scene/keys.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/support/nearest.hpp"

namespace microslip {

namespace {

struct Argument {
  std::string_view name;  ///< the argument's name in errors of core
  std::string_view key;   ///< the key that gives the argument
};

constexpr auto arguments = std::to_array<Argument>({
    {"shear_modulus", "material.shear_modulus"},
    {"poisson_ratio", "material.poisson_ratio"},
    {"half_width", "contact.half_width"},
    {"peak_traction", "contact.peak_traction"},
    {"coefficients", "contact.bound_polynomial"},
    {"bound", "contact.bound_file"},
    {"amplitude", "contact.roughness"},
    {"hurst", "contact.hurst"},
    {"rows", "contact.rows"},
    {"friction_law", "contact.friction_law"},
    {"kinetic_ratio", "contact.kinetic_ratio"},
    {"half_speed", "contact.half_speed"},
    {"friction_memory", "contact.friction_memory"},
    {"memory_speed", "contact.memory_speed"},
    {"speed", "load.speed"},
    {"kernel", "kernel.type"},
    {"width", "kernel.width"},
    {"length", "kernel.length"},
    {"compliance", "kernel.compliance"},
    {"wave_number", "kernel.table"},
    {"elements", "grid.elements"},
    {"leading_offset", "grid.leading_offset"},
    {"trailing_offset", "grid.trailing_offset"},
    {"creepage", "load.creepage"},
    {"force", "load.force"},
    {"lateral_half_width", "contact.lateral_half_width"},
    {"lateral_creepage", "load.lateral_creepage"},
    {"lateral_force", "load.lateral_force"},
    {"spin", "load.spin"},
    {"spin_moment", "load.spin_moment"},
    {"step_ratio", "step.ratio"},
    {"relaxation", "step.relaxation"},
    {"scheme", "step.scheme"},
    {"mass", "cylinder.mass"},
    {"inertia", "cylinder.inertia"},
    {"cylinder radius", "cylinder.radius"},
    {"slope_force", "cylinder.slope_force"},
    {"velocity", "cylinder.velocity"},
    {"distance", "motion.distance"},
    {"motion tolerance", "motion.tolerance"},
    {"solver", "solver.type"},
    {"tolerance", "solver.tolerance"},
    {"violation", "solver.violation"},
    {"condition", "solver.condition"},
    {"shortest", "response.shortest"},
});

/// The same error of another name, if its message begins with the name.
BadParameter renamed(const BadParameter& error, const std::string& name) {
  const std::string message = error.what();
  if (!message.starts_with(error.name())) return error;
  return {name, name + message.substr(error.name().size())};
}

}  // namespace

BadParameter in_keys(const BadParameter& error) {
  const std::string& name = error.name();
  const std::size_t of = name.rfind(" of ");
  const std::size_t begin = of == std::string::npos ? 0 : of + 4;
  const auto found =
      std::ranges::find(arguments, std::string_view(name).substr(begin), &Argument::name);
  if (found == arguments.end()) return error;
  return renamed(error, name.substr(0, begin) + std::string(found->key));
}

BadParameter in_keys(const BadParameter& error, const Scene& scene) {
  const bool is_of_unknown = scene.has(error.name()) && scene.known(error.name()) == nullptr;
  const bool is_missing = std::string_view(error.what()).starts_with("missing key");
  if (const std::string misspelt = scene.misspelt();
      !misspelt.empty() && !is_of_unknown && !is_missing) {
    return {misspelt,
            fmt::format("unknown key '{}'{}", shown(misspelt), suggestion(likely_key(misspelt)))};
  }
  const BadParameter named = in_keys(error);
  constexpr std::string_view file = "contact.bound_file", roughness = "contact.roughness";
  const std::string& name = named.name();
  if (!name.ends_with(file) || !scene.has(std::string(roughness))) return named;
  return renamed(named, name.substr(0, name.size() - file.size()) + std::string(roughness));
}

namespace {

std::string quoted_alternatives(const std::vector<std::string>& keys) {
  return fmt::format("'{}'", joined(keys, "' or '"));
}

}  // namespace

MissingKey::MissingKey(const std::string& name, const std::vector<std::string>& alternatives,
                       const std::string& hint)
    : BadParameter(name, fmt::format("missing key {}{}", quoted_alternatives(alternatives), hint)),
      alternatives_(alternatives),
      hint_(hint) {}

namespace {

using Reader = std::function<void(Scene&)>;
using Names = std::vector<std::string>;

struct Missing {
  Names names;
  bool to_end = true;  ///< no fault of another kind ended the search
};

Missing missing_with(Scene scene, const std::string& key, const Reader& read);

/// This key and those behind it, by the alternative with the fewest.
Missing missing_from(const Scene& scene, const MissingKey& first, const Reader& read) {
  std::optional<Missing> fewest;
  for (const std::string& key : first.alternatives()) {
    const Missing found = missing_with(scene, key, read);
    const auto rank = [](const Missing& one) { return std::pair(!one.to_end, one.names.size()); };
    if (!fewest || rank(found) < rank(*fewest)) fewest = found;
  }
  fewest->names.insert(fewest->names.begin(), quoted_alternatives(first.alternatives()));
  return *fewest;
}

/// Those behind a key; none behind a word, as they depend on it.
Missing missing_with(Scene scene, const std::string& key, const Reader& read) {
  const Key* known = scene.known(key);
  if (known == nullptr || known->type == Key::Type::file) return {.names = {}, .to_end = false};
  if (known->type == Key::Type::word) return {};
  scene.set(key + (known->type == Key::Type::whole ? "=51" : "=0.25"));
  try {
    read(scene);
    return {};
  } catch (const MissingKey& next) {
    return missing_from(scene, next, read);
  } catch (const std::invalid_argument&) {
    return {.names = {}, .to_end = false};
  }
}

}  // namespace

BadParameter all_missing(const Scene& scene, const MissingKey& first, const Reader& read) {
  const Names names = missing_from(scene, first, read).names;
  if (names.size() == 1) return first;
  return {first.name(), fmt::format("missing keys {}{}", joined(names, ", "), first.hint())};
}

}  // namespace microslip
