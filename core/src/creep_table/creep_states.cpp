// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/creep_table/creep_states.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "microslip/creep_table/unit_patch.hpp"
#include "microslip/support/error_sizes.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/random.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

Vector3d random_direction(std::mt19937_64& random) {
  const double z = 2 * unit_random(random) - 1, turn = 2 * pi * unit_random(random),
               across = std::sqrt(1 - z * z);
  return {across * std::cos(turn), across * std::sin(turn), z};
}

}  // namespace

std::vector<CreepState> random_creep_states(const CreepTableLayout& layout, std::uint64_t seed,
                                            std::size_t count, Index cells) {
  validate(layout);
  require(cells >= 4 && cells <= 40, "error_cells", static_cast<double>(cells),
          "a whole number from 4 to 40");
  std::mt19937_64 random(seed);
  const double ratio =
      layout.least_ratio * std::pow(layout.largest_ratio / layout.least_ratio, unit_random(random));
  const MotionScales scales(ratio, creep_coefficients(ratio, layout.poisson_ratio).value);
  std::vector<UnitPatch> patches;
  for (std::size_t grid = 0; grid < grids_of_mean; ++grid) {
    patches.emplace_back(ratio, layout.poisson_ratio, cells + static_cast<Index>(grid));
  }
  std::vector<CreepState> states;
  for (std::size_t i = 0; i < count; ++i) {
    const double r = size_of_motion(unit_random(random));
    const Vector3d motion = r * random_direction(random).cwiseQuotient(scales.sizes);
    try {
      Vector3d sum = Vector3d::Zero();
      for (const UnitPatch& patch : patches) sum += patch.solve(motion).forces;
      states.push_back({ratio, motion, sum / static_cast<double>(grids_of_mean)});
    } catch (const NotConverged&) {
      continue;
    }
  }
  return states;
}

CreepTableErrors errors_in(const std::vector<CreepState>& states, const CreepTable& table,
                           Index cells) {
  CreepTableErrors errors;
  errors.states = static_cast<Index>(states.size());
  errors.cells = cells;
  for (Index c = 0; c < 3; ++c) {
    ErrorSizes sizes;
    for (const CreepState& state : states) {
      sizes.add(table.forces(state.ratio, state.motion)[c] - state.forces[c]);
    }
    errors.rms[c] = sizes.rms();
    errors.of_99_percent[c] = sizes.part(0.99);
    errors.largest[c] = sizes.part(1);
  }
  return errors;
}

}  // namespace microslip
