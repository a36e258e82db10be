// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <sstream>
#include <string_view>

#include "microslip/friction/friction_law.hpp"
#include "microslip/rolling/large_creepage.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/scene/unloaded.hpp"
#include "microslip/support/text.hpp"

namespace microslip::python {

namespace {

using Files = std::map<std::string, std::string>;

/// Assigns a value to a key. Removing a missing key does nothing: it is an argument that was not
/// given.
void assign(Scene& scene, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string key = assignment.substr(0, equals);
  const bool removes = equals + 1 == assignment.size();
  if (removes && !scene.has(key) && !scene.has("sweep." + key)) return;
  scene.set(assignment);
}

void leave_out(Scene& scene, std::initializer_list<std::string_view> names) {
  for (const std::string& key : scene.keys()) {
    const bool goes = std::any_of(names.begin(), names.end(), [&](std::string_view name) {
      const bool is_of_friction = key == "load.speed" && scene.has("contact.friction_law");
      return name.ends_with('.') ? key.starts_with(name) && !is_of_friction : key == name;
    });
    if (goes) scene.set(key + '=');
  }
}

/// Warns of several steady solutions. Steady rolling has one where 2 (1 - nu) V |dmu/ds| times the
/// pressure over G is below 1: docs/theory.md, "Friction that falls with slip".
/// \param strain  of the largest bound at rest, bound over G  [1]
void warn_of_fast_fall(Scene& scene, const std::optional<SlipFriction>& friction, double strain) {
  if (!friction || 2 * strain * friction->speed * friction->law.steepest() < 1) return;
  scene.warn("contact.friction_law", scene.text("contact.friction_law"),
             "friction falls so fast with slip that steady rolling may have a second solution; "
             "microslip.solve tells");
}

template <class Read>
auto read_all(Scene& scene, const Read& read) {
  return placed(scene, [&] {
    auto problem = read();
    scene.reject_unread();
    return problem;
  });
}

}  // namespace

Scene scene_of(const microslip_py_scene& given) {
  std::istringstream in(given.text);
  Scene scene = Scene::parse(in, given.name, given.folder);
  for (std::size_t i = 0; i < given.assignment_count; ++i) assign(scene, given.assignments[i]);
  const auto files = std::make_shared<Files>();
  for (std::size_t i = 0; i < given.file_count; ++i) {
    files->emplace(given.file_names[i], given.file_texts[i]);
  }
  scene.read_files_by([files](const std::string& path) {
    const auto found = files->find(path);
    return found == files->end() ? file_text(path) : found->second;
  });
  return scene;
}

TransientProblem rolling_of(Scene scene) {
  for (const char* key : patch_keys) {
    if (!scene.has(key)) continue;
    throw BadParameter(key, fmt::format("{}: expected a line contact, without this key; "
                                        "microslip.Patch rolls ellipses and other patches",
                                        key));
  }
  leave_out(scene, {"problem", "method", "leading_edge", "target_error", "load.", "motion.",
                    "start.", "cylinder.", "step.ratio", "step.tolerance"});
  return read_all(scene, [&] { return read_transient_problem(scene); });
}

SteadyProblem steady_of(Scene& scene) {
  const bool is_steady = !scene.has("problem") || scene.text("problem") == "steady";
  leave_out(scene, {"problem", "load.", "motion.", "start.", "cylinder.", "step.scheme",
                    "step.relaxation", "step.tolerance"});
  if (!is_steady) leave_out(scene, {"step."});
  scene.set("load.creepage=0");
  const SteadyProblem problem = read_all(scene, [&] { return read_steady(scene); });
  const double largest_over_mean = 4 / std::numbers::pi;  // of Hertz's bound
  warn_of_fast_fall(
      scene, problem.friction,
      largest_over_mean * bound_strain(problem.contact.bound, problem.contact.kernel));
  return problem;
}

PatchOfScene patch_of(Scene& scene) {
  if (!scene.has_patch()) {
    throw BadParameter(
        patch_keys[0],
        fmt::format("{} or {}: expected an ellipse or another patch, with one of "
                    "them; microslip.Rolling rolls a line contact",
                    fmt::join(patch_keys.begin(), patch_keys.end() - 1, ", "), patch_keys.back()));
  }
  const std::string scheme = scene.has("step.scheme") ? scene.word("step.scheme") : "remembered";
  leave_out_steps(scene);
  leave_out(scene, {"load.", "curve."});
  const SteadyPatch patch = read_all(scene, [&] { return read_steady_patch(scene, 0); });
  warn_of_fast_fall(scene, patch.friction, patch.bound.peak() / patch.material.shear_modulus);
  return {patch, scheme};
}

void leave_out_steps(Scene& scene) {
  leave_out(scene, {"problem", "motion.", "start.", "step.", "load.file", "load.columns"});
  scene.set("problem=steady");
}

std::string lines_of(const std::vector<Warning>& warnings) {
  std::string lines;
  for (const Warning& warning : warnings) lines += warning.line + '\n';
  return lines;
}

}  // namespace microslip::python
