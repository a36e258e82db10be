// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "microslip/creep_table/creep_states.hpp"
#include "microslip/creep_table/unit_patch.hpp"
#include "microslip/experiments/creep_tables.hpp"

namespace microslip::experiments {

inline constexpr double poisson_ratio_of_creep_tables = 0.28;

/// A motion with its reference solution.
struct ComparedState {
  CreepState state;
  std::optional<Eigen::Vector3d> by_contact;  ///< CONTACT's result on 11 x 11 elements
  bool has_spin;

  bool is_random() const { return !by_contact; }
};

/// A case of CONTACT's public test table, with CONTACT's printed result.
struct ContactTableCase {
  double ratio;             ///< a/b
  Eigen::Vector3d motion;   ///< xi, eta, phi c over mu p0/G
  Eigen::Vector3d printed;  ///< over mu F_n, and mu F_n c
};

/// Rows of cases of one a/b, spin and direction of the creepage, whose magnitude rises. Mirrored motions
/// and repeated ones are left out, and so is rest.
/// \param every  of the magnitudes, >= 1; those of 0 always
std::vector<std::vector<ContactTableCase>> contact_table_cases(Eigen::Index every);

/// Steps of the progress of solve_states().
std::size_t steps_of_states(const CreepTablesParameters& parameters);

struct SolvedStates {
  std::vector<ComparedState> states;
  std::size_t unsolved = 0;  ///< motions without a solution on one of the grids
  /// Random states, and their solutions on fine_cells.
  std::vector<std::array<CreepState, 2>> finer;
};

/// The references: on all cores, the same for any number of them.
SolvedStates solve_states(const CreepTablesParameters& parameters, const Progress& progress);

}  // namespace microslip::experiments
