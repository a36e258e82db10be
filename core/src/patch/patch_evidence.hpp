// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/patch/joined_rows.hpp"
#include "microslip/patch/stick_slip.hpp"
#include "microslip/rolling/evidence.hpp"

namespace microslip {

/// Integrals over the cells that slip: `excess`, `backward` and `dissipated`; other members are 0.
/// \param shares  the integral of p by the unknown of a cell over c^2: n
/// \param limits  as in solve_stick_slip()
Evidence friction_of(const PatchState& state, const Eigen::VectorXd& shares,
                     const Eigen::VectorXd& limits);

/// Units of evidence, and what else it needs.
struct EvidenceScale {
  double force, power;  ///< units
  double full_sliding;  ///< of the bound, by its integral
  double slip_share;    ///< of the area  [1]
};

/// The same in units, with the residual and what cells do not resolve of the bound; `load`, `power`
/// and `change` are 0.
/// \param at_rest  limits whose bound has the force of full sliding: n
Evidence evidence_of_cells(const PatchState& state, const Eigen::VectorXd& shares,
                           const Eigen::VectorXd& limits, const EvidenceScale& scale,
                           const Eigen::VectorXd& at_rest);

}  // namespace microslip
