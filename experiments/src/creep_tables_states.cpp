// SPDX-License-Identifier: GPL-3.0-or-later
#include "creep_tables_states.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <mutex>

#include "microslip/support/parallel.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::Vector3d;

namespace {

using ContactRow = std::vector<ContactTableCase>;
using RowForces = std::vector<std::optional<Vector3d>>;

/// Seeds of these states differ from those by which `microslip table` measures errors, from 1 on.
constexpr std::uint64_t first_seed = 1'000'000;

/// Rows of one a/b.
struct ShapeRows {
  double ratio;
  std::vector<ContactRow> rows;
};

std::vector<ShapeRows> shapes_of(Index every) {
  std::vector<ShapeRows> shapes;
  for (ContactRow& row : contact_table_cases(every)) {
    const double ratio = row.front().ratio;
    if (shapes.empty() || shapes.back().ratio != ratio) shapes.push_back({ratio, {}});
    shapes.back().rows.push_back(std::move(row));
  }
  return shapes;
}

std::vector<RowForces> solve_rows(const ShapeRows& shape, Index cells) {
  const UnitPatch patch(shape.ratio, poisson_ratio_of_creep_tables, cells);
  std::vector<RowForces> found;
  for (const ContactRow& row : shape.rows) {
    RowForces& forces = found.emplace_back();
    std::optional<PatchState> state;
    for (const ContactTableCase& one : row) forces.push_back(patch.forces(one.motion, state));
  }
  return found;
}

/// The a/b of the table in equal parts of their logarithm, one for each group: its shape is random there.
CreepTableLayout part_of_layout(Index group, Index groups) {
  CreepTableLayout part;
  const double least = part.least_ratio, ratio = part.largest_ratio / part.least_ratio;
  const auto end = [&](Index of) {
    return least * std::pow(ratio, static_cast<double>(of) / static_cast<double>(groups));
  };
  part.least_ratio = end(group);
  part.largest_ratio = std::min(part.largest_ratio, end(group + 1));
  return part;
}

/// The groups that are solved on finer grids, too, are those in the middle.
Index first_fine_group(const CreepTablesParameters& p) { return (p.groups - p.fine_groups) / 2; }

std::size_t sized(Index count) { return static_cast<std::size_t>(count); }

}  // namespace

std::size_t steps_of_states(const CreepTablesParameters& p) {
  return sized(p.fine_groups + p.groups) + grids_of_mean * shapes_of(p.every).size();
}

SolvedStates solve_states(const CreepTablesParameters& p, const Progress& progress) {
  const std::vector<ShapeRows> shapes = shapes_of(p.every);
  const std::size_t fine = sized(p.fine_groups), groups = sized(p.groups);
  std::vector<std::vector<CreepState>> random(fine + groups);
  std::vector<std::array<std::vector<RowForces>, grids_of_mean>> of_shapes(shapes.size());
  std::mutex mutex;
  std::size_t done = 0;
  // The longest ones come first.
  for_each_case(steps_of_states(p), available_cores(), [&](std::size_t i) {
    if (i < random.size()) {
      const bool is_fine = i < fine;
      const Index group =
          is_fine ? first_fine_group(p) + static_cast<Index>(i) : static_cast<Index>(i - fine);
      random[i] = random_creep_states(part_of_layout(group, p.groups), first_seed + sized(group),
                                      sized(is_fine ? p.fine_states : p.states),
                                      is_fine ? p.fine_cells : p.cells);
    } else {
      const std::size_t at = i - random.size();
      const std::size_t shape = shapes.size() - 1 - at / grids_of_mean, grid = at % grids_of_mean;
      of_shapes[shape][grid] = solve_rows(shapes[shape], p.cells + static_cast<Index>(grid));
    }
    const std::lock_guard lock(mutex);
    progress(++done, steps_of_states(p) + 1);
  });

  SolvedStates found;
  for (std::size_t i = 0; i < groups; ++i) {
    found.unsolved += sized(p.states) - random[fine + i].size();
    for (const CreepState& state : random[fine + i]) {
      found.states.push_back({state, std::nullopt, true});
      const std::size_t first = sized(first_fine_group(p));
      if (i < first || i >= first + fine) continue;
      for (const CreepState& other : random[i - first]) {
        if (other.motion == state.motion) found.finer.push_back({state, other});
      }
    }
  }
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    for (std::size_t r = 0; r < shapes[s].rows.size(); ++r) {
      for (std::size_t m = 0; m < shapes[s].rows[r].size(); ++m) {
        const ContactTableCase& one = shapes[s].rows[r][m];
        Vector3d sum = Vector3d::Zero();
        bool is_solved = true;
        for (const auto& of_grid : of_shapes[s]) {
          const std::optional<Vector3d>& forces = of_grid[r][m];
          is_solved = is_solved && forces;
          if (forces) sum += *forces;
        }
        if (!is_solved) {
          ++found.unsolved;
          continue;
        }
        found.states.push_back({{one.ratio, one.motion, sum / static_cast<double>(grids_of_mean)},
                                one.printed,
                                one.motion[2] != 0});
      }
    }
  }
  return found;
}

}  // namespace microslip::experiments
