// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "doubts.hpp"
#include "microslip/patch/large_motion.hpp"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/support/require.hpp"
#include "patch_files.hpp"
#include "patch_parts.hpp"
#include "run_columns.hpp"
#include "run_file.hpp"

namespace microslip {

using Eigen::VectorXd;

namespace {

/// A component's columns.
struct RunNames {
  const char* motion;
  const char* resultant;
};

constexpr std::array<RunNames, 3> run_components{{
    {"creepage", "force"},
    {"lateral_creepage", "lateral_force"},
    {"spin", "spin_moment"},
}};

/// Columns of a file by their names.
struct NamedColumns {
  std::vector<FileColumn> wanted;
  std::vector<std::optional<VectorXd>> found;

  const std::optional<VectorXd>& operator[](std::string_view name) const {
    const auto at = std::ranges::find(wanted, name, &FileColumn::name);
    return found[static_cast<std::size_t>(at - wanted.begin())];
  }
};

/// A component has either a column or a key.
void require_one_source(const Scene& scene, const NamedColumns& columns) {
  for (std::size_t j = 0; j < run_components.size(); ++j) {
    const auto& [motion, resultant] = run_components[j];
    const bool has_column = columns[motion] || columns[resultant] || (j == 0 && columns["omega"]);
    const auto& keys = patch_components[j];
    for (const char* key : {keys.motion, keys.resultant, keys.ratio}) {
      if (!has_column || !scene.has(key)) continue;
      const char* column = columns[motion] ? motion : columns[resultant] ? resultant : "omega";
      throw BadParameter(
          key, fmt::format("expected only one of '{}' and column '{}' of load.file", key, column));
    }
  }
}

std::string in_row(std::size_t row, std::string_view name) {
  return fmt::format("row {}: {}", row + 1, name);
}

/// Takes the columns of the contact.
void take_contact(Scene& scene, const NamedColumns& columns, RunRows& rows) {
  if (columns["half_width"] && scene.has(patch_file)) {
    throw std::invalid_argument(
        fmt::format("column 'half_width': expected none, as the contact of {} has one size; "
                    "friction or peak_traction may change",
                    patch_file));
  }
  rows.point_contact = true;
  rows.normal_load = columns["normal_load"];
  rows.half_width = columns["half_width"];
  rows.peak_traction = columns["peak_traction"];
  rows.friction = columns["friction"];
  rows.of_problem = reference_of(scene, rows);
}

/// Requires contacts that PatchRolling takes.
void require_patch_contacts(const NamedColumns& columns, const PatchHistory& loads,
                            const SteadyPatch& patch) {
  using Ranges = PatchStepRanges;
  const char* sizes = columns["normal_load"] ? "normal_load" : "half_width";
  const char* bounds = columns["friction"]        ? "friction"
                       : columns["peak_traction"] ? "peak_traction"
                                                  : "normal_load";
  const auto value_of = [&](const char* name, std::size_t row) {
    return (*columns[name])[static_cast<Eigen::Index>(row)];
  };
  const std::vector<double> rows = loads.row_distances();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ContactScale contact = loads.contact_of_row(i);
    const auto [size, bound] = contact;
    const ContactScale before = loads.contact_of_row(i > 0 ? i - 1 : 0);
    const bool keeps_contact = contact.carries() && before.carries();
    if (i > 0 && rows[i] == rows[i - 1] && keeps_contact && size != before.half_width) {
      require(false, in_row(i, sizes), value_of(sizes, i),
              fmt::format("{:.9g} of the row before, as nothing is rolled between them: an ellipse "
                          "keeps its size there, or loses its contact",
                          value_of(sizes, i - 1)));
    }
    if (size != 1 && !patch.bound.shape().is_ellipse()) {
      require(false, in_row(i, sizes), value_of(sizes, i),
              fmt::format("that of the scene, as the contact of {} has one size; friction or "
                          "peak_traction may change",
                          patch_file));
    }
    if (size != 0 && (size < Ranges::least_size || size > Ranges::largest_size)) {
      require(
          false, in_row(i, sizes), value_of(sizes, i),
          fmt::format("half-widths 1e-4 ... 100 times those of the scene, or 0, not {:.3g}", size));
    }
    if (bound != 0 && (bound < Ranges::least_bound || bound > Ranges::largest_bound)) {
      require(false, in_row(i, bounds), value_of(bounds, i),
              fmt::format("a bound 1e-6 ... 1e6 times that of the scene, or 0, not {:.3g}", bound));
    }
  }
}

/// The rows of one component.
RunRows rows_of_component(const NamedColumns& columns, std::size_t j,
                          const PatchComponent& constant) {
  const auto& [motion, resultant] = run_components[j];
  RunRows rows;
  rows.distance = columns["q"];
  rows.time = columns["t"];
  rows.velocity = columns["v"];
  rows.creepage_name = motion;
  rows.force_name = resultant;
  rows.creepage = columns[motion];
  rows.force = columns[resultant];
  if (j == 0) rows.angular_velocity = columns["omega"];
  if (rows.creepage || rows.force || rows.angular_velocity) return rows;
  const Eigen::Index n = (rows.time ? rows.time : rows.distance)->size();
  (constant.by_resultant ? rows.force : rows.creepage) = VectorXd::Constant(n, constant.value);
  return rows;
}

/// Requires that friction carries the resultants of each row, and that motions are not too large.
void require_rows_carried(const NamedColumns& columns, const PatchHistory& loads,
                          const SteadyPatch& patch) {
  const std::size_t rows = loads.row_distances().size();
  for (std::size_t i = 0; i < rows; ++i) {
    const PatchLoad load = loads.of_row(i);
    with_names_of(
        load,
        [&] {
          require_carried(load, patch.bound, loads.contact_of_row(i));
          require_motions(load, patch);
        },
        [&](std::size_t j) {
          const auto& [motion, resultant] = run_components[j];
          const std::string name = load[j].by_resultant ? resultant : motion;
          if (columns[name]) return in_row(i, name);
          if (j == 0 && columns["omega"]) return in_row(i, "creepage by omega");
          return loads.changes_contact() ? in_row(i, "load." + name) : "load." + name;
        });
  }
}

void warn_of_motions_in_run(Scene& scene, const PatchHistory& loads, const SteadyPatch& patch) {
  std::array<double, 3> largest{};
  for (const double distance : loads.distances()) {
    const PatchLoad load = loads.at(distance);
    for (std::size_t j = 0; j < largest.size(); ++j) {
      const bool is_larger = std::abs(load[j].value) > std::abs(largest[j]);
      if (!load[j].by_resultant && is_larger) largest[j] = load[j].value;
    }
  }
  for (std::size_t j = 0; j < largest.size(); ++j) {
    const std::string doubt = doubt_of_large_motion(j, largest[j], patch);
    if (doubt.empty()) continue;
    scene.warn(fmt::format("{} of load.file", run_components[j].motion), largest[j], doubt);
  }
}

}  // namespace

void require_motions(const PatchLoad& load, const SteadyPatch& patch, bool are_shifts) {
  const double strain = patch.bound.peak() / patch.material.shear_modulus;
  const double c = patch.bound.size();
  for (std::size_t j = 0; j < load.size(); ++j) {
    const auto& [by_resultant, value] = load[j];
    const double most =
        PatchStepRanges::largest_motion * strain * (are_shifts ? c : 1) / (j < 2 ? 1 : c);
    if (by_resultant || std::abs(value) <= most) continue;
    require(false, name_of(load, j), value,
            fmt::format("at most {:.3g} in size, 1e8 times what the bound's strain makes", most));
  }
}

PatchHistory read_patch_run(Scene& scene, const SteadyPatch& patch, const AdvectionScheme& scheme) {
  NamedColumns columns{run_columns(scene), {}};
  columns.found = scene.from_columns("load.file", columns.wanted, [&](const auto& found) {
    require_patch_run(scene, columns.wanted, found);
    return found;
  });
  require_one_source(scene, columns);
  double radius = 0;
  if (columns["omega"]) {
    radius = scene.positive("load.radius");
    warn_of_small_radius(scene, "load.radius", radius, patch.bound.half_width());
  }
  return scene.with_file("load.file", [&] {
    std::vector<LoadHistory> histories;
    for (std::size_t j = 0; j < run_components.size(); ++j) {
      RunRows rows = rows_of_component(columns, j, patch.load[j]);
      rows.radius = radius;
      rows.force_acts_before = starts_under_force(scene);
      if (j == 0) take_contact(scene, columns, rows);
      histories.emplace_back(rows);
    }
    const PatchHistory loads({histories[0], histories[1], histories[2]});
    if (loads.changes_contact()) {
      require_scheme_of_changes(scheme);
      require_patch_contacts(columns, loads, patch);
    }
    require_scheme_of_direction(scheme, histories[0]);
    if (!loads.stops().empty()) require_scheme_of_stops(scene, scheme);
    require_rows_carried(columns, loads, patch);
    warn_of_motions_in_run(scene, loads, patch);
    warn_of_other_load(scene, columns["normal_load"]);
    warn_of_short_way(scene, histories[0], columns["v"], patch.bound.half_width());
    warn_of_short_turns(scene, columns["q"], patch.bound.half_width());
    return loads;
  });
}

}  // namespace microslip
