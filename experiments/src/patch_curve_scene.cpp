// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/patch_curve_scene.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "curve_points.hpp"
#include "microslip/experiments/contact_tables.hpp"
#include "microslip/scene/unloaded.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged_at.hpp"
#include "microslip/support/require.hpp"
#include "patch_tables.hpp"
#include "study_keys.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

struct Component {
  const char* motion;
  const char* list;     ///< key of the values
  const char* largest;  ///< key of the largest one
};

constexpr std::array<Component, 3> components{
    {{"creepage", "curve.creepages", "curve.largest"},
     {"lateral_creepage", "curve.creepages", "curve.largest"},
     {"spin", "curve.spins", "curve.largest_spin"}}};

struct Law {
  const char* name;
  const char* title;
  Index resultants;  ///< 2: forces; 3: the moment, too
  Vector3d (*at)(const CreepForceContact&, const Vector3d& motion);
};

Vector3d without_moment(const Vector2d& force) { return {force[0], force[1], 0}; }

const Law laws[] = {
    {"fastsim", "FASTSIM, three flexibilities", 3,
     [](const CreepForceContact& c, const Vector3d& m) {
       return fastsim(c, m, Flexibilities::three);
     }},
    {"fastsim_one", "FASTSIM, one flexibility", 3,
     [](const CreepForceContact& c, const Vector3d& m) {
       return fastsim(c, m, Flexibilities::one);
     }},
    {"vermeulen_johnson", "Vermeulen and Johnson's law, spin as by Shen, Hedrick and Elkins", 2,
     [](const CreepForceContact& c, const Vector3d& m) {
       return without_moment(vermeulen_johnson(c, m));
     }},
    {"polach", "Polach's law", 2,
     [](const CreepForceContact& c, const Vector3d& m) { return without_moment(polach(c, m)); }}};

const Law& law_named(const std::string& name) {
  return *std::ranges::find_if(laws, [&](const Law& law) { return name == law.name; });
}

/// Whether forces are the same but for their signs where the motion along changes its sign. One that
/// the scene gives as 0 counts as another: curves of a family, which have it in turn, all cover the
/// same range.
bool is_symmetric(Scene& scene, const PatchLoad& load, std::size_t along) {
  if (along == 0) return true;  // lateral motions mirror it
  const std::size_t other = along == 1 ? 2 : 1;
  return !load[other].by_resultant && !scene.has(std::string("load.") + components[other].motion);
}

/// Returns a motion along, on its own, at which nearly all slides.
double beyond_sliding(const PatchCurveScene& scene, const CreepCoefficients& coefficients) {
  constexpr double margin = 1.25;
  constexpr double least_part = 0.05;  // C23 of a patch about another point may be 0
  const auto& [c11, c22, c23, c32, c33] = coefficients;
  const double c = scene.patch.bound.size();
  const double by_spin = c * std::max(std::abs(c23), least_part * c22);
  const double slope = std::array{c11, c22, by_spin}.at(scene.along);
  const double scale = scene.patch.material.shear_modulus * c * c;
  return rounded_up(margin * 3 * scene.patch.bound.total() / (scale * slope));
}

std::vector<double> motions_of(const PatchCurveScene& scene,
                               const CreepCoefficients& coefficients) {
  if (!scene.motions.empty()) return scene.motions;
  const double most = scene.largest ? *scene.largest : beyond_sliding(scene, coefficients);
  return evenly_spaced(scene.is_symmetric ? 0 : -most, most, scene.points);
}

/// Reads the values of the motion, or how many there are, and the largest one.
void read_motions(Scene& scene, PatchCurveScene& read) {
  const auto& [motion, list, largest] = components[read.along];
  const auto warn = [&](const char* key, double end) {
    warn_of_large_motion(scene, key, read.along, end, read.patch);
  };
  if (scene.has(list)) {
    for (const char* other : {"curve.points", largest}) scene.at_most_one_of({list, other});
    read.motions = scene.numbers(list);
    demand(scene, list, rising, read.motions);
    for (const double end : {read.motions.front(), read.motions.back()}) warn(list, end);
    return;
  }
  read.points = read_curve_points(scene);
  if (!scene.has(largest)) return;
  read.largest = scene.positive(largest);
  warn(largest, *read.largest);
}

CreepForceContact read_contact_of_laws(Scene& scene, const SteadyPatch& patch) {
  if (!patch.bound.is_hertz() || patch.bound.ratio() < least_kalker_ratio) {
    reject("curve.beside", scene.text("curve.beside"),
           fmt::format("nothing, as laws are for Hertz's bound on an ellipse with a/b >= {}",
                       format_short(least_kalker_ratio)));
  }
  const double factor = scene.number("curve.kalker_factor");
  require(factor > 0 && factor <= 1, "curve.kalker_factor", factor, "a number above 0, up to 1");
  CreepCoefficients of =
      creep_coefficients(patch.bound.ratio(), patch.material.poisson_ratio).value;
  for (double* one : {&of.c11, &of.c22, &of.c23, &of.c32, &of.c33}) *one *= factor;
  return {.half_width = patch.bound.half_width(),
          .lateral_half_width = patch.bound.lateral_half_width(),
          .shear_modulus = patch.material.shear_modulus,
          .full_sliding = patch.bound.total(),
          .coefficients = of};
}

std::vector<Column> columns_of(const PatchCurveScene& scene) {
  const double rounding = rounding_of_resultants * scene.patch.bound.total();
  const double rounding_of_moment = rounding * scene.patch.bound.size();
  std::vector<Column> columns{{"creepage", "1", "xi"},
                              {"lateral_creepage", "1", "eta"},
                              {"spin", "1/mm", "phi"},
                              {"force", "N", "Fx", rounding},
                              {"lateral_force", "N", "Fy", rounding},
                              {"spin_moment", "N mm", "Mz", rounding_of_moment},
                              {"force_ratio", "1", "size of the force over full sliding"}};
  if (scene.friction) {
    columns.push_back({"traction_coefficient", "1", "size of the force over the normal load"});
  }
  columns.push_back({"slip_share", "1", "share of the area that slips"});
  if (scene.patch.friction) columns.push_back(second_solution_column());
  columns.push_back({"change", "1", "of the result from rows and elements that are a third fewer"});
  for (const std::string& name : scene.laws) {
    const Law& law = law_named(name);
    const std::string of = std::string(" by ") + law.title;
    columns.push_back({name + "_force", "N", "Fx" + of, rounding});
    columns.push_back({name + "_lateral_force", "N", "Fy" + of, rounding});
    if (law.resultants == 3) {
      columns.push_back({name + "_spin_moment", "N mm", "Mz" + of, rounding_of_moment});
    }
    columns.push_back(
        {name + "_error", "1", "size of the difference of the force, over full sliding"});
  }
  return columns;
}

}  // namespace

PatchCurveScene read_patch_curve(Scene& scene) {
  const std::string varied = scene.word("curve.along");
  const auto component =
      std::ranges::find_if(components, [&](const Component& one) { return varied == one.motion; });
  const auto along = static_cast<std::size_t>(component - components.begin());
  PatchCurveScene read{.patch = read_steady_patch(scene, along), .along = along};
  read.is_symmetric = is_symmetric(scene, read.patch.load, along);
  read_motions(scene, read);
  read.laws = read_laws_beside(scene);
  if (!read.laws.empty()) read.contact = read_contact_of_laws(scene, read.patch);
  if (scene.has("contact.normal_load")) read.friction = read_friction(scene);
  return read;
}

std::vector<Table> curve_tables(const PatchCurveScene& scene, const Progress& progress) {
  const SteadyPatch& patch = scene.patch;
  const double full = patch.bound.total();
  const char* name = components[scene.along].motion;
  Table table("curve", fmt::format("resultants of steady rolling against the {}", name),
              columns_of(scene));
  SteadyPatchSolver solver(patch);
  const CreepCoefficients coefficients = solver.coefficients();
  const std::vector<double> motions = motions_of(scene, coefficients);
  std::vector<double> largest_errors(scene.laws.size(), 0);
  Evidence worst;
  std::string doubt;
  PatchLoad load = patch.load;
  std::size_t done = 0;
  for (const double motion : motions) {
    load[scene.along] = {.by_resultant = false, .value = motion};
    SteadyPatchSolution point = [&] {
      try {
        return solver.solve(load);
      } catch (const NotConverged& error) {
        throw NotConvergedAt(fmt::format("{} {}", name, format_short(motion)), error);
      }
    }();
    require_evidence(point.evidence, point.condition, point.iterations, patch.accepted);
    worst.change = std::max(worst.change, point.evidence.change);
    std::vector<Cell> row;
    for (const double value : point.motion) row.emplace_back(value);
    for (const double value : point.resultants) row.emplace_back(value);
    row.emplace_back(point.force() / full);
    if (scene.friction) row.emplace_back(*scene.friction * point.force() / full);
    row.emplace_back(point.slip_area() / point.area.sum());
    if (patch.friction) row.emplace_back(point.has_second ? 1.0 : 0.0);
    row.emplace_back(point.evidence.change);
    if (doubt.empty() && point.has_second) {
      doubt = fmt::format("{} = {}: {}", name, format_short(motion),
                          second_solution(patch.friction->branch));
    }
    for (std::size_t l = 0; l < scene.laws.size(); ++l) {
      const Law& law = law_named(scene.laws[l]);
      const Vector3d by_law = law.at(*scene.contact, point.motion);
      const double error = (by_law - point.resultants).head<2>().norm() / full;
      for (Index j = 0; j < law.resultants; ++j) row.emplace_back(by_law[j]);
      row.emplace_back(error);
      largest_errors[l] = std::max(largest_errors[l], error);
    }
    table.add(row);
    progress(++done, motions.size());
  }
  Table summary = empty_summary(fmt::format("resultants against the {}", name));
  summary.add({"full_sliding_force", full, "N"});
  add_patch_sizes(summary, patch);
  const auto& [c11, c22, c23, c32, c33] = coefficients;
  for (const auto& [key, value] :
       {std::pair{"c11", c11}, {"c22", c22}, {"c23", c23}, {"c33", c33}}) {
    summary.add({key, value, "1"});
  }
  for (std::size_t l = 0; l < scene.laws.size(); ++l) {
    summary.add({scene.laws[l] + "_error", largest_errors[l], "1"});
  }
  summary.add({"change", worst.change, "1"});
  if (doubt.empty()) doubt = doubt_of_patch(worst).value_or("none");
  summary.add({"warning", doubt, "1"});
  return {table, summary};
}

}  // namespace microslip::experiments
