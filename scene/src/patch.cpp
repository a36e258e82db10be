// SPDX-License-Identifier: GPL-3.0-or-later
// The contact ellipse of a scene, or a contact of another shape.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "hertz.hpp"
#include "microslip/patch/large_motion.hpp"
#include "microslip/patch/patch_grid.hpp"
#include "microslip/reference/point_contact.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/scene/unloaded.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "patch_files.hpp"
#include "patch_parts.hpp"
#include "slip_friction.hpp"

namespace microslip {

namespace {

constexpr const char* lateral_half_width = "contact.lateral_half_width";

/// Reads the radii across the rolling.
Radii read_lateral_radii(Scene& scene) {
  constexpr std::array keys{"contact.lateral_radius_1", "contact.lateral_radius_2"};
  std::array<double, 2> radii{};  // 0 of a flat body
  double smaller = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!scene.has(keys[i])) continue;
    radii[i] = scene.number(keys[i]);
    require_positive(keys[i], std::abs(radii[i]));
    smaller = std::min(smaller, std::abs(radii[i]));
  }
  return {summed_curvature(keys[0], radii[0], keys[1], radii[1]), smaller};
}

/// Hertz's ellipse by load and radii.
EllipticBound read_loaded_ellipse(Scene& scene, const Material& material) {
  for (const char* other : {"contact.half_width", "contact.peak_traction", bound_file}) {
    scene.at_most_one_of({"contact.normal_load", other});
  }
  const double load = scene.positive("contact.normal_load");
  const Radii radii = read_radii(scene);
  const Radii lateral = read_lateral_radii(scene);
  const double friction = read_friction(scene);
  const PointContact contact(material, load, radii.curvature, lateral.curvature);
  const double a = contact.half_width(), b = contact.lateral_half_width();
  require(is_patch_ratio(a / b), "contact.radius_1", scene.number("contact.radius_1"), [&] {
    return fmt::format("radii of an ellipse with a/b from {} to {}, not {:.3g}",
                       format_short(least_patch_ratio), format_short(largest_patch_ratio), a / b);
  });
  scene.derive("contact.half_width", a);
  scene.derive(lateral_half_width, b);
  require_small(scene, a, radii.smaller);
  require_small(scene, b, lateral.smaller, "lateral half-width");
  const EllipticBound bound(a, b, friction * contact.peak_pressure());
  scene.derive("contact.peak_traction", bound.peak());
  return bound;
}

/// The bound of a shape whose force is given.
PatchBound read_bound_of_load(Scene& scene, const PatchShape& shape) {
  const double load = scene.positive("contact.normal_load");
  const double friction = read_friction(scene);
  const PatchBound bound(shape, friction * load / PatchBound(shape, 1).total());
  scene.derive("contact.peak_traction", bound.peak());
  return bound;
}

/// The bound of an ellipse by its semi-axes.
PatchBound read_bound_of_ellipse(Scene& scene, double a, double b) {
  const std::string given =
      scene.one_of({"contact.peak_traction", "contact.normal_load", bound_file});
  if (given == bound_file) return read_bound_table(scene, PatchShape::ellipse(a, b));
  if (given == "contact.peak_traction") {
    return EllipticBound(a, b, scene.positive("contact.peak_traction"));
  }
  const double load = scene.positive("contact.normal_load");
  const double friction = read_friction(scene);
  const EllipticBound bound(a, b, 1.5 * friction * load / (std::numbers::pi * a * b));
  scene.derive("contact.peak_traction", bound.peak());
  return bound;
}

PatchBound read_ellipse(Scene& scene, const Material& material) {
  if (!scene.has(lateral_half_width)) return read_loaded_ellipse(scene, material);
  for (const char* radius : {"contact.lateral_radius_1", "contact.lateral_radius_2"}) {
    scene.at_most_one_of({lateral_half_width, radius});
  }
  const double a = scene.positive("contact.half_width");
  const double b = scene.positive(lateral_half_width);
  require(is_patch_ratio(a / b), lateral_half_width, b, [&] {
    return fmt::format("a number between {} and {}, by contact.half_width",
                       format_short(a / largest_patch_ratio), format_short(a / least_patch_ratio));
  });
  return read_bound_of_ellipse(scene, a, b);
}

/// Refuses lobes that are much longer than wide, or wider than long.
void require_ratios(const Scene& scene, const PatchShape& shape) {
  scene.with_file(patch_file, [&] {
    for (const Lobe& lobe : shape.lobes()) {
      const double ratio = PatchShape({lobe}).ratio();
      require(is_patch_ratio(ratio), "length over width of a lobe", ratio, [&] {
        return fmt::format("a number from {} to {}", format_short(least_patch_ratio),
                           format_short(largest_patch_ratio));
      });
    }
  });
}

/// Warns of a contact that lies away from the axis of spin.
void warn_of_place(Scene& scene, const PatchShape& shape) {
  constexpr double far = 3;
  const double x = (shape.leading() + shape.trailing()) / 2, y = (shape.high() + shape.low()) / 2;
  const double reach = std::hypot(shape.leading() - x, shape.high() - y);
  if (std::hypot(x, y) <= far * reach) return;
  scene.warn(patch_file, scene.text(patch_file),
             fmt::format("the contact lies {} mm from x = y = 0, about which spin and moment are",
                         format_roughly(std::hypot(x, y))));
}

/// A contact of any shape, with a table of the bound, or one that is semi-elliptic in each row.
PatchBound read_patch(Scene& scene) {
  for (const char* other :
       {"contact.half_width", lateral_half_width, "contact.radius_1", "contact.radius_2",
        "contact.lateral_radius_1", "contact.lateral_radius_2"}) {
    scene.at_most_one_of({patch_file, other});
  }
  const PatchShape shape = read_shape(scene);
  require_ratios(scene, shape);
  warn_of_place(scene, shape);
  const std::string given =
      scene.one_of({bound_file, "contact.peak_traction", "contact.normal_load"});
  if (given == bound_file) return read_bound_table(scene, shape);
  if (given == "contact.normal_load") return read_bound_of_load(scene, shape);
  return {shape, scene.positive(given)};
}

/// \param most  the largest resultant
PatchComponent read_component(Scene& scene, const PatchKeys& keys, double most) {
  const std::string given = scene.at_most_one_of({keys.motion, keys.resultant, keys.ratio});
  if (given.empty()) return {};
  const double value = scene.number(given);
  if (given == keys.motion) return {.by_resultant = false, .value = value};
  if (given == keys.resultant) return {.by_resultant = true, .value = value};
  require(std::abs(value) < 1, given, value, "a number above -1, below 1");
  scene.derive(keys.resultant, value * most);
  return {.by_resultant = true, .value = value * most};
}

/// Reads a whole number up to 100.
Eigen::Index read_cells(Scene& scene, const std::string& key, Eigen::Index least) {
  const Eigen::Index cells = scene.whole(key);
  require(cells >= least && cells <= most_cells_of_side, key, static_cast<double>(cells), [&] {
    return fmt::format("a whole number {} ... {} in an ellipse", least, most_cells_of_side);
  });
  return cells;
}

/// Warns of a grid that is cut in another proportion than one by default, if as many cells in that
/// proportion have a smaller error. They have none if the side that has too few cells has many, or
/// if one of the other grid's sides would have few.
void warn_of_other_aspect(Scene& scene, const SteadyPatch& patch) {
  constexpr double most = 3, many = 16, fewest = 6, limit = most_cells_of_side;
  const PatchGrid fitting = fitting_grid(patch.bound.shape());
  const auto rows = static_cast<double>(fitting.rows);
  const auto elements = static_cast<double>(fitting.elements);
  const auto given_rows = static_cast<double>(patch.rows);
  const auto given_elements = static_cast<double>(patch.elements);
  const double off = given_elements / given_rows / (elements / rows);
  const double scale = std::sqrt(given_elements * given_rows / (elements * rows));
  const double better_rows = std::ceil(scale * rows), better = std::ceil(scale * elements);
  if (off <= most && off >= 1 / most) return;
  if ((off > 1 ? given_rows : given_elements) >= many) return;
  if (std::min(better_rows, better) < fewest || std::max(better_rows, better) > limit) return;
  scene.warn("grid.rows", given_rows,
             fmt::format("rows and elements do not fit a/b = {:.3g}: {} rows of {} elements have a "
                         "smaller error",
                         patch.bound.ratio(), better_rows, better));
}

}  // namespace

void require_line_contact(const Scene& scene) {
  const auto* key =
      std::ranges::find_if(patch_keys, [&](const char* one) { return scene.has(one); });
  if (key == patch_keys.end()) return;
  throw BadParameter(*key, fmt::format("{}: expected a line contact here, without this key; an "
                                       "ellipse has problem steady and transient, and the "
                                       "commands sweep, curve, converge, explain and plot, in "
                                       "this version",
                                       *key));
}

namespace {

/// Reads material.* and contact.*
/// \param grid_of  chooses the grid of a shape
template <class GridOf>
SteadyPatch read_contact_of_patch(Scene& scene, const GridOf& grid_of) {
  const Material material = read_material(scene);
  const PatchBound bound =
      scene.has(patch_file) ? read_patch(scene) : read_ellipse(scene, material);
  warn_of_strain(scene, bound.peak(), material.shear_modulus);
  const PatchGrid grid = grid_of(bound.shape());
  SteadyPatch patch{
      .material = material, .bound = bound, .rows = grid.rows, .elements = grid.elements};
  // On fine rows, the rounding of a solution is above the tolerance of equations.
  patch.accepted.residual = largest_residual_of_step;
  return patch;
}

/// Reads the load of all components, of which one has to be there.
void read_load_of(Scene& scene, SteadyPatch& patch) {
  if (!has_patch_load(scene)) scene.one_of(keys_of_patch_loads());  // says which are missing
  patch.load = read_patch_load(scene, patch.bound);
  validate(patch);
  warn_of_large_motions(scene, patch);
}

}  // namespace

SteadyPatch read_unloaded_patch(Scene& scene) {
  const bool has_grid = scene.has("grid.rows") || scene.has("grid.elements");
  const SteadyPatch patch = read_contact_of_patch(scene, [&](const PatchShape& shape) {
    if (!has_grid) return fitting_grid(shape);
    const Eigen::Index rows = read_cells(scene, "grid.rows", 1);
    return PatchGrid{.rows = rows, .elements = read_cells(scene, "grid.elements", least_elements)};
  });
  if (has_grid) {
    const std::size_t lobes = patch.bound.shape().lobes().size();
    require(static_cast<std::size_t>(patch.rows) >= lobes, "grid.rows",
            static_cast<double>(patch.rows),
            [&] { return fmt::format("at least one row for each of the {} lobes", lobes); });
    warn_of_other_aspect(scene, patch);
  } else {
    scene.derive("grid.rows", static_cast<double>(patch.rows));
    scene.derive("grid.elements", static_cast<double>(patch.elements));
  }
  return patch;
}

bool has_patch_load(const Scene& scene) {
  return std::ranges::any_of(patch_components, [&](const PatchKeys& keys) {
    return scene.has(keys.motion) || scene.has(keys.resultant) || scene.has(keys.ratio);
  });
}

PatchLoad read_patch_load(Scene& scene, const PatchBound& bound) {
  PatchLoad load;
  for (std::size_t j = 0; j < load.size(); ++j) {
    const double most = j < 2 ? bound.total() : bound.turning_moment();
    load[j] = read_component(scene, patch_components[j], most);
  }
  return load;
}

std::vector<std::string> keys_of_patch_loads() {
  std::vector<std::string> all;
  for (const PatchKeys& keys : patch_components) {
    all.insert(all.end(), {keys.motion, keys.resultant, keys.ratio});
  }
  return all;
}

void warn_of_large_motion(Scene& scene, const std::string& key, std::size_t component,
                          double motion, const SteadyPatch& patch) {
  const std::string doubt = doubt_of_large_motion(component, motion, patch);
  if (!doubt.empty()) scene.warn(key, motion, doubt);
}

void warn_of_large_motions(Scene& scene, const SteadyPatch& patch) {
  for (std::size_t j = 0; j < patch.load.size(); ++j) {
    const auto& [by_resultant, value] = patch.load[j];
    if (!by_resultant) warn_of_large_motion(scene, patch_components[j].motion, j, value, patch);
  }
}

SteadyPatch read_steady_patch(Scene& scene, std::size_t varied) {
  if (scene.word("problem") != "steady") {
    reject("problem", scene.text("problem"), "steady for a curve of an ellipse");
  }
  SteadyPatch patch = read_unloaded_patch(scene);
  patch.friction = read_slip_friction(scene);
  patch.load = read_patch_load(scene, patch.bound);
  patch.load[varied] = {};
  validate(patch);
  warn_of_large_motions(scene, patch);
  return patch;
}

SteadyPatch read_steady_patch(Scene& scene) {
  SteadyPatch patch = read_unloaded_patch(scene);
  patch.friction = read_slip_friction(scene);
  read_load_of(scene, patch);
  return patch;
}

PatchTarget read_patch_target(Scene& scene) {
  const double target = scene.number("target_error");
  require_target_error(target);
  SteadyPatch patch = read_contact_of_patch(
      scene, [](const PatchShape& shape) { return grids_to_try(shape).back(); });
  read_load_of(scene, patch);
  return {patch, target};
}

}  // namespace microslip
