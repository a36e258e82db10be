// SPDX-License-Identifier: GPL-3.0-or-later
#include "creep_tables_usetab.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "microslip/reference/full_sliding.hpp"
#include "microslip/support/parallel.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::Vector3d;

namespace {

constexpr Index intervals = 7;                     ///< up to 1, and as many beyond
constexpr Index usetab_nodes = 2 * intervals + 1;  ///< of an axis from 0 to infinity
constexpr Index spin_nodes = 2 * usetab_nodes - 1;

/// In nodes from 0: i/7, then 7/i down to infinity.
double usetab_place(double value) {
  return static_cast<double>(intervals) * (value <= 1 ? value : 2 - 1 / value);
}

/// The value at a node; infinity at the last one.
double usetab_value(Index node) {
  if (node <= intervals) return static_cast<double>(node) / intervals;
  return static_cast<double>(intervals) / static_cast<double>(2 * intervals - node);
}

}  // namespace

/// The cell of a motion whose xi and eta are positive, and the signs by which it has become that.
struct UsetabLayout::Place {
  std::array<Index, 3> first;
  Vector3d part;   ///< from 0 to 1
  Vector3d signs;  ///< of forces and moment

  std::array<std::size_t, 8> nodes() const {
    std::array<std::size_t, 8> found{};
    for (Index corner = 0; corner < 8; ++corner) {
      const Index x = first[0] + (corner & 1), y = first[1] + (corner >> 1 & 1),
                  z = first[2] + (corner >> 2);
      found[static_cast<std::size_t>(corner)] =
          static_cast<std::size_t>((x * usetab_nodes + y) * spin_nodes + z);
    }
    return found;
  }
};

UsetabLayout::Place UsetabLayout::place_of(const Vector3d& motion) const {
  const double along = motion[0] < 0 ? -1 : 1, across = motion[1] < 0 ? -1 : 1;
  const Vector3d scaled = motion.cwiseQuotient(scales_);
  const double spin = across * scaled[2];
  const Vector3d places(usetab_place(std::abs(scaled[0])), usetab_place(std::abs(scaled[1])),
                        usetab_nodes - 1 + std::copysign(usetab_place(std::abs(spin)), spin));
  Place found{.first = {}, .part = {}, .signs = {along, across, across}};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto c = static_cast<Index>(k);
    const Index last = (k == 2 ? spin_nodes : usetab_nodes) - 2;
    found.first[k] = std::min(last, static_cast<Index>(std::floor(places[c])));
    found.part[c] = places[c] - static_cast<double>(found.first[k]);
  }
  return found;
}

UsetabLayout::UsetabLayout(double ratio, const std::vector<Vector3d>& motions, Index cells)
    : forces_(static_cast<std::size_t>(usetab_nodes * usetab_nodes * spin_nodes),
              Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())) {
  const CreepCoefficients of = creep_coefficients(ratio, poisson_ratio_of_creep_tables).value;
  constexpr double full = 2 * std::numbers::pi / 3;
  scales_ = {3 * full / of.c11, 3 * full / of.c22, full / of.c23};
  std::vector<std::size_t> wanted;
  for (const Vector3d& motion : motions) {
    for (const std::size_t node : place_of(motion).nodes()) wanted.push_back(node);
  }
  std::ranges::sort(wanted);
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  solved_ = wanted.size();
  const std::array<UnitPatch, grids_of_mean> patches{
      UnitPatch(ratio, poisson_ratio_of_creep_tables, cells),
      UnitPatch(ratio, poisson_ratio_of_creep_tables, cells + 1)};
  for_each_case(wanted.size(), available_cores(), [&](std::size_t i) {
    const auto node = static_cast<Index>(wanted[i]);
    const Index z = node % spin_nodes - (usetab_nodes - 1), y = node / spin_nodes % usetab_nodes,
                x = node / spin_nodes / usetab_nodes;
    const double spin = z < 0 ? -usetab_value(-z) : usetab_value(z);
    const Vector3d values(usetab_value(x), usetab_value(y), spin);
    Vector3d& forces = forces_[wanted[i]];
    if (values.isZero(0)) {
      forces.setZero();
    } else if (!values.allFinite()) {
      // Infinite components are equal, and finite ones have no part.
      const Vector3d direction =
          values.unaryExpr([](double v) { return std::isinf(v) ? std::copysign(1.0, v) : 0.0; });
      forces = full_sliding(ratio, direction.cwiseProduct(scales_));
    } else {
      Vector3d sum = Vector3d::Zero();
      for (const UnitPatch& patch : patches) {
        std::optional<PatchState> state;
        const Vector3d none = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
        sum += patch.forces(values.cwiseProduct(scales_), state).value_or(none);
      }
      forces = sum / static_cast<double>(grids_of_mean);
    }
  });
}

Vector3d UsetabLayout::forces(const Vector3d& motion) const {
  const Place place = place_of(motion);
  const auto nodes = place.nodes();
  Vector3d sum = Vector3d::Zero();
  for (std::size_t corner = 0; corner < nodes.size(); ++corner) {
    double weight = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double part = place.part[static_cast<Index>(k)];
      weight *= (corner >> k & 1) != 0 ? part : 1 - part;
    }
    if (weight > 0) sum += weight * forces_[nodes[corner]];
  }
  return sum.cwiseProduct(place.signs);
}

}  // namespace microslip::experiments
