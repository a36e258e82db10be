// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "../friction/friction_archive.hpp"
#include "contact_archive.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/sealed_text.hpp"
#include "rolling_grid.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr SealedText format{.mark = "microslip state ", .version = "4"};

void archive_kernel(Archive& archive, const Kernel& kernel) {
  archive.same("kernel.type", kernel.name());
  kernel.each_parameter([&](const char* name, const auto& value) { archive.same(name, value); });
}

/// The problem that a state belongs to.
void archive_problem(Archive& archive, const TransientProblem& problem) {
  const Index n = problem.grid.size();
  archive.same("scheme", name_of(problem.scheme));
  archive_kernel(archive, problem.contact.kernel);
  if (problem.contact.has_unlike_bodies())
    archive.same("pressure_strain", problem.contact.pressure_strain);
  archive.same("grid.elements", static_cast<double>(n));
  archive.same("contact.half_width", problem.grid.half_width());
  archive.same("basis", problem.basis.name());
  const bool fft = by_fft(problem.solver, problem.basis, n);
  archive.same("solver.type", fft ? "fft" : "dense");
  archive.same("solver.tolerance", problem.solver.tolerance);
  const VectorXd nodes = problem.grid.nodes();
  archive.same("bound", bound_at(problem.contact.bound, nodes));
  const VectorXd lengths = VectorXd::Constant(n, problem.grid.spacing());
  archive.same("mean_bound", element_means(problem.contact.bound, nodes, lengths));
  archive_friction(archive, problem.friction);
}

void archive_count(Archive& archive, std::string_view name, int& count) {
  Index value = count;
  archive.whole(name, value, 0, std::numeric_limits<int>::max());
  count = static_cast<int>(value);
}

void archive_evidence(Archive& archive, Evidence& evidence) {
  archive.number("residual", evidence.residual);
  archive.number("excess", evidence.excess);
  archive.number("backward", evidence.backward);
  archive.number("unresolved", evidence.unresolved);
  archive.number("dissipated", evidence.dissipated);
  archive.number("load", evidence.load);
  archive.number("power", evidence.power);
  archive.number("full_sliding", evidence.full_sliding);
}

/// All but the distance.
void archive_state(Archive& archive, TransientState& state, Index size) {
  archive_contact(archive, state.scale);
  archive.numbers("traction", state.traction, size);
  archive.numbers("slip", state.slip, size);
  archive_zones(archive, "zones", state.zones, size);
  archive.number("force", state.force);
  archive.number("creepage", state.creepage);
  archive.number("dissipation", state.dissipation);
  archive.number("end_dissipation", state.end_dissipation);
  archive.number("mean_force", state.mean_force);
  archive_count(archive, "iterations", state.iterations);
  archive_evidence(archive, state.evidence);
  archive.whole("adhesion_elements", state.adhesion_elements, 0, size);
  archive.whole("slip_elements", state.slip_elements, 0, size);
}

/// The length and load of a step.
void archive_step(Archive& archive, std::pair<double, Load>& step) {
  auto [by_force, value] = Prescribed(step.second);
  archive.number("step_length", step.first);
  archive.flag("step_by_force", by_force);
  archive.number("step_load", value);
  step.second = by_force ? Load(PrescribedForce{value}) : Load(PrescribedCreepage{value});
}

}  // namespace

void TransientRolling::archive(Archive& archive) {
  const Index n = problem_.grid.size();
  archive_problem(archive, problem_);
  archive.number("distance", state_.distance);
  bool is_attempt = solved_.has_value();
  archive.flag("step_is_tried", is_attempt);
  grid_->archive(archive, is_attempt);
  archive_state(archive, state_, n);
  if (!is_attempt) return;
  if (archive.reads()) solved_.emplace(0, PrescribedCreepage{0});
  archive_step(archive, *solved_);
  archive.number("distance", next_.distance);
  archive_state(archive, next_, n);
}

std::string TransientRolling::save() {
  Archive members;
  archive(members);
  return format.sealed(members.text());
}

void TransientRolling::restore(const SavedState& saved) {
  *this = TransientRolling(problem_, saved);
}

double distance_of(const SavedState& saved, const TransientProblem& problem) {
  Archive archive(format.members_of(saved.text));
  archive_problem(archive, problem);
  double distance = 0;
  archive.number("distance", distance);
  return distance;
}

/// Nothing has happened to the grid yet.
void TransientRolling::read(const SavedState& saved) {
  Archive members(format.members_of(saved.text));
  archive(members);
  members.require_end();
}

}  // namespace microslip
