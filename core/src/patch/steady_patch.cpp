// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/steady_patch.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"
#include "patch_evidence.hpp"
#include "patch_friction.hpp"
#include "patch_scale.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// Motions over mu p0/G above this size are made smaller by one divisor. All slides then, in the
/// direction of the rigid slip but for a part of 1e-12.
constexpr double largest_motion = 1e12;

/// Larger ones are refused.
constexpr double largest_given = 1e100;

struct ScaledLoad {
  PatchLoad load;
  double divisor;  ///< of motions

  ScaledLoad(const PatchLoad& given, const PatchUnits& units)
      : load(units.scaled(given, units.motion)) {
    double largest = 0;
    for (std::size_t j = 0; j < load.size(); ++j) {
      if (load[j].by_resultant) continue;
      require(std::abs(load[j].value) <= largest_given, name_of(given, j), given[j].value,
              "a motion of at most 1e100 times that by the bound's strain");
      largest = std::max(largest, std::abs(load[j].value));
    }
    divisor = std::max(1.0, largest / largest_motion);
    for (PatchComponent& component : load) {
      if (!component.by_resultant) component.value /= divisor;
    }
  }
};

/// Limits of cells: by the bound at rest, and those of the solution.
struct Limits {
  VectorXd at_rest, solved;
};

/// Finds stick and slip where friction depends on slip. The solution gets its state, and the limits.
void solve_slipping(const SteadyPatch& problem, const PatchResponse& response,
                    const ScaledLoad& scaled, const PatchState* start, Limits& limits,
                    SteadyPatchSolution& solution) {
  const PatchUnits units(problem.material, problem.bound.peak(), problem.bound.size());
  const SlipFriction& friction = *problem.friction;
  const FrictionRows rows(response.rows(), friction, units.size);
  SlippingPatch patch({.response = response,
                       .at_rest = limits.at_rest,
                       .load = scaled.load,
                       .start = start,
                       .imposed = nullptr},
                      rows, std::numeric_limits<double>::infinity(),
                      scaled.divisor * units.motion[0] * friction.speed);
  solution.has_second = solve_by_friction(patch, friction.branch);
  solution.state = patch.state();
  limits.solved = patch.limits();
}

Evidence evidence_of(const SteadyPatch& problem, const SteadyPatchSolution& solution,
                     const PatchResponse& response, const Limits& limits, double divisor) {
  const PatchUnits units(problem.material, problem.bound.peak(), problem.bound.size());
  const VectorXd shares = response.resultants().row(0).head(limits.at_rest.size());
  Evidence evidence = evidence_of_cells(solution.state, shares, limits.solved,
                                        {.force = units.resultant[0],
                                         .power = divisor * units.motion[0] * units.resultant[0],
                                         .full_sliding = problem.bound.total(),
                                         .slip_share = solution.slip_area() / solution.area.sum()},
                                        limits.at_rest);
  evidence.load = solution.force();
  evidence.power = std::abs(solution.dissipation);
  return evidence;
}

}  // namespace

void validate(const SteadyPatch& problem) {
  validate(problem.material);
  validate(problem.accepted);
  require(problem.elements >= least_elements, "elements", static_cast<double>(problem.elements),
          "a whole number >= 2");
  if (problem.friction) validate(*problem.friction);
  validate(problem.load, problem.bound.total(), problem.bound.turning_moment());
}

void validate(const PatchLoad& load, double full_sliding, double turning_moment) {
  double squares = 0;
  for (std::size_t j = 0; j < load.size(); ++j) {
    const auto& [by_resultant, value] = load[j];
    if (!by_resultant) {
      require(true, name_of(load, j), value, "a finite number");
      continue;
    }
    require(
        std::abs(value) < (j < 2 ? full_sliding : turning_moment), name_of(load, j), value, [&] {
          return j < 2 ? fmt::format("less than full sliding, {:.6g} N, in absolute value",
                                     full_sliding)
                       : fmt::format(
                             "less than the moment of turning about the centre, {:.6g} N mm, in "
                             "absolute value",
                             turning_moment);
        });
    if (j < 2) squares += value * value;
  }
  require(squares < full_sliding * full_sliding, "lateral_force", load[1].value, [&] {
    return fmt::format("forces whose vector is shorter than full sliding, {:.6g} N", full_sliding);
  });
}

double slip_area_of(const VectorXd& areas, const std::vector<bool>& slips) {
  double sum = 0;
  for (Index i = 0; i < areas.size(); ++i) {
    if (slips[static_cast<std::size_t>(i)]) sum += areas[i];
  }
  return sum;
}

SteadyPatchSolution solve_steady(const SteadyPatch& problem, const PatchResponse& response,
                                 const PatchState* start) {
  validate(problem);
  const JoinedRows& rows = response.rows();
  const PatchUnits units(problem.material, problem.bound.peak(), problem.bound.size());
  Limits limits{.at_rest = limits_of(rows, problem.bound), .solved = {}};
  SteadyPatchSolution solution;
  const ScaledLoad scaled(problem.load, units);
  if (problem.friction) {
    solve_slipping(problem, response, scaled, start, limits, solution);
  } else {
    limits.solved = limits.at_rest;
    solution.state = solve_stick_slip(response, limits.solved, scaled.load, start);
  }
  const PatchState& state = solution.state;
  const double c = problem.bound.size();
  solution.slips = state.slips;
  solution.iterations = state.iterations;
  solution.condition = response.condition();
  solution.motion = scaled.divisor * state.motion.cwiseProduct(units.motion);
  solution.resultants = (response.resultants() * state.unknowns).cwiseProduct(units.resultant);
  for (std::size_t j = 0; j < problem.load.size(); ++j) {  // without rounding
    const auto& [by_resultant, value] = problem.load[j];
    (by_resultant ? solution.resultants : solution.motion)[static_cast<Index>(j)] = value;
  }
  solution.dissipation = -solution.motion.dot(solution.resultants);
  const Eigen::MatrixX2d centres = c * centres_of(rows);
  solution.x = centres.col(0);
  solution.y = centres.col(1);
  solution.area = c * c * rows.areas();
  solution.bound.resize(rows.cells());
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      solution.bound[rows.cell(i, k)] = problem.bound(rows.lobe(k), rows.psi(k), rows.theta(i));
    }
  }
  solution.bound.array() *= limits.solved.array() / limits.at_rest.array();
  solution.traction =
      tractions_of(rows, within_limits(state.unknowns, limits.solved), problem.bound.peak());
  solution.slip = scaled.divisor * units.motion[0] * slip_of(state);
  solution.evidence = evidence_of(problem, solution, response, limits, scaled.divisor);
  return solution;
}

SteadyPatchSolution solve_steady(const SteadyPatch& problem) {
  validate(problem);
  return solve_steady(problem, PatchResponse(rows_of(problem), problem.material.poisson_ratio));
}

double change_of(const SteadyPatch& problem, const SteadyPatchSolution& from,
                 const SteadyPatchSolution& to) {
  const double full = problem.bound.total(), c = problem.bound.size();
  const Vector3d resultant(full, full, problem.bound.turning_moment());
  const Vector3d motions = to.motion.cwiseProduct(Vector3d(1, 1, c)).cwiseAbs();
  const double creepage = motions.head<2>().maxCoeff(), spin = motions[2];
  double largest = 0;
  for (Index j = 0; j < 3; ++j) {
    const double by_force = std::abs(to.resultants[j] - from.resultants[j]) / resultant[j];
    const double unit = j < 2 ? creepage : spin / c;
    const double by_motion = unit > 0 ? std::abs(to.motion[j] - from.motion[j]) / unit : 0;
    largest = std::max({largest, by_force, by_motion});
  }
  return largest;
}

std::optional<SteadyPatch> with_fewer_elements(const SteadyPatch& problem) {
  const auto lobes = static_cast<Index>(problem.bound.shape().lobes().size());
  if (problem.rows == lobes || problem.elements == least_elements) return std::nullopt;
  SteadyPatch coarse = problem;
  coarse.rows = std::max(lobes, (2 * problem.rows + 1) / 3);
  coarse.elements = std::max(least_elements, (2 * problem.elements + 1) / 3);
  return coarse;
}

SteadyPatchSolver::Prepared::Prepared(const SteadyPatch& of)
    : problem(of), response(rows_of(of), of.material.poisson_ratio) {}

SteadyPatchSolution SteadyPatchSolver::Prepared::solve(const PatchLoad& load) {
  problem.load = load;
  SteadyPatchSolution solution = solve_steady(problem, response, state ? &*state : nullptr);
  state = solution.state;
  return solution;
}

namespace {

const SteadyPatch& valid(const SteadyPatch& problem) {
  validate(problem);
  return problem;
}

}  // namespace

SteadyPatchSolver::SteadyPatchSolver(const SteadyPatch& problem, bool with_change)
    : fine_(valid(problem)), with_change_(with_change) {
  const auto coarse = with_fewer_elements(problem);
  if (with_change && coarse) coarse_.emplace(*coarse);
}

void SteadyPatchSolver::set_bound(const PatchBound& bound) {
  constexpr double rounding = 1e-9;
  const double ratio = fine_.problem.bound.ratio();
  require(std::abs(bound.ratio() / ratio - 1) < rounding, "ratio", bound.ratio(),
          [&] { return fmt::format("that of the shape so far, {}", ratio); });
  fine_.problem.bound = bound;
  if (coarse_) coarse_->problem.bound = bound;
}

void SteadyPatchSolver::set_speed(double speed) {
  require_positive("speed", speed);
  if (fine_.problem.friction) fine_.problem.friction->speed = speed;
  if (coarse_ && coarse_->problem.friction) coarse_->problem.friction->speed = speed;
}

CreepCoefficients SteadyPatchSolver::coefficients() const {
  const Eigen::Matrix3d& linear = fine_.response.linear();
  return {.c11 = -linear(0, 0),
          .c22 = -linear(1, 1),
          .c23 = -linear(1, 2),
          .c32 = linear(2, 1),
          .c33 = -linear(2, 2)};
}

Eigen::Matrix3d SteadyPatchSolver::jacobian() const {
  if (!fine_.state) throw std::logic_error("a Jacobian is that of a solution");
  const SteadyPatch& of = fine_.problem;
  if (of.friction) {
    throw std::invalid_argument("friction_law: expected none where derivatives are asked for");
  }
  const PatchUnits units(of.material, of.bound.peak(), of.bound.size());
  const Eigen::Matrix3d scaled =
      stick_slip_jacobian(fine_.response, limits_of(fine_.response.rows(), of.bound), *fine_.state);
  return units.resultant.asDiagonal() * scaled * units.motion.cwiseInverse().asDiagonal();
}

SteadyPatchSolution SteadyPatchSolver::solve(const PatchLoad& load) {
  SteadyPatchSolution solution = fine_.solve(load);
  if (!with_change_) return solution;
  solution.evidence.change = 1;
  if (!coarse_) return solution;
  try {
    solution.evidence.change = change_of(fine_.problem, coarse_->solve(load), solution);
  } catch (const NotConverged&) {
    return solution;
  }
  return solution;
}

SteadyPatchSolution solve_steady_with_change(const SteadyPatch& problem) {
  return SteadyPatchSolver(problem).solve(problem.load);
}

}  // namespace microslip
