// SPDX-License-Identifier: GPL-3.0-or-later
#include "rolled_patch.hpp"

#include <cmath>
#include <vector>

#include "patch_tables.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::MatrixX2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

VectorXd areas_of(const PatchRolling& rolling) { return rolling.areas(); }

VectorXd areas_of(const RectangleRolling& rolling) {
  return VectorXd::Constant(rolling.size(), rolling.area());
}

/// \param areas  0 where the bodies do not touch
double slip_share_of(const VectorXd& areas, const std::vector<bool>& slips) {
  const double area = areas.sum();
  return area > 0 ? slip_area_of(areas, slips) / area : 0;
}

Evidence evidence_of(const PatchRolling& rolling, const PatchBound&) { return rolling.evidence(); }

Evidence evidence_of(const RectangleRolling& rolling, const PatchBound& whole) {
  Evidence evidence;
  evidence.residual = rolling.residual();
  evidence.load = rolling.resultants().head<2>().norm();
  evidence.full_sliding = whole.total();
  const MatrixX2d tractions = rolling.tractions(), slip = rolling.slip();
  const VectorXd bound = rolling.bound();
  const double area = rolling.area();
  for (Index i = 0; i < bound.size(); ++i) {
    if (!rolling.slips()[static_cast<std::size_t>(i)]) continue;
    const double power = area * tractions.row(i).dot(slip.row(i));
    evidence.excess += area * std::max(0.0, tractions.row(i).norm() - bound[i]);
    evidence.backward += std::max(0.0, power);
    evidence.dissipated -= power;
  }
  const double share = slip_share_of(areas_of(rolling), rolling.slips());
  evidence.power =
      std::max(std::abs(rolling.motion().dot(rolling.resultants())), evidence.dissipated);
  evidence.unresolved = share * std::abs(area * bound.sum() - evidence.full_sliding);
  return evidence;
}

bool has_second(const PatchRolling& rolling) { return rolling.has_second(); }
bool has_second(const RectangleRolling&) { return false; }

ContactScale present_contact(const PatchRolling& rolling) { return rolling.contact(); }
ContactScale present_contact(const RectangleRolling&) { return {}; }

}  // namespace

RolledPatch::AnyRolling RolledPatch::rolling_of(const SteadyPatch& patch,
                                                const AdvectionScheme& scheme,
                                                const ContactScale& contact) {
  if (std::holds_alternative<Remembered>(scheme)) return PatchRolling(patch, contact);
  const PatchBound& bound = patch.bound;
  const auto* relaxed = std::get_if<Relaxed>(&scheme);
  return RectangleRolling({.material = patch.material,
                           .bound = {bound.half_width(), bound.lateral_half_width(), bound.peak()},
                           .elements = patch.elements,
                           .rows = patch.rows,
                           .relaxation = relaxed == nullptr ? 0 : relaxed->step_ratio});
}

RolledPatch::RolledPatch(const SteadyPatch& patch, const AdvectionScheme& scheme,
                         const ContactScale& contact)
    : patch_(patch), rolling_(rolling_of(patch, scheme, contact)) {}

PatchStepEnd RolledPatch::start_from(const TractionTable& tractions) {
  std::visit(
      [&](auto& of) {
        const double size = present_contact(of).half_width;
        const VectorXd x = of.x() / size, y = of.y() / size, bound = of.bound();
        MatrixX2d at(x.size(), 2);
        for (Index i = 0; i < x.size(); ++i) at.row(i) = bound[i] * tractions(x[i], y[i]);
        of.start_from(at);
      },
      rolling_);
  return end();
}

/// A resultant of the load is exact, that of the state has the rounding of its solution; the load
/// before may have been another one.
PatchStepEnd RolledPatch::restore(const SavedState& state, const PatchLoad& load) {
  constexpr double of_resultants = 1e-6, of_motions = 1e-12;
  std::get<PatchRolling>(rolling_).restore(state);
  PatchStepEnd found = end();
  const Vector3d largest = largest_resultants(patch_.bound, found.contact);
  for (std::size_t j = 0; j < load.size(); ++j) {
    const auto& [by_resultant, value] = load[j];
    const auto i = static_cast<Index>(j);
    double& known = (by_resultant ? found.resultants : found.motion)[i];
    const double close = by_resultant ? of_resultants * largest[i] : of_motions * std::abs(value);
    if (std::abs(known - value) <= close) known = value;
  }
  return found;
}

PatchStepEnd RolledPatch::shift(const PatchLoad& load, const std::optional<ContactScale>& contact) {
  if (contact) std::get<PatchRolling>(rolling_).set_contact(*contact);
  std::visit([&](auto& of) { of.shift(load); }, rolling_);
  return end(load);
}

PatchStepEnd RolledPatch::roll(const PatchHistory& loads, double from, double to, double length) {
  const PatchLoad load = loads.between(from, to);
  if (loads.changes_contact()) {
    std::get<PatchRolling>(rolling_).set_contact(loads.contact_at(to));
  }
  if (patch_.friction && loads.time_at(from)) {
    std::get<PatchRolling>(rolling_).set_speed(length /
                                               (*loads.time_at(to) - *loads.time_at(from)));
  }
  std::visit([&](auto& of) { of.roll(loads.direction_to(to) * length, load); }, rolling_);
  return end(load);
}

PatchStepEnd RolledPatch::end() const {
  return std::visit(
      [&](const auto& of) {
        return PatchStepEnd{.resultants = of.resultants(),
                            .motion = of.motion(),
                            .slip_share = slip_share_of(areas_of(of), of.slips()),
                            .dissipation = of.dissipation(),
                            .iterations = of.iterations(),
                            .contact = present_contact(of),
                            .has_second = has_second(of),
                            .evidence = evidence_of(of, patch_.bound)};
      },
      rolling_);
}

PatchStepEnd RolledPatch::end(const PatchLoad& load) const {
  PatchStepEnd found = end();
  for (std::size_t j = 0; j < load.size(); ++j) {  // without rounding
    (load[j].by_resultant ? found.resultants : found.motion)[static_cast<Index>(j)] = load[j].value;
  }
  return found;
}

double RolledPatch::full_sliding() const {
  return remembered() ? remembered()->full_sliding() : patch_.bound.total();
}

Table RolledPatch::tractions() const {
  return std::visit(
      [&](const auto& of) {
        return patch_traction_table("transient rolling", {of.x(), of.y(), areas_of(of), of.bound(),
                                                          of.tractions(), of.slip(), of.slips()});
      },
      rolling_);
}

Table RolledPatch::edges() const {
  const auto* rectangles = std::get_if<RectangleRolling>(&rolling_);
  if (rectangles == nullptr) return patch_edges_table(patch_, remembered()->contact().half_width);
  return rectangles_edges_table(rectangles->x(), rectangles->y(), rectangles->element(),
                                rectangles->area() / rectangles->element());
}

std::optional<double> RolledPatch::condition() const {
  if (!remembered()) return std::nullopt;
  return remembered()->condition();
}

void MotionChange::include(const Vector3d& from, const Vector3d& to) {
  const Vector3d units(1, 1, size);
  changes = changes.cwiseMax((to - from).cwiseProduct(units).cwiseAbs());
  largest = largest.cwiseMax(to.cwiseProduct(units).cwiseAbs());
}

double MotionChange::relative() const {
  const double creep = largest.head<2>().maxCoeff(), spin = largest[2];
  return std::max(creep > 0 ? changes.head<2>().maxCoeff() / creep : 0,
                  spin > 0 ? changes[2] / spin : 0);
}

CoarsePatch::CoarsePatch(const SteadyPatch& patch, const AdvectionScheme& scheme,
                         const ContactScale& contact)
    : bound_(patch.bound) {
  if (const auto fewer = with_fewer_elements(patch)) rolled_.emplace(*fewer, scheme, contact);
}

void CoarsePatch::compare(const PatchStepEnd& fine, const PatchStepEnd& coarse, double length) {
  if (fine.contact.carries()) {
    const Vector3d largest = largest_resultants(bound_, fine.contact);
    const Vector3d of_resultants = (coarse.resultants - fine.resultants).cwiseQuotient(largest);
    of_resultants_ = std::max(of_resultants_, of_resultants.lpNorm<Eigen::Infinity>());
  }
  path_ += length * fine.motion;
  coarse_path_ += length * coarse.motion;
  of_path_.include(coarse_path_, path_);
  of_last_ = {bound_.size()};
  of_last_.include(coarse.motion, fine.motion);
}

double CoarsePatch::change() const {
  if (!rolled_) return 1;
  return std::max({of_resultants_, of_path_.relative(), of_last_.relative()});
}

}  // namespace microslip::experiments
