// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/patch_rolling.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "microslip/support/require.hpp"
#include "patch_evidence.hpp"
#include "patch_rolling_parts.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixX2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// Halvings of a step that is not solved.
constexpr int most_divisions = 6;

/// A sum with 0 is 0 of a zero, and not -0.
Vector3d signed_by(const Vector3d& signs, const Vector3d& values) {
  return signs.cwiseProduct(values).array() + 0.0;
}

}  // namespace

void require_carried(const PatchLoad& load, const PatchBound& bound, const ContactScale& contact) {
  const Vector3d largest = largest_resultants(bound, contact);
  if (contact.carries()) return validate(load, largest[0], largest[2]);
  for (std::size_t j = 0; j < load.size(); ++j) {
    const auto& [by_resultant, value] = load[j];
    require(!by_resultant || value == 0, name_of(load, j), value,
            by_resultant ? "0 where bodies do not touch, or have no friction" : "a finite number");
  }
}

Vector3d largest_resultants(const PatchBound& bound, const ContactScale& contact) {
  const auto& [size, height] = contact;
  const double force = size * size * height;
  return {force * bound.total(), force * bound.total(), force * size * bound.turning_moment()};
}

PatchRolling::PatchRolling(const SteadyPatch& problem, const ContactScale& contact) {
  validate(problem);
  require_contact(contact, problem.bound.shape());
  parts_ = std::make_unique<Parts>(std::make_shared<const PatchConstants>(problem), contact);
}
PatchRolling::~PatchRolling() = default;
PatchRolling::PatchRolling(const PatchRolling& other)
    : parts_(std::make_unique<Parts>(*other.parts_)) {}
PatchRolling::PatchRolling(PatchRolling&&) noexcept = default;
PatchRolling& PatchRolling::operator=(const PatchRolling& other) {
  if (this == &other) return *this;
  if (parts_ != nullptr && parts_->constants == other.parts_->constants) {
    *parts_ = *other.parts_;  // has room for it
  } else {
    parts_ = std::make_unique<Parts>(*other.parts_);
  }
  return *this;
}
PatchRolling& PatchRolling::operator=(PatchRolling&&) noexcept = default;

void PatchRolling::set_contact(const ContactScale& scale) {
  require_contact(scale, parts_->constants->problem.bound.shape());
  parts_->next = scale;
}

void PatchRolling::set_speed(double speed) {
  require_positive("speed", speed);
  if (parts_->friction) parts_->friction->set_speed(speed);
}

bool PatchRolling::has_second() const { return parts_->has_second; }

const ContactScale& PatchRolling::contact() const { return parts_->next; }

void PatchRolling::start_from(const MatrixX2d& tractions) {
  Parts fresh = parts_->at_rest();
  fresh.start_from(tractions / parts_->units().peak);
  *parts_ = std::move(fresh);
}

void PatchRolling::shift(const PatchLoad& load) {
  if (parts_->friction && parts_->material.distance() > 0) {
    throw std::invalid_argument("friction_law: expected none where bodies that rolled stand");
  }
  const double size = parts_->next.half_width;
  const bool keeps_contact = parts_->next.carries() && parts_->now.carries();
  require(!keeps_contact || size == parts_->now.half_width, "size_factor", size,
          "that of the contact before a shift, which changes no lengths but to and from 0");
  if (parts_->backward) parts_->require_load(load, false);
  parts_->shift(parts_->in_frame(load, false));
}

void PatchRolling::roll(double dq, const PatchLoad& load) {
  const double c = parts_->units().size;
  const double least = PatchStepRanges::least_step * c;
  const double longest = PatchStepRanges::longest_step * c;
  const double length = std::abs(dq);
  require(length >= least && length <= longest, "dq", dq, [&] {
    return fmt::format("a length from {0:.6g} to {1:.6g}, or back from -{0:.6g} to -{1:.6g}", least,
                       longest);
  });
  const bool backward = dq < 0;
  if (backward && parts_->friction) {
    throw std::invalid_argument("friction_law: expected none where the bodies roll back");
  }
  if (backward) parts_->require_load(load, true);
  if (backward == parts_->backward) {
    return parts_->roll(length / c, parts_->in_frame(load, true), most_divisions);
  }
  Parts turned = parts_->turned();
  turned.roll(length / c, turned.in_frame(load, true), most_divisions);
  *parts_ = std::move(turned);
}

double PatchRolling::distance() const {
  const double distance = parts_->material.distance() * parts_->units().size;
  return parts_->backward ? 0 - distance : distance;
}

VectorXd PatchRolling::x() const {
  return parts_->size() * centres_of(parts_->forward().rows).col(0);
}

VectorXd PatchRolling::y() const {
  return parts_->size() * centres_of(parts_->forward().rows).col(1);
}

VectorXd PatchRolling::areas() const {
  const double size = parts_->size();
  return size * size * parts_->forward().rows.areas();
}

VectorXd PatchRolling::bound() const {
  const VectorXd at_rest = parts_->units().peak * parts_->bound();
  return parts_->friction ? at_rest.cwiseProduct(parts_->friction->ratios()) : at_rest;
}

MatrixX2d PatchRolling::tractions() const {
  return parts_->vectors_in_frame(
      tractions_of(parts_->constants->rows,
                   within_limits(parts_->state.unknowns, parts_->last_limits()),
                   parts_->units().peak),
      parts_->resultant_signs());
}

MatrixX2d PatchRolling::slip() const {
  return parts_->vectors_in_frame(parts_->motion_unit()[0] * slip_of(parts_->state),
                                  parts_->motion_signs());
}

std::vector<bool> PatchRolling::slips() const {
  std::vector<bool> slips = parts_->state.slips;
  if (!parts_->backward) return slips;
  const auto n = static_cast<std::ptrdiff_t>(parts_->constants->rows.elements());
  for (auto row = slips.begin(); row != slips.end(); row += n) std::reverse(row, row + n);
  return slips;
}

double PatchRolling::full_sliding() const {
  return largest_resultants(parts_->constants->problem.bound, parts_->now)[0];
}

Vector3d PatchRolling::resultants() const {
  return signed_by(parts_->resultant_signs(),
                   parts_->resultants().cwiseProduct(parts_->units().resultant));
}

Vector3d PatchRolling::motion() const {
  return signed_by(parts_->motion_signs(),
                   parts_->state.motion.cwiseProduct(parts_->motion_unit()));
}

double PatchRolling::elastic_energy() const {
  return parts_->elastic_energy() * parts_->units().shift[0] * parts_->units().resultant[0];
}

double PatchRolling::dissipation() const {
  return parts_->lost() * parts_->motion_unit()[0] * parts_->units().resultant[0];
}

Matrix3d PatchRolling::jacobian() const {
  Parts& p = *parts_;
  if (!p.moved) throw std::logic_error("a Jacobian is that of a step");
  if (p.friction) {
    throw std::invalid_argument(
        "friction_law: expected none where derivatives of steps are asked for");
  }
  if (!p.now.carries()) return Matrix3d::Zero();
  const PatchResponse& of = p.last_response();
  const Matrix3d scaled = stick_slip_jacobian(of, p.last_limits(), p.state);
  const Vector3d by_size = PatchConstants::by_size(p.now.half_width);
  const Vector3d resultant = p.resultant_signs().cwiseProduct(p.units().resultant);
  const Vector3d motion = p.motion_signs().cwiseProduct(p.motion_unit());
  return by_size.cwiseProduct(resultant).asDiagonal() * scaled * motion.cwiseInverse().asDiagonal();
}

int PatchRolling::iterations() const { return parts_->state.iterations; }
double PatchRolling::residual() const { return parts_->state.residual; }

double PatchRolling::condition() const { return parts_->condition(); }

Evidence PatchRolling::evidence() const {
  Parts& p = *parts_;
  const double force = p.units().resultant[0];
  const VectorXd areas = p.constants->rows.areas();
  Evidence evidence =
      evidence_of_cells(p.state, p.shares(), p.last_limits(),
                        {.force = force,
                         .power = p.motion_unit()[0] * force,
                         .full_sliding = full_sliding(),
                         .slip_share = slip_area_of(areas, p.state.slips) / areas.sum()},
                        p.friction ? p.limits_at_rest() : p.last_limits());
  evidence.load = resultants().head<2>().norm();
  evidence.power = std::max(std::abs(motion().dot(resultants())), std::abs(dissipation()));
  return evidence;
}

}  // namespace microslip
