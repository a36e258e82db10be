// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "microslip/friction/active_set.hpp"
#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/basis.hpp"
#include "microslip/halfspace/grid.hpp"
#include "microslip/halfspace/kernel.hpp"

namespace microslip {

/// Steady rolling of quasi-identical bodies in 2D: s = w - du/dx, thesis (3.2).
struct SteadyProblem {
  Kernel kernel;
  TractionBound bound;
  Grid grid;  ///< on the same [-a, a] as the bound
  Basis basis;
  double step_ratio;  ///< c = dq/dx of the difference for du/dx, >= min_step_ratio  [1]
  Load load;
  /// The displacement at the leading edge, where it is known: thesis (10.6)  [mm]
  std::optional<double> edge_displacement = std::nullopt;
};

/// Values at the N nodes, and what follows from them. A positive creepage gives negative tractions.
struct SteadySolution {
  Eigen::VectorXd x;             ///< [mm]
  Eigen::VectorXd bound;         ///< [N/mm^2]
  Eigen::VectorXd traction;      ///< coefficients of the basis  [N/mm^2]
  Eigen::VectorXd slip;          ///< relative slip s  [1]
  Eigen::VectorXd displacement;  ///< u  [mm]
  std::vector<Zone> zones;
  double force;        ///< integral of the traction  [N/mm]
  double creepage;     ///< w  [1]
  double dissipation;  ///< -integral of p s over x: energy per mm rolled and mm width  [N/mm]
  int iterations;      ///< of the active set

  Eigen::Index adhesion_elements() const;
  Eigen::Index slip_elements() const;
};

/// Collocation at the nodes: s_I = w + ((A - A') p)_I / dq, thesis (3.5)-(3.8). If the displacement
/// u_LE at the leading edge is known, the last one is s_N = w + ((A p)_N - u_LE) / (beta dx).
/// Cost: O(N^2) memory; time as ActiveSet.
/// Accuracy: the force is first order in dx for offsets 1/2 (tests/order/carter_order_test.cpp),
/// because A' feels the leading edge about 0.825 dx beyond the last node (constant basis, c = 1).
/// \throws std::invalid_argument for a step ratio or load outside its range, or for a known u_LE at
///                               beta = 0
/// \throws NotConverged          as ActiveSet::solve
SteadySolution solve_steady(const SteadyProblem& problem);

}  // namespace microslip
