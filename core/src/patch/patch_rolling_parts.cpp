// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_rolling_parts.hpp"

#include <cmath>
#include <utility>

#include "component_pairs.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"
#include "patch_evidence.hpp"
#include "patch_friction.hpp"
#include "slip_maps.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// Corrections from which on a follower is prepared anew.
constexpr int many_corrections = 6;

}  // namespace

void require_contact(const ContactScale& scale, const PatchShape& shape) {
  using Ranges = PatchStepRanges;
  const auto& [size, bound] = scale;
  require(size == 0 || (size >= Ranges::least_size && size <= Ranges::largest_size), "size_factor",
          size, "1e-4 ... 100 times that of the problem, or 0 of bodies that do not touch");
  require(bound == 0 || (bound >= Ranges::least_bound && bound <= Ranges::largest_bound),
          "bound_factor", bound,
          "1e-6 ... 1e6 times that of the problem, or 0 of bodies without friction");
  require(size == 1 || shape.is_ellipse(), "size_factor", size,
          "1 of a contact that is no ellipse: it has one size");
}

PatchConstants::PatchConstants(const SteadyPatch& given)
    : problem(given),
      units(given.material, given.bound.peak(), given.bound.size()),
      rows(rows_of(given)),
      displacement(displacement_by_traction(rows, given.material.poisson_ratio)),
      limits(limits_of(rows, given.bound)),
      resultants(resultants_by_traction(rows)) {}

PatchRolling::Parts::Parts(std::shared_ptr<const PatchConstants> given, const ContactScale& contact)
    : constants(std::move(given)),
      turned_constants(constants->problem.bound.is_hertz() ? constants : nullptr),
      material(constants->rows, contact.half_width),
      now(contact),
      next(contact),
      displacements(constants->rows, constants->displacement) {
  const Index n = constants->rows.cells();
  state.unknowns = state.own_slip = state.centre_slip = state.seen_slip = VectorXd::Zero(2 * n);
  state.carried = VectorXd::Ones(n);
  state.motion.setZero();
  state.slips.assign(static_cast<std::size_t>(n), false);
  before = state;
  begin_friction();
}

/// Lets the material begin with the friction at rest, and the speed as it is.
void PatchRolling::Parts::begin_friction() {
  const std::optional<SlipFriction>& law = constants->problem.friction;
  if (!law) return;
  const double speed = friction ? friction->friction().speed : law->speed;
  friction.emplace(constants->rows, *law, units().size, now.carries() ? now.half_width : 1);
  friction->set_speed(speed);
  slipping_limits = now.bound * constants->limits;
}

VectorXd PatchRolling::Parts::bound() const {
  const PatchConstants& of = forward();
  const double bound = now.carries() ? now.bound : 0;
  return bound * tractions_of(of.rows, of.limits.replicate(2, 1), 1).col(0);
}

PatchRolling::Parts PatchRolling::Parts::at_rest() const {
  Parts rest(backward ? turned_constants : constants, next);
  rest.turned_constants = backward ? constants : turned_constants;
  if (friction) rest.friction->set_speed(friction->friction().speed);
  return rest;
}

void PatchRolling::Parts::start_from(const Eigen::MatrixX2d& tractions) {
  const JoinedRows& rows = constants->rows;
  const VectorXd ones = VectorXd::Ones(2 * rows.cells());
  const Eigen::MatrixX2d given = tractions_within(tractions, bound());
  begin(given.cwiseQuotient(tractions_of(rows, ones, 1)).reshaped(), 0);
}

void PatchRolling::Parts::begin(const VectorXd& unknowns, double distance) {
  state.unknowns = unknowns;
  before = state;
  material = PatchMaterial(constants->rows, now.half_width, distance);
  begin_friction();
  if (!now.carries()) return;
  displacements.set(state.unknowns, now.half_width);
  material.begin(displacements);
}

/// The cells of each row in the reversed order, if the patch rolls backward.
VectorXd PatchRolling::Parts::cells_in_frame(const VectorXd& of_cells) const {
  if (!backward) return of_cells;
  const Index n = constants->rows.elements();
  return of_cells.reshaped(n, of_cells.size() / n).colwise().reverse().reshaped();
}

Eigen::MatrixX2d PatchRolling::Parts::vectors_in_frame(const Eigen::MatrixX2d& of_cells,
                                                       const Vector3d& signs) const {
  if (!backward) return of_cells;
  const VectorXd values = cells_in_frame(of_cells.reshaped());
  const Eigen::MatrixX2d seen = values.reshaped(of_cells.rows(), 2);
  return (seen * signs.head<2>().asDiagonal()).array() + 0.0;  // 0 of a zero, and not -0
}

/// A traction p = tan(theta/2) v is that at theta' = pi - theta, so that v' = tan(theta/2)^2 v.
PatchRolling::Parts PatchRolling::Parts::turned() const {
  auto of = turned_constants;
  if (of == nullptr) {
    SteadyPatch problem = constants->problem;
    problem.bound = problem.bound.turned();
    of = std::make_shared<const PatchConstants>(problem);
  }
  Parts there(of, now);
  there.turned_constants = constants;
  there.backward = !backward;
  there.next = next;
  if (of == constants) {
    there.response = response;
    there.limits = limits;
  }
  const JoinedRows& rows = constants->rows;
  VectorXd unknowns(2 * rows.cells());
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      const double factor = std::pow(std::tan(rows.theta(i) / 2), 2);
      const Eigen::Vector2d v = factor * pair_of(state.unknowns, rows.cell(i, k));
      set_pair(unknowns, rows.cell(rows.elements() - 1 - i, k), {-v[0], v[1]});
    }
  }
  there.begin(unknowns, -material.distance());
  return there;
}

Vector3d PatchRolling::Parts::resultant_signs() const {
  return backward ? Vector3d(-1, 1, -1) : Vector3d::Ones();
}

Vector3d PatchRolling::Parts::motion_signs() const {
  return step.dq > 0 && backward ? Vector3d(1, -1, 1) : resultant_signs();
}

PatchLoad PatchRolling::Parts::in_frame(const PatchLoad& load, bool rolls) const {
  PatchLoad seen = load;
  for (std::size_t j = 0; backward && j < load.size(); ++j) {
    const bool is_lateral = j == 1, is_creepage = rolls && !load[j].by_resultant;
    if (is_lateral == is_creepage) seen[j].value = 0 - load[j].value;
  }
  return seen;
}

VectorXd PatchRolling::Parts::shares() const {
  const Index n = constants->rows.cells();
  return now.half_width * now.half_width * constants->resultants.row(0).head(n).transpose();
}

Vector3d PatchRolling::Parts::resultants_of(const PatchState& of, double size) const {
  return PatchConstants::by_size(size).cwiseProduct(constants->resultants * of.unknowns);
}

double PatchRolling::Parts::elastic_energy_of(const PatchState& of, double size) const {
  const JoinedRows& rows = constants->rows;
  double energy = 0;
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      const Index cell = rows.cell(i, k), point = rows.point(2 * i + 1, k);
      const Eigen::Vector2d u(constants->displacement.row(point).dot(of.unknowns),
                              constants->displacement.row(rows.points() + point).dot(of.unknowns));
      energy += constants->resultants(0, cell) * pair_of(of.unknowns, cell).dot(u) / 2;
    }
  }
  return size * size * size * energy;
}

double PatchRolling::Parts::lost() {
  if (dissipation) return *dissipation;
  if (step.dq == 0) {
    dissipation = friction_of(state, shares(), last_limits()).dissipated;
  } else {
    const Vector3d mean = (resultants_of(before, step.from) + resultants()) / 2;
    const double stored = elastic_energy() - elastic_energy_of(before, step.from);
    dissipation = -mean.dot(state.motion) - stored / step.dq;
  }
  return *dissipation;
}

const PatchResponse& PatchRolling::Parts::response_of(const PatchStep& wanted) {
  if (!response || response->step != wanted) {
    follows = false;
    const StepWays ways(constants->rows, wanted);
    response = std::make_shared<const StepResponse>(
        StepResponse{wanted, ways.response(constants->displacement)});
  }
  return response->of;
}

const VectorXd& PatchRolling::Parts::limits_of_bound(double bound) {
  if (!limits || limits->bound != bound) {
    follows = false;
    limits = std::make_shared<const StepLimits>(StepLimits{bound, bound * constants->limits});
  }
  return limits->values;
}

/// The load of the next step, over the units of a contact of its size.
PatchLoad PatchRolling::Parts::scaled(const PatchLoad& load, bool rolls) const {
  const Vector3d by_size = PatchConstants::by_size(next.half_width);
  require_carried(load, constants->problem.bound, next);
  PatchLoad scaled = units().scaled(load, rolls ? units().motion : units().shift);
  for (std::size_t j = 0; j < scaled.size(); ++j) {
    if (scaled[j].by_resultant) {
      if (next.carries()) scaled[j].value /= by_size[static_cast<Index>(j)];
      continue;
    }
    require(std::abs(scaled[j].value) <= PatchStepRanges::largest_motion, name_of(load, j),
            load[j].value, "a motion of at most 1e8 times that by the bound's strain");
  }
  return scaled;
}

void PatchRolling::Parts::prepare_follower(const PatchResponse& of, const VectorXd& limits_now,
                                           const PatchState& with, const PatchLoad& load) {
  follows = false;
  follower.emplace(of, limits_now, with, load);
  follows = true;
}

/// Solves a step into `trial`, from the state before it. If the same cells slip in two steps that
/// are solved anew, the next ones may follow.
void PatchRolling::Parts::solve(const PatchResponse& of, const VectorXd& limits_now,
                                const PatchLoad& load, Discs discs) {
  trial = state;
  const bool can_follow = follows && follower->fits(load, state.slips);
  const bool followed = can_follow && follower->follow(load, imposed, trial);
  if (!followed) trial = solve_stick_slip(of, limits_now, load, &state, &imposed, discs);
  const bool is_slow = followed && trial.iterations >= many_corrections;
  if (is_slow || (!followed && trial.slips == state.slips)) {
    prepare_follower(of, limits_now, trial, load);
  } else if (!followed) {
    follows = false;
  }
}

/// The same where friction depends on slip. A shift has no speed: friction stays as it is.
/// \param rows  in: before the step; out: after it
void PatchRolling::Parts::solve_slipping(const PatchStep& taken, const PatchResponse& of,
                                         const PatchLoad& load, FrictionRows& rows) {
  const VectorXd& at_rest = limits_of_bound(next.bound);
  if (taken.dq == 0) {
    const VectorXd kept = rows.ratios().cwiseProduct(at_rest);
    trial = solve_stick_slip(of, kept, load, &state, &imposed);
    slipping_limits = kept;
    return;
  }
  SlippingPatch patch(
      {.response = of, .at_rest = at_rest, .load = load, .start = &state, .imposed = &imposed},
      rows, taken.dq, units().motion[0] * rows.friction().speed);
  has_second = solve_by_friction(patch, rows.friction().branch);
  trial = patch.state();
  rows.take(taken.dq, patch.speeds());
  slipping_limits = patch.limits();
}

void PatchRolling::Parts::take(double dq, const PatchLoad& load, Discs discs) {
  const PatchLoad wanted = scaled(load, dq > 0);
  const PatchStep taken{.dq = dq,
                        .from = now.half_width,
                        .to = next.half_width,
                        .ratio = dq > 0 ? material.ratio_before(dq) : 0};
  const PatchResponse& of = response_of(taken);
  displacements.set(state.unknowns, taken.from);
  std::optional<PatchMaterial> moved_rows;
  if (taken.to != taken.from) moved_rows = material.resized(constants->rows, taken.to);
  (moved_rows ? *moved_rows : material).impose(taken, displacements, state.seen_slip, imposed);
  has_second = false;
  if (friction) {
    FrictionRows rows = *friction;
    if (!now.carries())
      rows = FrictionRows(constants->rows, rows.friction(), units().size, taken.to);
    if (taken.to != rows.size()) rows.resize(taken.to);
    solve_slipping(taken, of, wanted, rows);
    friction = std::move(rows);
  } else {
    solve(of, limits_of_bound(next.bound), wanted, discs);
  }
  std::swap(before, state);
  std::swap(state, trial);
  step = taken;
  moved = true;
  now = next;
  dissipation.reset();
  displacements.set(state.unknowns, taken.to);
  if (moved_rows) material = std::move(*moved_rows);
  material.take(step, displacements, state.motion, state.slips);
}

/// Parts the bodies, or takes their friction, until the end of a step. All tractions end, and the
/// material forgets. What follows from a resultant does not move.
void PatchRolling::Parts::lose(double dq, const PatchLoad& load) {
  const PatchLoad wanted = scaled(load, dq > 0);
  const Vector3d mean = resultants() / 2;
  const double stored = elastic_energy();
  std::swap(before, state);
  state = at_rest().state;
  for (std::size_t j = 0; j < wanted.size(); ++j) {
    if (!wanted[j].by_resultant) state.motion[static_cast<Index>(j)] = wanted[j].value;
  }
  step = {.dq = dq, .from = now.half_width, .to = next.half_width};
  moved = true;
  follows = false;
  now = next;
  dissipation = -mean.dot(state.motion) + stored / (dq > 0 ? dq : 1);
  material = PatchMaterial(constants->rows, now.half_width, material.distance() + dq);
  has_second = false;
  begin_friction();
}

/// Motions before the bodies touch are no slip.
void PatchRolling::Parts::shift(const PatchLoad& load) {
  if (!next.carries()) return lose(0, load);
  if (now.carries()) return take(0, load);
  const PatchLoad wanted = scaled(load, false);
  Parts touching = *this;
  touching.now = next;
  touching.begin(state.unknowns, material.distance());
  PatchLoad carried = load;
  for (PatchComponent& component : carried) {
    if (!component.by_resultant) component.value = 0;
  }
  touching.take(0, carried);
  for (std::size_t j = 0; j < wanted.size(); ++j) {
    if (!wanted[j].by_resultant) touching.state.motion[static_cast<Index>(j)] = wanted[j].value;
  }
  *this = std::move(touching);
}

/// The load in the middle of a step to the next contact. Resultants are the mean part of the largest
/// ones; in a contact that begins, the part that they are at its end.
PatchLoad PatchRolling::Parts::middle_of(const PatchLoad& load, const ContactScale& middle) const {
  const auto largest_in = [&](const ContactScale& contact) {
    return largest_resultants(constants->problem.bound, contact).eval();
  };
  const Vector3d largest = largest_in(middle), at_end = largest_in(next), before = largest_in(now);
  const Vector3d from = resultants().cwiseProduct(units().resultant);
  PatchLoad found = load;
  for (std::size_t j = 0; j < found.size(); ++j) {
    if (!found[j].by_resultant) continue;
    const auto i = static_cast<Index>(j);
    const double end = load[j].value / at_end[i];
    found[j].value = largest[i] * (now.carries() ? (from[i] / before[i] + end) / 2 : end);
  }
  return found;
}

void PatchRolling::Parts::roll(double dq, const PatchLoad& load, int divisions) {
  if (!next.carries()) return lose(dq, load);
  try {
    return take(dq, load);
  } catch (const NotConverged&) {
    if (divisions == 0 && friction) throw;
  }
  if (divisions == 0) return take(dq, load, Discs::of_start);
  Parts halves = *this;
  halves.next = between(now, next, 0.5);
  halves.roll(dq / 2, middle_of(load, halves.next), divisions - 1);
  const Vector3d motion = halves.state.motion;
  const double lost = halves.lost();
  const int iterations = halves.state.iterations;
  const bool first_has_second = halves.has_second;
  halves.next = next;
  halves.roll(dq / 2, load, divisions - 1);
  halves.dissipation = (lost + halves.lost()) / 2;
  halves.state.motion = (motion + halves.state.motion) / 2;
  halves.state.iterations += iterations;
  halves.has_second = halves.has_second || first_has_second;
  *this = std::move(halves);
}

}  // namespace microslip
