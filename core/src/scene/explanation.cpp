// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <limits>
#include <sstream>

#include "microslip/rolling/schemes.hpp"
#include "microslip/scene/cost.hpp"

namespace microslip {

namespace {

std::string number(double value) {
  std::ostringstream text;
  text << std::setprecision(5) << value;
  return text.str();
}

std::string kind_of(const Load& load) {
  return std::holds_alternative<PrescribedForce>(load) ? "a force" : "a creepage";
}

std::string sliding(const TractionBound& bound) {
  return "full sliding at " + number(full_sliding_force(bound)) + " N/mm";
}

std::string sliding(const TractionBound& bound, const Load& load) {
  const auto* force = std::get_if<PrescribedForce>(&load);
  if (force == nullptr) return sliding(bound);
  return sliding(bound) + ", of which the load is " +
         number(std::abs(force->value) / full_sliding_force(bound));
}

std::string elements_of(const Grid& grid) {
  return std::to_string(grid.size()) + " elements of " + number(grid.spacing()) + " mm";
}

std::string with(std::string text, const std::string& place, const std::string& value) {
  const std::size_t found = text.find(place);
  return found == std::string::npos ? text : text.replace(found, place.size(), value);
}

std::string method_of(const SteadyProblem& problem) {
  const auto* differences = std::get_if<Differences>(&problem.method);
  const std::string text(entry_of(problem).text);
  return with(with(text, "{functions}", problem.basis.name() + " functions"), "{c}",
              number(differences == nullptr ? 1 : differences->step_ratio));
}

std::string method_of(const AdvectionScheme& scheme) { return std::string(entry_of(scheme).text); }

std::string rolled(const Model& model, double distance, const Grid& grid) {
  return "rolls " + number(distance) + " mm, " + number(distance / (2 * grid.half_width())) +
         " contact widths, in " + number(steps_needed(model)) + " steps";
}

/// Full sliding, and the largest part of it that is prescribed.
std::string loaded(const TransientScene& scene) {
  Load largest = scene.loads.at(0);
  const auto size = [](const Load& load) {
    return std::visit([](const auto& of) { return std::abs(of.value); }, load);
  };
  for (const double distance : scene.loads.distances()) {
    const Load load = scene.loads.at(distance);
    if (size(load) > size(largest)) largest = load;
  }
  return sliding(scene.problem.bound, largest);
}

/// The shifts before rolling, except for that of an ordinary start.
std::vector<std::string> shifted(const TransientScene& scene) {
  if (scene.shifts.empty()) return {};
  const std::string count = std::to_string(scene.shifts.size());
  const std::string shifts = scene.shifts.size() == 1 ? "1 shift" : count + " shifts";
  double most = 0;
  for (const ShiftLoad& load : scene.shifts) {
    most = std::max(most, std::visit([](const auto& of) { return std::abs(of.value); }, load));
  }
  const bool by_force = std::holds_alternative<PrescribedForce>(scene.shifts.front());
  return {shifts + " without rolling before it, " +
          (by_force ? "to at most " + number(most / full_sliding_force(scene.problem.bound)) +
                          " of full sliding"
                    : "by at most " + number(most) + " mm")};
}

/// The sizes of a contact that changes.
std::vector<std::string> changed(const TransientScene& scene) {
  if (!scene.loads.changes_contact()) return {};
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const double distance : scene.loads.distances()) {
    const double ratio = scene.loads.contact_at(distance).half_width;
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  const double a = scene.problem.grid.half_width();
  return {"the contact changes on the way, its half-width from " + number(least * a) + " to " +
          number(most * a) + " mm" + (least == 0 ? "; where it is 0, bodies do not touch" : "")};
}

const std::string normal_changes =
    "the normal contact: bound and edges are given, from row to row; they do not depend on "
    "tractions";
const std::string normal = "the normal contact: bound and edges are given and stay as they are";
const std::string how_steady = "how the bodies came to roll steadily, and their inertia";
const std::string goodman =
    "what tangential tractions change of the normal contact of bodies of different material";
const std::string details =
    "creepage in the other direction, spin, bodies of different material, friction that depends on "
    "slip, heat, "
    "wear";
const std::string details_of_unlike =
    "creepage in the other direction, spin, friction that depends on slip, heat, wear";

/// States that the pressure makes bodies of different material creep in free rolling.
std::vector<std::string> stretched(const SteadyProblem& problem) {
  if (!problem.has_unlike_bodies()) return {};
  const double ratio = problem.pressure_strain / compliance(material_of(problem.kernel));
  return {"bodies of different material, beta/mu = " + number(ratio) +
          ": the pressure stretches one surface against the other"};
}

struct Explain {
  Explanation operator()(const SteadyProblem& problem) const {
    std::vector<std::string> consequences = {sliding(problem.bound, problem.load),
                                             elements_of(problem.grid), method_of(problem)};
    std::ranges::copy(stretched(problem), std::back_inserter(consequences));
    Explanation found = steady(kind_of(problem.load), consequences);
    if (problem.has_unlike_bodies()) {
      found.not_modelled = {normal, goodman, how_steady, details_of_unlike};
    }
    return found;
  }
  Explanation operator()(const SteadyTarget& target) const {
    return steady(
        kind_of(target.contact.load),
        {sliding(target.contact.bound, target.contact.load),
         "method and grid are picked: Chebyshev collocation where it can be used, else as "
         "many elements as the error needs"});
  }
  Explanation operator()(const TransientScene& scene) const {
    std::vector<std::string> consequences = {loaded(scene), elements_of(scene.problem.grid)};
    std::ranges::copy(changed(scene), std::back_inserter(consequences));
    std::ranges::copy(shifted(scene), std::back_inserter(consequences));
    consequences.push_back(rolled(scene, scene.distance, scene.problem.grid));
    consequences.push_back(method_of(scene.problem.scheme));
    const std::string kind = kind_of(scene.loads.at(0));
    return {"transient rolling under " +
                (scene.loads.distances().empty() ? kind : kind + " that changes"),
            consequences,
            {scene.loads.changes_contact() ? normal_changes : normal,
             "inertia of the bodies, which problem cylinder has", details}};
  }
  Explanation operator()(const CylinderScene& scene) const {
    const double velocity = scene.cylinder.velocity;
    const std::string start =
        velocity == 0 ? "rest" : "free rolling with " + number(velocity) + " mm/s";
    return {"a cylinder that rolls down a slope from " + start,
            {sliding(scene.contact.bound), elements_of(scene.contact.grid),
             rolled(scene, scene.distance, scene.contact.grid) +
                 " or more: those from rest, and of a body that swings, are shorter",
             method_of(scene.contact.scheme)},
            {normal, "waves in the bodies: they deform as half-spaces at rest", details}};
  }
  static Explanation steady(const std::string& load, std::vector<std::string> consequences) {
    return {"steady rolling under " + load, std::move(consequences), {normal, how_steady, details}};
  }
};

}  // namespace

Explanation explain(const Model& model) { return std::visit(Explain{}, model); }

}  // namespace microslip
