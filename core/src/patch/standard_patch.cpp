// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/standard_patch.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <vector>

#include "microslip/halfspace/influence.hpp"
#include "microslip/patch/rectangle_pressure.hpp"
#include "microslip/patch/steady_patch.hpp"
#include "microslip/support/require.hpp"
#include "patch_scale.hpp"
#include "rectangle_newton.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixX2d;
using Eigen::MatrixX3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// Rigid slip by the motion; the spin is taken at a place ahead of the centres.
MatrixX3d rigid_slip(const Rectangles& of, double ahead) {
  const Index n = of.size();
  MatrixX3d rigid(2 * n, 3);
  for (Index i = 0; i < n; ++i) {
    rigid.row(i) << 1, 0, -of.y(i);
    rigid.row(n + i) << 0, 1, of.x(i) + ahead;
  }
  return rigid;
}

/// Forces, and the moment about the centre, by the tractions.
Matrix3Xd resultants_by_tractions(const Rectangles& of) {
  const Index n = of.size();
  Matrix3Xd resultants = Matrix3Xd::Zero(3, 2 * n);
  for (Index i = 0; i < n; ++i) {
    resultants.col(i) << of.area(), 0, -of.y(i) * of.area();
    resultants.col(n + i) << 0, of.area(), of.x(i) * of.area();
  }
  return resultants;
}

/// The part of dq at which spin is taken ahead of the centre of an element, as by CONTACT.
constexpr double spin_ahead = 1.0 / 6;

RectanglePressure pressure_of(const StandardPatch& problem) {
  validate(problem.material);
  require(problem.relaxation >= 0 && problem.relaxation <= StandardPatch::largest_relaxation,
          "relaxation", problem.relaxation, "0, or a number up to 1e6");
  const double root = std::sqrt(problem.bound.ratio());
  if (problem.pressure == StandardPatch::Pressure::computed) {
    return pressure_of_rectangles(root, 1 / root, problem.elements, problem.rows);
  }
  const Rectangles contact = Rectangles::in_ellipse(root, 1 / root, problem.elements, problem.rows);
  const EllipticBound hertz(root, 1 / root, 1);
  VectorXd pressure(contact.size());
  for (Index i = 0; i < contact.size(); ++i) pressure[i] = hertz(contact.x(i), contact.y(i));
  return {contact, pressure, 1, 0};
}

/// The length that divides the difference of displacements in a step, or in a shift.
double divisor(double dq) { return dq > 0 ? dq : 1; }

/// The parts of the slip in a step, or in a shift, by the tractions before it.
std::vector<RectangleInfluence::Part> former_parts(double dq, double dx, double relaxation) {
  const double length = divisor(dq), elements = dq / dx;
  if (relaxation == 0 || dq == 0) return {{-1 / length, elements}};
  const double part = elements / relaxation;
  return {{-(1 - part) / length, 0}, {-part / length, relaxation}};
}

/// Slip by the tractions in steady rolling.
RectangleInfluence steady_influence(const Rectangles& of, double nu) {
  return {of, nu, {{1 / of.dx(), 0}, {-1 / of.dx(), 1}}};
}

}  // namespace

/// All is in units by which the size of the ellipse, the bound's peak and the shear modulus are 1.
struct RectangleRolling::Parts {
  /// Slip by the tractions of a step, and by those before it.
  struct StepInfluence {
    double length;  ///< dq; 0 for a shift
    RectangleInfluence present, former;
    MatrixX3d rigid;

    StepInfluence(const Rectangles& of, double nu, double dq, double relaxation)
        : length(dq),
          present(of, nu, {{1 / divisor(dq), 0}}),
          former(of, nu, former_parts(dq, of.dx(), relaxation)),
          rigid(rigid_slip(of, dq * spin_ahead)) {}
  };

  struct SteadyInfluence {
    RectangleInfluence present;
    MatrixX3d rigid;

    SteadyInfluence(const Rectangles& of, double nu)
        : present(steady_influence(of, nu)), rigid(rigid_slip(of, of.dx() * spin_ahead)) {}
  };

  explicit Parts(const StandardPatch& of)
      : problem(of),
        touching(pressure_of(of)),
        by_tractions(resultants_by_tractions(touching.contact)),
        size(of.bound.size()),
        units(of.material, of.bound.peak(), size) {
    begin(VectorXd::Zero(2 * contact().size()));
  }

  void begin(const VectorXd& tractions) {
    const Index n = contact().size();
    state = {.tractions = tractions,
             .slip = VectorXd::Zero(2 * n),
             .motion = Vector3d::Zero(),
             .slips = std::vector<bool>(static_cast<std::size_t>(n), false)};
    rolled = false;
    take({});
  }

  const Rectangles& contact() const { return touching.contact; }
  double nu() const { return problem.material.poisson_ratio; }

  const Vector3d& motion_unit(bool rolls) const { return rolls ? units.motion : units.shift; }

  PatchLoad scaled(const PatchLoad& load, bool rolls) const {
    validate(load, problem.bound.total(), problem.bound.turning_moment());
    // Squares of smaller ones would be 0, and of larger ones infinite.
    constexpr double least = 1e-100, most = 1e100;
    const PatchLoad found = units.scaled(load, motion_unit(rolls));
    for (std::size_t j = 0; j < found.size(); ++j) {
      const double size = std::abs(found[j].value);
      require(size == 0 || (size >= least && size <= most), name_of(load, j), load[j].value,
              "0, or a size from 1e-100 to 1e100 of that by the bound's strain");
    }
    return found;
  }

  void step(double dq, const PatchLoad& load) {
    const PatchLoad wanted = scaled(load, dq > 0);
    if (!influence || influence->length != dq) {
      influence.emplace(contact(), nu(), dq, problem.relaxation);
    }
    VectorXd given;
    influence->former.apply(state.tractions, given);
    state = solve_rectangles({.rectangles = contact(),
                              .influence = influence->present,
                              .rigid = influence->rigid,
                              .given = given,
                              .limits = touching.pressure,
                              .resultants = by_tractions,
                              .load = wanted},
                             &state);
    rolled = dq > 0;
    take(load);
  }

  void take(const PatchLoad& load) {
    motion = state.motion.cwiseProduct(motion_unit(rolled));
    resultants = (by_tractions * state.tractions).cwiseProduct(units.resultant);
    for (std::size_t j = 0; j < load.size(); ++j) {  // without rounding
      (load[j].by_resultant ? resultants : motion)[static_cast<Index>(j)] = load[j].value;
    }
  }

  StandardPatch problem;
  RectanglePressure touching;
  Matrix3Xd by_tractions;
  double size;  ///< c  [mm]
  PatchUnits units;
  RectangleState state;
  bool rolled = false;  ///< or shifted, in the last step
  Vector3d motion = Vector3d::Zero(), resultants = Vector3d::Zero();
  std::optional<StepInfluence> influence;
  std::optional<SteadyInfluence> steady;
};

RectangleRolling::RectangleRolling(const StandardPatch& problem)
    : parts_(std::make_unique<Parts>(problem)) {}

RectangleRolling::~RectangleRolling() = default;
RectangleRolling::RectangleRolling(RectangleRolling&&) noexcept = default;
RectangleRolling& RectangleRolling::operator=(RectangleRolling&&) noexcept = default;

void RectangleRolling::start_from(const MatrixX2d& tractions) {
  Parts& parts = *parts_;
  const VectorXd given =
      tractions_within(tractions / parts.problem.bound.peak(), parts.touching.pressure).reshaped();
  parts.begin(given);
}

void RectangleRolling::shift(const PatchLoad& load) { parts_->step(0, load); }

void RectangleRolling::roll(double dq, const PatchLoad& load) {
  require_positive("dq", dq);
  const double relaxation = parts_->problem.relaxation;
  require(relaxation == 0 || is_within_relaxation(dq / element(), relaxation), "dq", dq, [&] {
    return fmt::format("at most the length of the relaxation, {} mm", relaxation * element());
  });
  parts_->step(dq / parts_->size, load);
}

void RectangleRolling::roll_steadily(const PatchLoad& load) {
  Parts& parts = *parts_;
  const PatchLoad wanted = parts.scaled(load, true);
  if (!parts.steady) parts.steady.emplace(parts.contact(), parts.nu());
  const VectorXd none = VectorXd::Zero(2 * size());
  parts.state = solve_rectangles({.rectangles = parts.contact(),
                                  .influence = parts.steady->present,
                                  .rigid = parts.steady->rigid,
                                  .given = none,
                                  .limits = parts.touching.pressure,
                                  .resultants = parts.by_tractions,
                                  .load = wanted},
                                 nullptr);
  parts.rolled = true;
  parts.take(load);
}

Index RectangleRolling::size() const { return parts_->contact().size(); }

VectorXd RectangleRolling::x() const {
  return VectorXd::NullaryExpr(size(),
                               [this](Index i) { return parts_->size * parts_->contact().x(i); });
}

VectorXd RectangleRolling::y() const {
  return VectorXd::NullaryExpr(size(),
                               [this](Index i) { return parts_->size * parts_->contact().y(i); });
}

double RectangleRolling::area() const {
  return parts_->contact().area() * parts_->size * parts_->size;
}

double RectangleRolling::element() const { return parts_->contact().dx() * parts_->size; }

VectorXd RectangleRolling::bound() const {
  return parts_->problem.bound.peak() * parts_->touching.pressure;
}

MatrixX2d RectangleRolling::tractions() const {
  return parts_->problem.bound.peak() * parts_->state.tractions.reshaped(size(), 2);
}

MatrixX2d RectangleRolling::slip() const {
  return parts_->motion_unit(parts_->rolled)[0] * parts_->state.slip.reshaped(size(), 2);
}

const std::vector<bool>& RectangleRolling::slips() const { return parts_->state.slips; }

Vector3d RectangleRolling::resultants() const { return parts_->resultants; }

Vector3d RectangleRolling::motion() const { return parts_->motion; }

double RectangleRolling::dissipation() const {
  return -area() * tractions().cwiseProduct(slip()).sum();
}

int RectangleRolling::iterations() const { return parts_->state.iterations; }

double RectangleRolling::residual() const { return parts_->state.residual; }

Matrix3d linear_response(const Rectangles& rectangles, double poisson_ratio) {
  validate(Material{1, poisson_ratio});
  constexpr double large = 100;  // motions, so that errors of tractions are smaller beside them
  const RectangleInfluence influence = steady_influence(rectangles, poisson_ratio);
  const MatrixX3d rigid = rigid_slip(rectangles, rectangles.dx() * spin_ahead);
  const Matrix3Xd by_tractions = resultants_by_tractions(rectangles);
  const VectorXd none = VectorXd::Zero(2 * rectangles.size());
  const VectorXd no_limits =
      VectorXd::Constant(rectangles.size(), std::numeric_limits<double>::infinity());
  Matrix3d linear;
  for (Index j = 0; j < 3; ++j) {
    PatchLoad load{};
    load[static_cast<std::size_t>(j)].value = large;
    const RectangleState state = solve_rectangles({.rectangles = rectangles,
                                                   .influence = influence,
                                                   .rigid = rigid,
                                                   .given = none,
                                                   .limits = no_limits,
                                                   .resultants = by_tractions,
                                                   .load = load},
                                                  nullptr);
    linear.col(j) = by_tractions * state.tractions / large;
  }
  return linear;
}

}  // namespace microslip
