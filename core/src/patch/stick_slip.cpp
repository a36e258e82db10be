// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/stick_slip.hpp"

#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "cell_conditions.hpp"
#include "component_pairs.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/linalg/matrix_product.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "raised_load.hpp"
#include "row_block_solver.hpp"
#include "slip_system.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// How Newton's method is tried.
struct Attempt {
  double length;        ///< r over r0
  double longest_step;  ///< of q, after the first systems
  int systems;
};

/// They have all but one of 12 000 random loads of 3000 ellipses, a/b = 0.1 ... 10 and nu = 0 ... 0.5, on
/// 3 to 15 rows and elements, and all but one of 19 200 random steps of 1200 ellipses.
constexpr Attempt attempts[] = {{1, 2, 20}, {1, 0.5, 40}, {0.3, 2, 20}, {3, 2, 20}};

/// A residual below largest_residual_of_step that a system leaves as it was is rounding: on fine
/// rows, tractions are sums of slip with large coefficients, in short steps above all.
constexpr double least_progress = 0.1;

/// The same of a part of a system, which leaves half of the residual where the solution is at a kink.
constexpr double least_progress_of_part = 0.9;

/// A system that makes the residual larger is gone back on, by halves, to this part of its way.
constexpr double least_part = 1.0 / 32;

/// The first systems are taken whole, whatever the residual: they find out which cells slip.
constexpr int first_systems = 2;

/// Attempts at a part of the load.
constexpr std::size_t attempts_of_part = 2;

/// Largest residual. Where nearly all slides, rounding is up to 1e-11.
constexpr double tolerance = 1e-10;

/// The same in a step, where displacements are differences of larger ones.
constexpr double tolerance_of_step = 1e-9;

/// Sets what is linear in the unknowns to that at a part of the way from one state to another.
void set_between(const PatchState& from, const PatchState& to, double part, PatchState& state) {
  for (VectorXd PatchState::*const values : {&PatchState::unknowns, &PatchState::own_slip,
                                             &PatchState::centre_slip, &PatchState::seen_slip}) {
    state.*values = from.*values + part * (to.*values - from.*values);
  }
  state.motion = from.motion + part * (to.motion - from.motion);
}

class Newton {
 public:
  PatchLoad load = {};

  Newton(const PatchResponse& response, const VectorXd& limits, const ImposedSlip* imposed,
         Discs discs = Discs::of_solution)
      : imposed_(imposed != nullptr ? *imposed
                                    : ImposedSlip{VectorXd::Zero(2 * limits.size()),
                                                  VectorXd::Zero(2 * limits.size())}),
        cells_(limits.size()),
        conditions_(response, limits),
        system_(response, limits),
        discs_(discs),
        tolerance_(imposed != nullptr ? tolerance_of_step : tolerance) {}

  PatchState adhesion() const {
    const VectorXd none = VectorXd::Zero(2 * cells_);
    return {.unknowns = none,
            .own_slip = none,
            .centre_slip = none,
            .seen_slip = none,
            .carried = VectorXd::Ones(cells_),
            .motion = Vector3d::Zero(),
            .slips = std::vector<bool>(static_cast<std::size_t>(cells_), false)};
  }

  /// Whether it converges.
  bool converges(PatchState& state, const Attempt& attempt) {
    conditions_.set_length(attempt.length);
    conditions_.keep_discs(false);
    conditions_.look_at(state);
    conditions_.keep_discs(discs_ == Discs::of_start);
    q_ = conditions_.quotients();
    state.residual = std::numeric_limits<double>::infinity();
    for (int i = 0; i < attempt.systems; ++i) {
      const bool is_first = i < first_systems;
      before_ = state;
      solve(state);
      ++state.iterations;
      look_at(state);
      const bool is_part = !is_first && goes_back(state);
      const double progress = is_part ? least_progress_of_part : least_progress;
      const bool is_rounding = state.residual < largest_residual_of_step &&
                               before_.residual < largest_residual_of_step &&
                               state.residual > progress * before_.residual;
      if (state.residual < tolerance_ || is_rounding) {
        conditions_.find_carried(state.carried);
        return true;
      }
      if (!std::isfinite(state.residual)) return false;
      take(state, is_first ? std::numeric_limits<double>::infinity() : attempt.longest_step);
    }
    return false;
  }

  /// The resultants by the motion, about a solution.
  Matrix3d jacobian(const PatchState& state) {
    conditions_.look_at(state);
    q_ = conditions_.quotients();
    const PatchLoad by_resultants{{{true, 0}, {true, 0}, {true, 0}}};
    system_.assemble(conditions_, state, q_, by_resultants, imposed_);
    const auto& matrix = system_.matrix();
    const Index size = matrix.rows() - 3;
    const MatrixXd by_motion =
        LuFactors(matrix.topLeftCorner(size, size)).solve_columns(matrix.topRightCorner(size, 3));
    return matrix.bottomRightCorner(3, 3) -
           matrix_product(matrix.bottomLeftCorner(3, size), by_motion);
  }

 private:
  void solve(PatchState& state) {
    system_.assemble(conditions_, state, q_, load, imposed_);
    system_.apply(solver_.solve(system_.matrix(), system_.right(),
                                system_.unknowns_of(state, imposed_), system_.rows_of_unknowns()),
                  conditions_, imposed_, state);
  }

  void look_at(PatchState& state) {
    conditions_.look_at(state);
    state.residual = conditions_.residual();
  }

  /// Goes back towards the state before the last system until the residual is less than it was there,
  /// or else stays.
  /// \return whether it went
  bool goes_back(PatchState& state) {
    if (!(state.residual > before_.residual)) return false;
    const PatchState end = state;
    for (double part = 0.5; part >= least_part; part /= 2) {
      set_between(before_, end, part, state);
      look_at(state);
      if (state.residual < before_.residual) return true;
    }
    state = end;
    conditions_.look_at(state);
    return false;
  }

  /// Decides which cells slip, and takes their q.
  void take(PatchState& state, double longest_step) {
    for (Index i = 0; i < cells_; ++i) {
      // The circle may be another one than that on which the system has put q.
      const Vector2d q = system_.slides(i) ? conditions_.on_circle(i) : conditions_.quotient(i);
      const bool slips_now = conditions_.slips_next(i, q);
      state.slips[static_cast<std::size_t>(i)] = slips_now;
      Vector2d step = conditions_.on_disc(i, q) - pair_of(q_, i);
      if (slips_now && step.norm() > longest_step) step *= longest_step / step.norm();
      set_pair(q_, i, pair_of(q_, i) + step);
    }
  }

  ImposedSlip imposed_;
  Index cells_;
  CellConditions conditions_;
  SlipSystem system_;
  RowBlockSolver solver_;
  Discs discs_;
  double tolerance_;
  VectorXd q_;         ///< on the disc
  PatchState before_;  ///< that of the last system
};

/// Whether one of some attempts converges.
bool converges(Newton& newton, const PatchState& start, std::span<const Attempt> tried,
               PatchState& state) {
  for (const Attempt& attempt : tried) {
    const int iterations = state.iterations;
    state = start;
    state.iterations = iterations;
    if (newton.converges(state, attempt)) return true;
  }
  return false;
}

}  // namespace

PatchState solve_stick_slip(const PatchResponse& response, const VectorXd& limits,
                            const PatchLoad& load, const PatchState* start,
                            const ImposedSlip* imposed, Discs discs) {
  Newton newton(response, limits, imposed, discs);
  newton.load = load;
  PatchState state, reached = newton.adhesion();
  if (converges(newton, start != nullptr ? *start : reached, attempts, state)) return state;
  if (imposed != nullptr) {
    throw NotConverged(
        "stick and slip of the step are not found: the resultants may be more than friction "
        "carries together; else shorter steps may help",
        0, state.residual);
  }
  const double part = raise_load(load, [&](const PatchLoad& raised) {
    newton.load = raised;
    const bool is_solved =
        converges(newton, reached, std::span(attempts).first(attempts_of_part), state);
    if (is_solved) reached = state;
    return is_solved;
  });
  if (part == 1) return reached;
  throw NotConverged(
      fmt::format(
          "stick and slip of the contact are found up to {} of the load: the resultants may "
          "be more than friction carries together, or the rows and elements too few for the "
          "spin",
          format_roughly(part)),
      0, state.residual);
}

Matrix3d stick_slip_jacobian(const PatchResponse& response, const VectorXd& limits,
                             const PatchState& state) {
  return Newton(response, limits, nullptr).jacobian(state);
}

}  // namespace microslip
