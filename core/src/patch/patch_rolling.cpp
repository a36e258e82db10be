// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/patch_rolling.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "component_pairs.hpp"
#include "microslip/support/archive.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/sealed_text.hpp"
#include "patch_evidence.hpp"
#include "patch_material.hpp"
#include "patch_scale.hpp"
#include "slip_maps.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixX2d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// Lengths of steps over the size of the patch. Records that are closer than the least one have no
/// digits of a slope between them.
constexpr double least_step = 1e-6, longest_step = 1e6;

/// Displacements are lost beside larger ones, in what the material remembers.
constexpr double largest_motion_of_step = 1e8;

/// Contacts over the problem's.
constexpr double largest_size = 100, largest_bound = 1e6;

/// Halvings of a step that is not solved.
constexpr int most_divisions = 6;

constexpr SealedText state_of_patch{.mark = "microslip state of a patch ", .version = "1"};

void require_contact(const ContactScale& scale, const PatchShape& shape) {
  const auto& [size, bound] = scale;
  require(size >= 1 / largest_size && size <= largest_size, "half_width", size,
          "0.01 ... 100 times that of the problem");
  require(bound >= 1 / largest_bound && bound <= largest_bound, "bound", bound,
          "1e-6 ... 1e6 times that of the problem");
  require(size == 1 || shape.is_ellipse(), "half_width", size,
          "1 of a contact that is no ellipse: it has one size");
}

/// All that stays the same. Lengths, tractions and energies are in units by which the size of the
/// problem's patch, the bound's peak and the shear modulus are 1.
struct PatchConstants {
  SteadyPatch problem;
  PatchUnits units;
  JoinedRows rows;
  MatrixXd displacement;  ///< by tractions, at points
  VectorXd limits;
  Eigen::Matrix3Xd resultants;

  explicit PatchConstants(const SteadyPatch& given)
      : problem(given),
        units(given.material, given.bound.peak(), given.bound.size()),
        rows(rows_of(given)),
        displacement(displacement_by_traction(rows, given.material.poisson_ratio)),
        limits(limits_of(rows, given.bound)),
        resultants(resultants_by_traction(rows)) {}

  /// The factors of resultants in a contact of a size.
  static Vector3d by_size(double size) { return size * size * Vector3d(1, 1, size); }
};

/// The response in steps of one kind.
struct StepResponse {
  PatchStep step;
  PatchResponse of;
};

/// The problem that a state belongs to.
void archive_problem(Archive& archive, const PatchConstants& constants) {
  const SteadyPatch& problem = constants.problem;
  archive.same("material.shear_modulus", problem.material.shear_modulus);
  archive.same("material.poisson_ratio", problem.material.poisson_ratio);
  archive.same("grid.rows", static_cast<double>(problem.rows));
  archive.same("grid.elements", static_cast<double>(problem.elements));
  archive.same("contact.size", problem.bound.size());
  archive.same("contact.peak_traction", problem.bound.peak());
  const MatrixX2d centres = centres_of(constants.rows);
  archive.same("x", VectorXd(centres.col(0)));
  archive.same("y", VectorXd(centres.col(1)));
  archive.same("bound", constants.limits);
}

void archive_state(Archive& archive, PatchState& state, Index cells) {
  archive.numbers("unknowns", state.unknowns, 2 * cells);
  archive.numbers("own_slip", state.own_slip, 2 * cells);
  archive.numbers("centre_slip", state.centre_slip, 2 * cells);
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
  archive.number("transition", state.transition);
}

}  // namespace

struct PatchRolling::Parts {
  std::shared_ptr<const PatchConstants> constants;
  PatchMaterial material;
  ContactScale now, next;  ///< at the end of the last step, and of the next one
  PatchState state;
  PatchStep step = {0};  ///< the last one
  bool moved = false;    ///< whether there was one
  double dissipation = 0;
  std::shared_ptr<const StepResponse> response = nullptr;

  Parts(std::shared_ptr<const PatchConstants> given, const ContactScale& contact)
      : constants(std::move(given)),
        material(constants->rows, contact.half_width),
        now(contact),
        next(contact) {
    const Index n = constants->rows.cells();
    state.unknowns = state.own_slip = state.centre_slip = VectorXd::Zero(2 * n);
    state.motion.setZero();
    state.slips.assign(static_cast<std::size_t>(n), false);
  }

  const PatchUnits& units() const { return constants->units; }
  const Vector3d& motion_unit() const { return step.dq > 0 ? units().motion : units().shift; }

  /// Integrals of tractions by the unknowns, over the size of the problem's patch.
  VectorXd shares() const {
    const Index n = constants->rows.cells();
    return now.half_width * now.half_width * constants->resultants.row(0).head(n).transpose();
  }

  Vector3d resultants() const {
    return PatchConstants::by_size(now.half_width)
        .cwiseProduct(constants->resultants * state.unknowns);
  }

  VectorXd displacements() const {
    return now.half_width * (constants->displacement * state.unknowns);
  }

  double elastic_energy(const VectorXd& u) const {
    const JoinedRows& rows = constants->rows;
    const VectorXd weights = shares();
    double energy = 0;
    for (Index k = 0; k < rows.rows(); ++k) {
      for (Index i = 0; i < rows.elements(); ++i) {
        const Index cell = rows.cell(i, k), point = rows.point(2 * i + 1, k);
        energy += weights[cell] * pair_of(state.unknowns, cell).dot(pair_of(u, point)) / 2;
      }
    }
    return energy;
  }

  VectorXd limits() const { return next.bound * constants->limits; }

  const PatchResponse& response_of(const PatchStep& wanted) {
    if (!response || response->step != wanted) {
      const StepWays ways(constants->rows, wanted);
      response = std::make_shared<const StepResponse>(
          StepResponse{wanted, ways.response(constants->displacement)});
    }
    return response->of;
  }

  /// The load of the next step, over the units of a contact of its size.
  PatchLoad scaled(const PatchLoad& load, bool rolls) const {
    const double size = next.half_width;
    const PatchBound& bound = constants->problem.bound;
    validate(load, bound.total() * size * size * next.bound,
             bound.turning_moment() * size * size * size * next.bound);
    PatchLoad scaled = units().scaled(load, rolls ? units().motion : units().shift);
    for (std::size_t j = 0; j < scaled.size(); ++j) {
      if (scaled[j].by_resultant) {
        scaled[j].value /= PatchConstants::by_size(size)[static_cast<Index>(j)];
        continue;
      }
      require(std::abs(scaled[j].value) <= largest_motion_of_step, name_of(load, j), load[j].value,
              "a motion of at most 1e8 times that by the bound's strain");
    }
    return scaled;
  }

  /// \param dq  0 for a shift
  void take(double dq, const PatchLoad& load) {
    const PatchLoad wanted = scaled(load, dq > 0);
    const PatchStep taken{.dq = dq,
                          .from = now.half_width,
                          .to = next.half_width,
                          .ratio = dq > 0 ? material.ratio_before(dq) : 0};
    const PatchResponse& of = response_of(taken);
    const ImposedSlip from = material.imposed(constants->rows, taken);
    const Vector3d resultants_before = resultants();
    const double energy_before = elastic_energy(material.displacements());
    state = solve_stick_slip(of, limits(), wanted, &state, &from);
    step = taken;
    moved = true;
    now = next;
    material.take(constants->rows, step, displacements(), state.motion, state.slips);
    if (dq == 0) {
      dissipation = friction_of(state, shares(), limits()).dissipated;
      return;
    }
    const Vector3d mean = (resultants_before + resultants()) / 2;
    dissipation =
        -mean.dot(state.motion) - (elastic_energy(material.displacements()) - energy_before) / dq;
  }

  /// The same; a step that is not solved is divided into halves, and these again.
  void roll(double dq, const PatchLoad& load, int divisions) {
    try {
      return take(dq, load);
    } catch (const NotConverged&) {
      if (divisions == 0) throw;
    }
    Parts halves = *this;
    const Vector3d from = resultants().cwiseProduct(units().resultant);
    PatchLoad middle = load;
    for (std::size_t j = 0; j < middle.size(); ++j) {
      if (middle[j].by_resultant)
        middle[j].value = (load[j].value + from[static_cast<Index>(j)]) / 2;
    }
    halves.next = between(now, next, 0.5);
    halves.roll(dq / 2, middle, divisions - 1);
    const Vector3d motion = halves.state.motion;
    const double lost = halves.dissipation;
    const int iterations = halves.state.iterations;
    halves.next = next;
    halves.roll(dq / 2, load, divisions - 1);
    halves.state.motion = (motion + halves.state.motion) / 2;
    halves.dissipation = (lost + halves.dissipation) / 2;
    halves.state.iterations += iterations;
    *this = std::move(halves);
  }

  void archive(Archive& archive) {
    const PatchConstants& of = *constants;
    archive_problem(archive, of);
    material.archive(archive, of.rows);
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
    archive.number("dissipation", dissipation);
    archive_state(archive, state, of.rows.cells());
  }
};

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
  if (this != &other) parts_ = std::make_unique<Parts>(*other.parts_);
  return *this;
}
PatchRolling& PatchRolling::operator=(PatchRolling&&) noexcept = default;

void PatchRolling::set_contact(const ContactScale& scale) {
  require_contact(scale, parts_->constants->problem.bound.shape());
  parts_->next = scale;
}

const ContactScale& PatchRolling::contact() const { return parts_->next; }

void PatchRolling::shift(const PatchLoad& load) {
  const double size = parts_->next.half_width;
  require(size == parts_->now.half_width, "half_width", size,
          "that of the contact before a shift, which changes no lengths");
  parts_->take(0, load);
}

void PatchRolling::roll(double dq, const PatchLoad& load) {
  const double c = parts_->units().size, least = least_step * (c + distance());
  require(dq >= least && dq <= longest_step * c, "dq", dq,
          [&] { return fmt::format("a length from {:.3g} to {:.3g}", least, longest_step * c); });
  parts_->roll(dq / c, load, most_divisions);
}

double PatchRolling::distance() const { return parts_->material.distance() * parts_->units().size; }

VectorXd PatchRolling::x() const {
  const double size = parts_->now.half_width * parts_->units().size;
  return size * centres_of(parts_->constants->rows).col(0);
}

VectorXd PatchRolling::y() const {
  const double size = parts_->now.half_width * parts_->units().size;
  return size * centres_of(parts_->constants->rows).col(1);
}

VectorXd PatchRolling::areas() const {
  const double size = parts_->now.half_width * parts_->units().size;
  return size * size * parts_->constants->rows.areas();
}

VectorXd PatchRolling::bound() const {
  const JoinedRows& rows = parts_->constants->rows;
  const Index n = rows.cells();
  VectorXd unknowns = VectorXd::Zero(2 * n);
  unknowns.head(n) = parts_->constants->limits;
  return tractions_of(rows, unknowns, parts_->now.bound * parts_->units().peak).col(0);
}

MatrixX2d PatchRolling::tractions() const {
  return tractions_of(parts_->constants->rows, parts_->state.unknowns, parts_->units().peak);
}

MatrixX2d PatchRolling::slip() const { return parts_->motion_unit()[0] * slip_of(parts_->state); }

const std::vector<bool>& PatchRolling::slips() const { return parts_->state.slips; }

double PatchRolling::full_sliding() const {
  const auto& [size, bound] = parts_->now;
  return parts_->constants->problem.bound.total() * size * size * bound;
}

Vector3d PatchRolling::resultants() const {
  return parts_->resultants().cwiseProduct(parts_->units().resultant);
}

Vector3d PatchRolling::motion() const {
  return parts_->state.motion.cwiseProduct(parts_->motion_unit());
}

double PatchRolling::elastic_energy() const {
  const PatchUnits& units = parts_->units();
  return parts_->elastic_energy(parts_->material.displacements()) * units.shift[0] *
         units.resultant[0];
}

double PatchRolling::dissipation() const {
  return parts_->dissipation * parts_->motion_unit()[0] * parts_->units().resultant[0];
}

Matrix3d PatchRolling::jacobian() const {
  Parts& p = *parts_;
  if (!p.moved) throw std::logic_error("a Jacobian is that of a step");
  // The response of the step, and the slip that does not depend on the motion.
  const PatchResponse& of = p.response_of(p.step);
  const VectorXd limits = p.now.bound * p.constants->limits;
  const Matrix3d scaled = stick_slip_jacobian(of, limits, p.state);
  const Vector3d by_size = PatchConstants::by_size(p.now.half_width);
  return by_size.cwiseProduct(p.units().resultant).asDiagonal() * scaled *
         p.motion_unit().cwiseInverse().asDiagonal();
}

int PatchRolling::iterations() const { return parts_->state.iterations; }
double PatchRolling::residual() const { return parts_->state.residual; }

double PatchRolling::condition() const {
  return parts_->response ? parts_->response->of.condition() : 0;
}

Evidence PatchRolling::evidence() const {
  const Parts& p = *parts_;
  const VectorXd limits = p.now.bound * p.constants->limits, shares = p.shares();
  const double force = p.units().resultant[0], power = p.motion_unit()[0] * force;
  Evidence evidence = friction_of(p.state, shares, limits);
  evidence.excess *= force;
  evidence.backward *= power;
  evidence.dissipated *= power;
  evidence.residual = p.state.residual;
  evidence.load = resultants().head<2>().norm();
  evidence.power = std::max(std::abs(motion().dot(resultants())), std::abs(dissipation()));
  evidence.full_sliding = full_sliding();
  double slipping = 0, all = 0;
  const VectorXd areas = p.constants->rows.areas();
  for (Index i = 0; i < areas.size(); ++i) {
    all += areas[i];
    if (p.state.slips[static_cast<std::size_t>(i)]) slipping += areas[i];
  }
  evidence.unresolved =
      std::abs(force * shares.dot(limits) - evidence.full_sliding) * slipping / all;
  return evidence;
}

std::string PatchRolling::save() const {
  Archive members;
  parts_->archive(members);
  return state_of_patch.sealed(members.text());
}

void PatchRolling::restore(const SavedState& saved) {
  Archive members(state_of_patch.members_of(saved.text));
  Parts restored(parts_->constants, {});
  restored.archive(members);
  members.require_end();
  *parts_ = restored;
}

double distance_of(const SavedState& saved, const SteadyPatch& problem) {
  PatchRolling rolling(problem);
  rolling.restore(saved);
  return rolling.distance();
}

}  // namespace microslip
