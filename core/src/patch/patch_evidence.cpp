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
    evidence.excess += shares[i] * std::max(0.0, v.norm() - limits[i]);
    evidence.backward += std::max(0.0, power);
    evidence.dissipated -= power;
  }
  return evidence;
}

namespace {

/// Whether the slip turns about a cell: it slips, as the eight cells around it do, and their directions
/// nearly cancel one another. Towards the edges, and where a cell around sticks, it does not.
bool turns_about(const JoinedRows& rows, const PatchState& state, Index i, Index k) {
  constexpr double most = 0.6;  // of the sum of eight directions
  const bool is_inner = i > 0 && i + 1 < rows.elements() && k > 0 && k + 1 < rows.rows() &&
                        rows.lobe(k - 1) == rows.lobe(k) && rows.lobe(k + 1) == rows.lobe(k);
  if (!is_inner) return false;
  Vector2d sum = Vector2d::Zero();
  for (Index row = k - 1; row <= k + 1; ++row) {
    for (Index element = i - 1; element <= i + 1; ++element) {
      const Index cell = rows.cell(element, row);
      if (!state.slips[static_cast<std::size_t>(cell)]) return false;
      if (row != k || element != i) sum += pair_of(state.centre_slip, cell).normalized();
    }
  }
  return sum.norm() < 8 * most;
}

/// The largest of the forces of cells about which the slip turns.
double force_of_turning(const JoinedRows& rows, const PatchState& state, const VectorXd& forces) {
  double largest = 0;
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      const double force = forces[rows.cell(i, k)];
      if (force > largest && turns_about(rows, state, i, k)) largest = force;
    }
  }
  return largest;
}

}  // namespace

Evidence evidence_of_cells(const JoinedRows& rows, const PatchState& state, const VectorXd& shares,
                           const VectorXd& limits, const EvidenceScale& scale,
                           const VectorXd& at_rest) {
  Evidence evidence = friction_of(state, shares, limits);
  evidence.excess *= scale.force;
  evidence.backward *= scale.power;
  evidence.dissipated *= scale.power;
  evidence.residual = state.residual;
  evidence.full_sliding = scale.full_sliding;
  // Where all slides, rows of three cells or more have the bound's force but for rounding.
  evidence.unresolved =
      std::abs(scale.force * shares.dot(at_rest) - scale.full_sliding) * scale.slip_share;
  if (scale.full_sliding > 0) {
    const VectorXd forces = scale.force / scale.full_sliding * shares.cwiseProduct(limits);
    evidence.turning = force_of_turning(rows, state, forces);
  }
  return evidence;
}

}  // namespace microslip
