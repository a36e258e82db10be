// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "microslip/scene/scene.hpp"

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
  const BadParameter named = in_keys(error);
  constexpr std::string_view file = "contact.bound_file", roughness = "contact.roughness";
  const std::string& name = named.name();
  if (!name.ends_with(file) || !scene.has(std::string(roughness))) return named;
  return renamed(named, name.substr(0, name.size() - file.size()) + std::string(roughness));
}

}  // namespace microslip
