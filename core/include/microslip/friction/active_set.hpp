// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

namespace microslip {

struct PrescribedCreepage {
  double value;  ///< relative rigid slip w, finite  [1]
};

struct PrescribedForce {
  double value;  ///< F, less in absolute value than full sliding  [N/mm]
};

using Load = std::variant<PrescribedCreepage, PrescribedForce>;

/// The discrete slip of n traction coefficients p, with the bound they must keep:
/// s = w + offset + response p, |p_i| <= bound_i, force = weights . p.
struct SlipEquations {
  Eigen::MatrixXd response;  ///< n x n  [mm^2/N]
  Eigen::VectorXd offset;    ///< n  [1]
  Eigen::VectorXd bound;     ///< n, >= 0  [N/mm^2]
  Eigen::VectorXd weights;   ///< n, > 0  [mm]
};

/// In slip, the sign is that of the traction.
enum class Zone : signed char { slip_negative = -1, adhesion = 0, slip_positive = 1 };

struct ContactState {
  Eigen::VectorXd traction;  ///< n  [N/mm^2]
  Eigen::VectorXd slip;      ///< n, zero in adhesion  [1]
  std::vector<Zone> zones;   ///< n
  double creepage;           ///< w, prescribed or found  [1]
  int iterations;            ///< linear systems factorised
};

/// Finds tractions, slip and their partition: in adhesion s = 0 and |p| <= bound, in slip
/// p = -bound s/|s|.
///
/// First all violating elements are exchanged at once, those above the bound before those with the
/// wrong direction of slip, from adhesion everywhere: thesis 3.1.1. For c near 1 this takes about
/// log2(n) rounds; for c << 1 the partitions never settle. So an element may be released from
/// adhesion three times; then the exact path is followed from a bound so high that all stick down
/// to the given one, exchanging one element at a time.
///
/// Termination: the first phase has at most 6 n rounds. On the path the solution is piecewise
/// linear in the height of the bound, with one piece a partition; if response + response^T is
/// positive definite, it is unique, and each of the finitely many partitions is met at most once.
/// A - A' is for all c <= 1 that were tried (tests/unit/active_set_test.cpp).
/// Otherwise the path is given up after 20 n + 100 exchanges.
/// Cost: one dense factorisation of the adhesion elements a round, O(n^3).
/// \throws std::invalid_argument if the force is not below full sliding, weights . bound
/// \throws NotConverged          if a system is singular, or the path is given up or ends short of
///                               a solution
ContactState solve_active_set(const SlipEquations& equations, const Load& load);

}  // namespace microslip
