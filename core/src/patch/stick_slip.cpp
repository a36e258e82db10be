// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/stick_slip.hpp"

#include <fmt/core.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "component_pairs.hpp"
#include "microslip/linalg/index_view.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "raised_load.hpp"
#include "row_block_solver.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// How Newton's method is tried.
struct Attempt {
  double length;        ///< r over r0
  double longest_step;  ///< of q, from the third system on
  int systems;
  double width = 0.3;  ///< |q - r0 t| - 1 from which the slip is that at the centre
};

/// They have 2000 random loads of 40 ellipses, a/b = 0.2 ... 5, but for one on a row of one cell.
constexpr Attempt attempts[] = {{3, 2, 20}, {1.5, 0.7, 20}, {5, 2, 20}, {1, 0.3, 40}};

/// The same for steps. In the first ones after a shift or a change of the load, one of 300 takes the
/// wider transition, in which the slip of a cell changes less from one system to the next.
constexpr Attempt attempts_at_step[] = {
    {0.3, 2, 20}, {1, 0.7, 20}, {0.3, 2, 20, 3}, {1, 0.7, 40, 3}};

/// Attempts at a part of the load.
constexpr std::size_t attempts_of_part = 2;

/// Largest residual. Where nearly all slides, rounding is up to 1e-11.
constexpr double tolerance = 1e-10;

/// The same in a step, where displacements are differences of larger ones.
constexpr double tolerance_of_step = 1e-9;

/// A cell that slips counts as within the disc if |z| is less than 1 by so much. At the start of an
/// attempt z is on the disc.
constexpr double within_disc = 1e-6;

/// r0 of each cell: the reciprocal of the largest own slip in its row by a unit of q in one cell.
VectorXd lengths_of(const PatchResponse& response, const VectorXd& limits) {
  const JoinedRows& rows = response.rows();
  const Index n = rows.cells();
  VectorXd lengths(n);
  for (Index k = 0; k < rows.rows(); ++k) {
    const auto of_row = Eigen::seqN(rows.cell(0, k), rows.elements());
    const auto slip = response.stiffness().head(n).cwiseMax(response.stiffness().tail(n));
    lengths(of_row).setConstant(1 / slip.cwiseProduct(limits)(of_row).maxCoeff());
  }
  return lengths;
}

/// The slip in the condition of a cell: t + part (c - t), and how the part grows.
struct MixedSlip {
  Vector2d value;
  double part, growth;  ///< growth by |q - r0 t|

  MixedSlip(const Vector2d& own, const Vector2d& centre, double beyond, double width) {
    part = std::clamp(beyond / width, 0.0, 1.0);
    growth = part > 0 && part < 1 ? 1 / width : 0;
    value = own + part * (centre - own);
  }
};

class Newton {
 public:
  PatchLoad load = {};

  Newton(const PatchResponse& response, const VectorXd& limits, const ImposedSlip* imposed)
      : response_(response),
        limits_(limits),
        imposed_(imposed != nullptr ? *imposed
                                    : ImposedSlip{VectorXd::Zero(2 * limits.size()),
                                                  VectorXd::Zero(2 * limits.size())}),
        cells_(limits.size()),
        lengths_(lengths_of(response, limits)),
        tolerance_(imposed != nullptr ? tolerance_of_step : tolerance) {}

  PatchState adhesion() const {
    const VectorXd none = VectorXd::Zero(2 * cells_);
    return {.unknowns = none,
            .own_slip = none,
            .centre_slip = none,
            .motion = Vector3d::Zero(),
            .slips = std::vector<bool>(static_cast<std::size_t>(cells_), false)};
  }

  /// Whether it converges.
  bool converges(PatchState& state, const Attempt& attempt) {
    length_ratio_ = attempt.length;
    width_ = attempt.width;
    q_ = quotients(state);
    for (int i = 0; i < attempt.systems; ++i) {
      solve(state);
      ++state.iterations;
      state.residual = residual(state);
      if (state.residual < tolerance_) {
        state.transition = attempt.width;
        return true;
      }
      if (!std::isfinite(state.residual)) return false;
      take(state, i < 2 ? std::numeric_limits<double>::infinity() : attempt.longest_step);
    }
    return false;
  }

  /// The resultants by the motion, about a solution.
  Matrix3d jacobian(const PatchState& state) {
    length_ratio_ = 1;
    width_ = state.transition;
    q_ = quotients(state);
    load = {{{true, 0}, {true, 0}, {true, 0}}};
    assemble(state);
    const Index size = system_.rows() - 3;
    const MatrixXd by_motion = -MatrixXd(system_.topLeftCorner(size, size))
                                    .partialPivLu()
                                    .solve(system_.topRightCorner(size, 3));
    return system_.bottomLeftCorner(3, size) * by_motion + system_.bottomRightCorner(3, 3);
  }

 private:
  bool slips(const PatchState& state, Index i) const {
    return state.slips[static_cast<std::size_t>(i)];
  }

  Vector2d quotient(const PatchState& state, Index i) const {
    return pair_of(state.unknowns, i) / limits_[i];
  }

  VectorXd quotients(const PatchState& state) const {
    VectorXd q(2 * cells_);
    for (Index i = 0; i < cells_; ++i) set_pair(q, i, onto_disc(quotient(state, i)));
    return q;
  }

  MixedSlip mixed_slip(const PatchState& state, Index i, const Vector2d& q) const {
    const Vector2d own = pair_of(state.own_slip, i);
    return {own, pair_of(state.centre_slip, i), (q - lengths_[i] * own).norm() - 1, width_};
  }

  /// The largest |q - P(q - r0 s)|, not a number if a part is not one.
  double residual(const PatchState& state) const {
    double largest = 0;
    for (Index i = 0; i < cells_; ++i) {
      const Vector2d q = quotient(state, i);
      const Vector2d z = q - lengths_[i] * mixed_slip(state, i, q).value;
      const double error = (q - onto_disc(z)).norm();
      if (!(error <= largest)) largest = error;
    }
    return largest;
  }

  /// Sets the conditions of cells that slip, linear about a state, and those of the load.
  void assemble(const PatchState& state) {
    split_motion();
    columns_.clear();
    stuck_.noalias() = -response_.rigid_own_slip() * motions_;
    stuck_.col(0) -= imposed_.own;
    for (Index i = 0; i < cells_; ++i) {
      if (!slips(state, i)) continue;
      columns_.push_back(i);
      stuck_.row(i).setZero();
      stuck_.row(cells_ + i).setZero();
    }
    const auto size = static_cast<Index>(columns_.size());
    for (Index r = 0; r < size; ++r) {
      columns_.push_back(cells_ + columns_[static_cast<std::size_t>(r)]);
    }
    const Index free = motions_.cols() - 1;
    system_.resize(2 * size + free, 2 * size + free);
    right_.resize(2 * size + free);
    for (Index r = 0; r < size; ++r) set_condition(state, r, size);
    for (Index j = 0; j < free; ++j) set_resultant(j, 2 * size);
  }

  void solve(PatchState& state) {
    assemble(state);
    const auto columns = index_view(columns_);
    const Index free = motions_.cols() - 1, size = static_cast<Index>(columns_.size()) / 2;
    const VectorXd solution =
        solver_.solve(system_, right_, previous_solution(state, size), rows_of_unknowns());
    VectorXd motion(1 + free);
    motion << 1, solution.tail(free);
    state.motion = motions_ * motion;
    VectorXd elastic = stuck_ * motion;
    elastic(columns) = solution.head(2 * size);
    state.unknowns.noalias() = response_.unknowns() * elastic;
    state.own_slip.setZero();
    state.centre_slip.setZero();
    for (const Index c : columns_) {
      state.own_slip[c] =
          elastic[c] + response_.rigid_own_slip().row(c) * state.motion + imposed_.own[c];
      state.centre_slip[c] = response_.centre_slip().row(c).dot(elastic) +
                             response_.rigid_centre_slip().row(c) * state.motion +
                             imposed_.centre[c];
    }
  }

  /// Splits the motion into the prescribed one and the components that follow from a resultant.
  void split_motion() {
    free_.clear();
    Vector3d prescribed = Vector3d::Zero();
    for (Index j = 0; j < 3; ++j) {
      const PatchComponent& component = load[static_cast<std::size_t>(j)];
      if (component.by_resultant) {
        free_.push_back(j);
      } else {
        prescribed[j] = component.value;
      }
    }
    motions_.setZero(3, 1 + static_cast<Index>(free_.size()));
    motions_.col(0) = prescribed;
    for (std::size_t j = 0; j < free_.size(); ++j)
      motions_(free_[j], 1 + static_cast<Index>(j)) = 1;
  }

  /// The row of cells of each slip.
  std::vector<Index> rows_of_unknowns() const {
    std::vector<Index> rows;
    for (const Index column : columns_) {
      rows.push_back(column % cells_ / response_.rows().elements());
    }
    return rows;
  }

  /// The unknowns of the system in the state before it.
  VectorXd previous_solution(const PatchState& state, Index size) const {
    VectorXd values(right_.size());
    for (Index r = 0; r < 2 * size; ++r) {
      const Index column = columns_[static_cast<std::size_t>(r)];
      values[r] = state.own_slip[column] - response_.rigid_own_slip().row(column) * state.motion -
                  imposed_.own[column];
    }
    values.tail(values.size() - 2 * size) = state.motion(index_view(free_));
    return values;
  }

  /// With z = q - r s, e = z/|z| and D = (1 - e e')/|z|, the condition q = e is linear about z:
  ///   (1 - D) q + r D s = e.
  /// Within the disc the condition is s = 0, which is e = 0 and D = 1.
  /// In the transition s depends on q - r0 t, too.
  void set_condition(const PatchState& state, Index r, Index size) {
    const Index i = columns_[static_cast<std::size_t>(r)];
    const Vector2d q = pair_of(q_, i), own = pair_of(state.own_slip, i),
                   centre = pair_of(state.centre_slip, i);
    const double own_length = lengths_[i], length = length_ratio_ * own_length;
    const MixedSlip slip = mixed_slip(state, i, q);
    const Vector2d z = q - length * slip.value;
    Vector2d e = Vector2d::Zero();
    Matrix2d D = Matrix2d::Identity();
    if (z.norm() > 1 - within_disc) {
      e = z.normalized();
      D = (D - e * e.transpose()) / z.norm();
    }
    Matrix2d by_q = Matrix2d::Identity() - D;
    Matrix2d by_own = length * (1 - slip.part) * D;
    const Matrix2d by_centre = length * slip.part * D;
    Vector2d right = e;
    if (slip.growth > 0) {
      const Vector2d beyond = q - own_length * own;
      const Matrix2d turned =
          length * slip.growth * D * (centre - own) * beyond.normalized().transpose();
      by_q += turned;
      by_own -= own_length * turned;
      right += turned * beyond;
    }
    by_q /= limits_[i];
    const auto columns = index_view(columns_);
    const Index free = motions_.cols() - 1;
    for (Index c = 0; c < 2; ++c) {
      const Index row = r + c * size;
      system_.row(row).setZero();
      RowVectorXd by_motion = RowVectorXd::Zero(1 + free);
      for (Index d = 0; d < 2; ++d) {
        const Index of = i + d * cells_;
        system_.row(row).head(2 * size) +=
            by_q(c, d) * response_.unknowns().row(of)(columns) +
            by_centre(c, d) * response_.centre_slip().row(of)(columns);
        system_(row, r + d * size) += by_own(c, d);
        by_motion += (by_q(c, d) * response_.unknowns().row(of) +
                      by_centre(c, d) * response_.centre_slip().row(of)) *
                     stuck_;
        by_motion += (by_centre(c, d) * response_.rigid_centre_slip().row(of) +
                      by_own(c, d) * response_.rigid_own_slip().row(of)) *
                     motions_;
        by_motion[0] += by_centre(c, d) * imposed_.centre[of] + by_own(c, d) * imposed_.own[of];
      }
      system_.row(row).tail(free) = by_motion.tail(free);
      right_[row] = right[c] - by_motion[0];
    }
  }

  /// \param j  number of the component among those that follow
  void set_resultant(Index j, Index size) {
    const Index component = free_[static_cast<std::size_t>(j)], row = size + j;
    const auto by_slip = response_.relief().row(component);
    const RowVectorXd by_motion = by_slip * stuck_;
    system_.row(row).head(size) = by_slip(index_view(columns_));
    system_.row(row).tail(by_motion.size() - 1) = by_motion.tail(by_motion.size() - 1);
    right_[row] = load[static_cast<std::size_t>(component)].value - by_motion[0];
  }

  /// Decides which cells slip, and takes their q.
  void take(PatchState& state, double longest_step) {
    for (Index i = 0; i < cells_; ++i) {
      const Vector2d q = quotient(state, i);
      const double length = lengths_[i] * length_ratio_;
      const bool slips_now = (q - length * pair_of(state.own_slip, i)).norm() > 1;
      state.slips[static_cast<std::size_t>(i)] = slips_now;
      Vector2d step = onto_disc(q) - pair_of(q_, i);
      if (slips_now && step.norm() > longest_step) step *= longest_step / step.norm();
      set_pair(q_, i, pair_of(q_, i) + step);
    }
  }

  const PatchResponse& response_;
  const VectorXd& limits_;
  ImposedSlip imposed_;
  Index cells_;
  VectorXd lengths_;
  double length_ratio_ = 1;
  double width_ = 0;
  double tolerance_;
  VectorXd q_;               ///< on the disc
  std::vector<Index> free_;  ///< components that follow from a resultant
  MatrixXd motions_;         ///< the prescribed motion, and a unit of each of these
  MatrixXd stuck_;           ///< elastic slip by them of cells that stick
  RowBlockSolver solver_;
  std::vector<Index> columns_;  ///< longitudinal, then lateral slip of the cells that slip
  PatchResponse::Matrix system_;
  VectorXd right_;
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
                            const ImposedSlip* imposed) {
  Newton newton(response, limits, imposed);
  newton.load = load;
  PatchState state, reached = newton.adhesion();
  const std::span<const Attempt> all = imposed != nullptr
                                           ? std::span<const Attempt>(attempts_at_step)
                                           : std::span<const Attempt>(attempts);
  if (converges(newton, start != nullptr ? *start : reached, all, state)) return state;
  if (imposed != nullptr) {
    throw NotConverged(
        "stick and slip of the step are not found: the resultants may be more than friction "
        "carries together; else shorter steps may help",
        0, state.residual);
  }
  const double part = raise_load(load, [&](const PatchLoad& raised) {
    newton.load = raised;
    const bool is_solved = converges(newton, reached, all.first(attempts_of_part), state);
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
