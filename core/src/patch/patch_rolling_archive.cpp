// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <vector>

#include "../friction/friction_archive.hpp"
#include "microslip/support/sealed_text.hpp"
#include "patch_rolling_parts.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr SealedText state_of_patch{.mark = "microslip state of a patch ", .version = "5"};

/// The problem that a state belongs to.
void archive_problem(Archive& archive, const SteadyPatch& problem, const JoinedRows& rows,
                     const VectorXd& limits) {
  archive.same("material.shear_modulus", problem.material.shear_modulus);
  archive.same("material.poisson_ratio", problem.material.poisson_ratio);
  archive.same("grid.rows", static_cast<double>(problem.rows));
  archive.same("grid.elements", static_cast<double>(problem.elements));
  archive.same("contact.size", problem.bound.size());
  archive.same("contact.peak_traction", problem.bound.peak());
  const Eigen::MatrixX2d centres = centres_of(rows);
  archive.same("x", VectorXd(centres.col(0)));
  archive.same("y", VectorXd(centres.col(1)));
  archive.same("bound", limits);
  archive_friction(archive, problem.friction);
}

void archive_state(Archive& archive, PatchState& state, Index cells) {
  archive.numbers("unknowns", state.unknowns, 2 * cells);
  archive.numbers("own_slip", state.own_slip, 2 * cells);
  archive.numbers("centre_slip", state.centre_slip, 2 * cells);
  archive.numbers("seen_slip", state.seen_slip, 2 * cells);
  archive.numbers("carried", state.carried, cells);
  VectorXd motion = state.motion;
  archive.numbers("motion", motion, 3);
  state.motion = motion;
  std::vector<Index> slipping;
  for (Index i = 0; i < cells; ++i) {
    if (state.slips[static_cast<std::size_t>(i)]) slipping.push_back(i);
  }
  archive.wholes("slips", slipping, cells, 0, cells - 1);
  state.slips.assign(static_cast<std::size_t>(cells), false);
  for (const Index i : slipping) state.slips[static_cast<std::size_t>(i)] = true;
  Index iterations = state.iterations;
  archive.whole("iterations", iterations, 0, 1 << 20);
  state.iterations = static_cast<int>(iterations);
  archive.number("residual", state.residual);
}

}  // namespace

void PatchRolling::Parts::archive(Archive& archive) {
  archive_problem(archive, forward().problem, forward().rows, forward().limits);
  bool rolls_back = backward;
  archive.flag("backward", rolls_back);
  if (rolls_back != backward) *this = turned();
  const PatchConstants& of = *constants;
  const Index n = of.rows.cells();
  material.archive(archive);
  archive.number("half_width", now.half_width);
  archive.number("bound", now.bound);
  archive.number("next_half_width", next.half_width);
  archive.number("next_bound", next.bound);
  require_contact(now, of.problem.bound.shape());
  require_contact(next, of.problem.bound.shape());
  archive.flag("moved", moved);
  archive.number("step", step.dq);
  archive.number("step_from", step.from);
  archive.number("step_to", step.to);
  archive.number("step_ratio", step.ratio);
  double lost_energy = archive.reads() ? 0 : lost();
  archive.number("dissipation", lost_energy);
  dissipation = lost_energy;
  if (friction) {
    friction->archive(archive);
    archive.numbers("friction_limits", slipping_limits, n);
  }
  archive_state(archive, state, n);
  archive_follower(archive);
}

/// The follower is prepared anew by the same state.
void PatchRolling::Parts::archive_follower(Archive& archive) {
  archive.flag("follows", follows);
  if (!follows) return;
  PatchState with = archive.reads() ? state : follower->prepared_with();
  archive_state(archive, with, constants->rows.cells());
  PatchLoad load = archive.reads() ? PatchLoad{} : follower->prepared_for();
  for (std::size_t j = 0; j < load.size(); ++j) {
    archive.flag("follows_a_resultant", load[j].by_resultant);
  }
  if (!archive.reads()) return;
  const PatchResponse& of = last_response();
  prepare_follower(of, last_limits(), with, load);
}

std::string PatchRolling::save() const {
  Archive members;
  parts_->archive(members);
  return state_of_patch.sealed(members.text());
}

void PatchRolling::restore(const SavedState& saved) {
  Archive members(state_of_patch.members_of(saved.text));
  Parts restored = parts_->at_rest();
  restored.archive(members);
  members.require_end();
  *parts_ = std::move(restored);
}

double distance_of(const SavedState& saved, const SteadyPatch& problem) {
  validate(problem);
  const JoinedRows rows = rows_of(problem);
  Archive archive(state_of_patch.members_of(saved.text));
  archive_problem(archive, problem, rows, limits_of(rows, problem.bound));
  bool backward = false;
  archive.flag("backward", backward);
  double distance = 0;
  archive.number("distance", distance);
  return (backward ? 0 - distance : distance) * problem.bound.size();
}

}  // namespace microslip
