// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_evidence.hpp"

#include <algorithm>
#include <cmath>

#include "component_pairs.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

Evidence friction_of(const PatchState& state, const VectorXd& shares, const VectorXd& limits) {
  Evidence evidence;
  for (Index i = 0; i < limits.size(); ++i) {
    if (!state.slips[static_cast<std::size_t>(i)]) continue;
    const Vector2d v = pair_of(state.unknowns, i);
    const double power = shares[i] * v.dot(pair_of(state.centre_slip, i));
    evidence.excess += shares[i] * std::max(0.0, v.norm() / state.carried[i] - limits[i]);
    evidence.backward += std::max(0.0, power);
    evidence.dissipated -= power;
  }
  return evidence;
}

Evidence evidence_of_cells(const PatchState& state, const VectorXd& shares, const VectorXd& limits,
                           const EvidenceScale& scale, const VectorXd& at_rest) {
  Evidence evidence = friction_of(state, shares, limits);
  evidence.excess *= scale.force;
  evidence.backward *= scale.power;
  evidence.dissipated *= scale.power;
  evidence.residual = state.residual;
  evidence.full_sliding = scale.full_sliding;
  // Where all slides, rows of three cells or more have the bound's force but for rounding.
  evidence.unresolved =
      std::abs(scale.force * shares.dot(at_rest) - scale.full_sliding) * scale.slip_share;
  return evidence;
}

}  // namespace microslip
