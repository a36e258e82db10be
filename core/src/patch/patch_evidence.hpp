// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/patch/stick_slip.hpp"
#include "microslip/rolling/evidence.hpp"

namespace microslip {

/// Integrals over the cells that slip: `excess`, `backward` and `dissipated`; other members are 0.
/// \param shares  the integral of p by the unknown of a cell over c^2: n
/// \param limits  as in solve_stick_slip()
Evidence friction_of(const PatchState& state, const Eigen::VectorXd& shares,
                     const Eigen::VectorXd& limits);

}  // namespace microslip
