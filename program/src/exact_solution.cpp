// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_solution.hpp"

#include <stdexcept>
#include <variant>

#include "microslip/scene/keys.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip::program {

namespace {

std::optional<Carter> carter(const SteadyContact& contact) {
  const auto* hertz = std::get_if<HertzBound>(&contact.bound);
  if (!contact.kernel.is_plane() || hertz == nullptr) return std::nullopt;
  if (const auto* force = std::get_if<PrescribedForce>(&contact.load)) {
    return Carter::from_force(contact.kernel.material(), *hertz, force->value);
  }
  return Carter::from_creepage(contact.kernel.material(), *hertz,
                               std::get<PrescribedCreepage>(contact.load).value);
}

struct CarterOf {
  std::optional<Carter> operator()(const SteadyProblem& problem) const {
    if (problem.contact.has_unlike_bodies()) return std::nullopt;
    return carter({problem.contact, problem.load});
  }
  std::optional<Carter> operator()(const SteadyTarget& target) const {
    return carter(target.contact);
  }
  std::optional<Carter> operator()(const SteadyPatch&) const { return std::nullopt; }
  std::optional<Carter> operator()(const PatchTarget&) const { return std::nullopt; }
  std::optional<Carter> operator()(const PatchTransient&) const { return std::nullopt; }
  std::optional<Carter> operator()(const TransientScene&) const { return std::nullopt; }
  std::optional<Carter> operator()(const CylinderScene&) const { return std::nullopt; }
};

}  // namespace

std::optional<Carter> exact_solution(const Parameters& parameters) {
  Scene scene;
  try {
    for (const auto& [key, value] : parameters) {
      if (find_key(key) != nullptr) scene.set(key + "=" + value);
    }
    return std::visit(CarterOf{}, read_model(scene));
  } catch (const std::invalid_argument&) {  // a file that is not read here, or no scene
    return std::nullopt;
  } catch (const NotConverged&) {
    return std::nullopt;
  }
}

}  // namespace microslip::program
