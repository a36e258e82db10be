// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/creep_table/creep_table_nodes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>

#include "microslip/creep_table/unit_patch.hpp"
#include "microslip/patch/patch_grid.hpp"
#include "microslip/reference/full_sliding.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/not_converged_at.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

/// Polar angles are closer near pure spin by 1 + this, and less close near none by 1 - this.
constexpr double crowding = 0.4;

constexpr Index least_cells = 4, most_cells = 40;

double part_of(Index i, Index nodes) {
  return static_cast<double>(i) / static_cast<double>(nodes - 1);
}

double place_of_polar(double angle) { return 2 / pi * angle + crowding / pi * std::sin(2 * angle); }

}  // namespace

double CreepTableLayout::ratio(Index i) const {
  return least_ratio * std::pow(largest_ratio / least_ratio, part_of(i, ratios));
}

double CreepTableLayout::step(Index i) const { return part_of(i, steps); }

double CreepTableLayout::azimuth(Index k) const { return pi * part_of(k, azimuths); }

double CreepTableLayout::angle(Index j) const {
  if (j == 0 || j == polar - 1) return j == 0 ? 0 : pi / 2;
  const double place = part_of(j, polar);
  double angle = pi / 2 * place;
  constexpr int iterations = 50;
  for (int i = 0; i < iterations; ++i) {
    const double slope = 2 / pi * (1 + crowding * std::cos(2 * angle));
    angle -= (place_of_polar(angle) - place) / slope;
  }
  return angle;
}

double CreepTableLayout::place_of_ratio(double ratio) const {
  const double part = std::log(ratio / least_ratio) / std::log(largest_ratio / least_ratio);
  return std::clamp(part, 0.0, 1.0) * static_cast<double>(ratios - 1);
}

double CreepTableLayout::place_of_angle(double angle) const {
  return std::clamp(place_of_polar(angle), 0.0, 1.0) * static_cast<double>(polar - 1);
}

double CreepTableLayout::slope_of_place(double angle) const {
  return 2 / pi * (1 + crowding * std::cos(2 * angle)) * static_cast<double>(polar - 1);
}

std::size_t CreepTableLayout::nodes() const {
  return static_cast<std::size_t>(ratios * steps * polar * azimuths);
}

void validate(const CreepTableLayout& layout) {
  static constexpr Index most = 200;
  const auto require_nodes = [](const char* name, Index nodes, Index least) {
    require(nodes >= least && nodes <= most, name, static_cast<double>(nodes),
            [&] { return fmt::format("a whole number from {} to {}", least, most); });
  };
  require(layout.poisson_ratio >= 0 && layout.poisson_ratio <= 0.5, "poisson_ratio",
          layout.poisson_ratio, "a number from 0 to 0.5");
  require(layout.least_ratio >= 0.05 && layout.least_ratio < layout.largest_ratio, "least_ratio",
          layout.least_ratio, "a number from 0.05, below largest_ratio");
  require(layout.largest_ratio <= largest_patch_ratio, "largest_ratio", layout.largest_ratio,
          "a number up to 10");
  require_nodes("ratios", layout.ratios, 4);
  require_nodes("steps", layout.steps, 4);
  require_nodes("polar", layout.polar, 3);
  require_nodes("azimuths", layout.azimuths, 3);
  require(layout.cells >= least_cells && layout.cells <= most_cells, "cells",
          static_cast<double>(layout.cells), "a whole number from 4 to 40");
}

MotionScales::MotionScales(double ratio, const CreepCoefficients& coefficients) {
  constexpr double full = 2 * pi / 3;
  const double b = 1 / std::sqrt(ratio), b_over_a = 1 / ratio;
  const double kx = coefficients.c11 / full, ky = coefficients.c22 / full;
  // A row at the side moves along by the spin, by about 0.59 b.
  const double kp = std::hypot(coefficients.c23, 0.59 * b * coefficients.c11) / full;
  sizes = {kx, ky, kp};
  // Fitted so that splines over evenly spaced angles have least errors at a/b = 0.1 ... 10.
  const double along = kp / kx * std::pow(1 + b_over_a, 0.25);
  directions = {along, 1.35 * along * std::pow(1 + b_over_a, -0.4), 1};
}

Vector3d MotionScales::unit_motion(double angle, double azimuth) const {
  const Vector3d direction(std::sin(angle) * std::sin(azimuth), std::sin(angle) * std::cos(azimuth),
                           std::cos(angle));
  const Vector3d motion = direction.cwiseProduct(directions);
  return motion / motion.cwiseProduct(sizes).norm();
}

double size_of_motion(double t) { return half_step_size * t / (1 - t); }

Matrix3d linear_creep_forces(const CreepCoefficients& of) {
  constexpr double full = 2 * pi / 3;
  Matrix3d forces;
  forces << -of.c11, 0, 0, 0, -of.c22, -of.c23, 0, of.c32, -of.c33;
  return forces / full;
}

std::size_t CreepTableNodes::at(Index ratio, Index step, Index angle, Index azimuth) const {
  return static_cast<std::size_t>(
      3 * (((ratio * layout.steps + step) * layout.polar + angle) * layout.azimuths + azimuth));
}

/// A motion that has no solution on a grid of the mean is tried on four others, which have two, four,
/// six and eight cells more.
constexpr std::size_t grids_of_motion = 5;

/// The patches of a ratio, each made when it is first used.
struct CreepTableMaker::Shape {
  std::array<std::once_flag, grids_of_motion * grids_of_mean> made;
  std::array<std::optional<UnitPatch>, grids_of_motion * grids_of_mean> patches;
};

CreepTableMaker::CreepTableMaker(const CreepTableLayout& layout) : layout_(layout) {
  validate(layout);
  for (Index i = 0; i < layout.ratios; ++i) {
    coefficients_.push_back(creep_coefficients(layout.ratio(i), layout.poisson_ratio).value);
  }
  shapes_ = std::make_shared<std::vector<Shape>>(static_cast<std::size_t>(layout.ratios));
}

std::size_t CreepTableMaker::parts() const {
  return static_cast<std::size_t>(layout_.ratios * layout_.polar);
}

std::size_t CreepTableMaker::values_of(std::size_t part) const {
  const bool is_pure_spin = part % static_cast<std::size_t>(layout_.polar) == 0;
  return static_cast<std::size_t>(3 * layout_.steps * (is_pure_spin ? 1 : layout_.azimuths));
}

const UnitPatch& CreepTableMaker::patch(std::size_t ratio, std::size_t grid) const {
  Shape& shape = (*shapes_)[ratio];
  std::call_once(shape.made[grid], [&] {
    shape.patches[grid].emplace(layout_.ratio(static_cast<Index>(ratio)), layout_.poisson_ratio,
                                layout_.cells + static_cast<Index>(grid));
  });
  return *shape.patches[grid];
}

/// \param state  in which a smaller motion in the same direction ended; it becomes that of this one
Vector3d CreepTableMaker::solve_on(std::size_t ratio, std::size_t grid, const Vector3d& motion,
                                   std::optional<PatchState>& state) const {
  for (std::size_t tried = 0; tried + 1 < grids_of_motion; ++tried) {
    std::optional<PatchState> none;  // states are those of the grid of the mean
    const UnitPatch& on = patch(ratio, grid + tried * grids_of_mean);
    if (const auto found = on.forces(motion, tried == 0 ? state : none)) return *found;
  }
  try {
    return patch(ratio, grid + (grids_of_motion - 1) * grids_of_mean).solve(motion).forces;
  } catch (const NotConverged& error) {
    throw NotConvergedAt(
        fmt::format("a/b = {:.4g}, motion ({:.4g}, {:.4g}, {:.4g})",
                    layout_.ratio(static_cast<Index>(ratio)), motion[0], motion[1], motion[2]),
        error);
  }
}

std::vector<double> CreepTableMaker::solve(std::size_t part) const {
  const auto of = static_cast<Index>(part);
  const Index i = of / layout_.polar, j = of % layout_.polar;
  const double ratio = layout_.ratio(i);
  const MotionScales scales(ratio, coefficients_[static_cast<std::size_t>(i)]);
  std::vector<double> found;
  for (Index k = 0; found.size() < values_of(part); ++k) {
    const Vector3d unit = scales.unit_motion(layout_.angle(j), layout_.azimuth(k));
    std::array<std::optional<PatchState>, grids_of_mean> states;
    for (Index s = 0; s < layout_.steps; ++s) {
      Vector3d forces = Vector3d::Zero();
      if (s == layout_.steps - 1) {
        forces = full_sliding(ratio, unit);
      } else if (s > 0) {
        const Vector3d motion = size_of_motion(layout_.step(s)) * unit;
        for (std::size_t grid = 0; grid < grids_of_mean; ++grid) {
          forces += solve_on(static_cast<std::size_t>(i), grid, motion, states[grid]);
        }
        forces /= static_cast<double>(grids_of_mean);
      }
      found.insert(found.end(), forces.begin(), forces.end());
    }
  }
  return found;
}

CreepTableNodes CreepTableMaker::joined(const std::vector<std::vector<double>>& parts) const {
  CreepTableNodes nodes{layout_, coefficients_, std::vector<double>(3 * layout_.nodes())};
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const auto of = static_cast<Index>(part);
    const Index i = of / layout_.polar, j = of % layout_.polar;
    for (Index k = 0; k < layout_.azimuths; ++k) {
      for (Index s = 0; s < layout_.steps; ++s) {
        const Index azimuth = j == 0 ? 0 : k;  // pure spin has none
        const auto from = static_cast<std::size_t>(3 * (azimuth * layout_.steps + s));
        std::copy_n(parts[part].begin() + static_cast<std::ptrdiff_t>(from), 3,
                    nodes.forces.begin() + static_cast<std::ptrdiff_t>(nodes.at(i, s, j, k)));
      }
    }
  }
  return nodes;
}

}  // namespace microslip
