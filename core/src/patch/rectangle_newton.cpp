// SPDX-License-Identifier: GPL-3.0-or-later
#include "rectangle_newton.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "component_pairs.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/work.hpp"
#include "raised_load.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// How Newton's method is tried.
struct RectangleAttempt {
  double length;        ///< r over r0, the reciprocal of an element's own coefficient of B
  double longest_step;  ///< of a traction over its limit, from the third system on
  int systems;
};

/// The first one solves 14308 of 14312 random steady loads, a/b = 0.2 ... 5 with 4 to 25 elements
/// along an axis, and 24741 of 24746 steps.
constexpr RectangleAttempt rectangle_attempts[] = {
    {0.3, 2, 30}, {1, 0.7, 40}, {0.1, 0.7, 40}, {0.3, 0.3, 60}};

constexpr double accuracy_of_conditions = 1e-9;
constexpr double accuracy_of_systems = 1e-4;
constexpr int most_rectangle_iterations = 200;

/// The condition of an element, linear about a state: by_traction p + by_slip r s = right.
struct LinearCondition {
  Matrix2d by_traction = Matrix2d::Zero(), by_slip = Matrix2d::Identity();
  Vector2d right = Vector2d::Zero();

  LinearCondition() = default;  // of an element that sticks

  /// With z = p - r s, e = z/|z| and D = (1 - e e') g/|z|, p = g e becomes
  ///   (1 - D) p + D r s = g e.
  LinearCondition(const Vector2d& z, double limit) {
    const double size = z.norm();
    const Vector2d e = z / size;
    by_slip = (Matrix2d::Identity() - e * e.transpose()) * (limit / size);
    by_traction = Matrix2d::Identity() - by_slip;
    right = limit * e;
  }
};

class RectangleNewton {
 public:
  PatchLoad load;  ///< in the place of that of the conditions; the same components are resultants

  explicit RectangleNewton(const RectangleConditions& of)
      : load(of.load),
        of_(of),
        cells_(of.rectangles.size()),
        conditions_(static_cast<std::size_t>(cells_)) {
    const RectangleInfluence& B = of.influence;
    own_length_ = 1 / std::max(B.along(0), B.across(0));
    for (Index j = 0; j < 3; ++j) {
      if (of.load[static_cast<std::size_t>(j)].by_resultant) free_.push_back(j);
    }
    for (Index j = 0; j < 3; ++j) {
      resultant_unit_[j] = of.resultants.row(j).norm();
      full_resultant_[j] = 0;
      for (Index i = 0; i < cells_; ++i)
        full_resultant_[j] += of.limits[i] * pair_of(of.resultants.row(j).transpose(), i).norm();
    }
  }

  RectangleState at_rest() const {
    RectangleState state{.tractions = VectorXd::Zero(2 * cells_),
                         .slip = VectorXd::Zero(2 * cells_),
                         .motion = Vector3d::Zero(),
                         .slips = std::vector<bool>(static_cast<std::size_t>(cells_), false)};
    prescribe(state);
    return state;
  }

  /// Whether it converges from a state; without `follows`, from full adhesion.
  bool converges(RectangleState& state, const RectangleAttempt& attempt, bool follows) {
    prescribe(state);
    length_ = attempt.length * own_length_;
    VectorXd p = state.tractions;  // on the discs
    for (Index i = 0; i < cells_; ++i) set_pair(p, i, onto_disc(pair_of(p, i), of_.limits[i]));
    if (follows) state.tractions = p;
    find_slip(state);
    if (follows) {
      linearise(state, p);
    } else {
      std::fill(conditions_.begin(), conditions_.end(), LinearCondition());
    }
    for (int k = 0; k < attempt.systems; ++k) {
      solve_system(state);
      ++state.iterations;
      find_slip(state);
      state.residual = residual(state);
      if (state.residual < accuracy_of_conditions) return true;
      if (!std::isfinite(state.residual)) return false;
      move(state, p, k < 2 ? std::numeric_limits<double>::infinity() : attempt.longest_step);
      linearise(state, p);
    }
    return false;
  }

  /// Marks elements that slip, and removes what is left of slip elsewhere.
  void finish(RectangleState& state) const {
    state.slips.assign(static_cast<std::size_t>(cells_), false);
    for (Index i = 0; i < cells_; ++i) {
      const Vector2d p = pair_of(state.tractions, i), s = pair_of(state.slip, i);
      const bool slips_here = (p - own_length_ * s).norm() > of_.limits[i];
      state.slips[static_cast<std::size_t>(i)] = slips_here;
      set_pair(state.tractions, i, onto_disc(p, of_.limits[i]));
      if (!slips_here) set_pair(state.slip, i, Vector2d::Zero());
    }
  }

 private:
  void prescribe(RectangleState& state) const {
    for (Index j = 0; j < 3; ++j) {
      const PatchComponent& component = load[static_cast<std::size_t>(j)];
      if (!component.by_resultant) state.motion[j] = component.value;
    }
  }

  void find_slip(RectangleState& state) const {
    of_.influence.apply(state.tractions, state.slip);
    state.slip += of_.given;
    state.slip.noalias() += of_.rigid * state.motion;
  }

  double missing(const RectangleState& state, Index j) const {
    return load[static_cast<std::size_t>(j)].value - of_.resultants.row(j).dot(state.tractions);
  }

  double residual(const RectangleState& state) const {
    double largest = 0;
    for (Index i = 0; i < cells_; ++i) {
      const Vector2d p = pair_of(state.tractions, i);
      const double error =
          (p - onto_disc(p - own_length_ * pair_of(state.slip, i), of_.limits[i])).norm();
      if (!(error <= largest)) largest = error;
    }
    for (const Index j : free_) {
      const double error = std::abs(missing(state, j)) / full_resultant_[j];
      if (!(error <= largest)) largest = error;
    }
    return largest;
  }

  /// Moves the tractions about which conditions are linear.
  void move(const RectangleState& state, VectorXd& p, double longest_step) const {
    for (Index i = 0; i < cells_; ++i) {
      const double limit = of_.limits[i];
      const Vector2d to = pair_of(state.tractions, i), former = pair_of(p, i);
      Vector2d step = onto_disc(to, limit) - former;
      const bool slips_here = (to - length_ * pair_of(state.slip, i)).norm() > limit;
      if (slips_here && step.norm() > longest_step * limit)
        step *= longest_step * limit / step.norm();
      set_pair(p, i, former + step);
    }
  }

  void linearise(const RectangleState& state, const VectorXd& p) {
    for (Index i = 0; i < cells_; ++i) {
      const double limit = of_.limits[i];
      const Vector2d drift = length_ * pair_of(state.slip, i);
      const bool slips_here = (pair_of(state.tractions, i) - drift).norm() > limit;
      conditions_[static_cast<std::size_t>(i)] =
          slips_here ? LinearCondition(pair_of(p, i) - drift, limit) : LinearCondition();
    }
  }

  /// Solves for the change of tractions and of the motion that follows.
  void solve_system(RectangleState& state) {
    const Index size = 2 * cells_, free = static_cast<Index>(free_.size());
    factor();
    VectorXd right(size + free), change(size + free);
    for (Index i = 0; i < cells_; ++i) {
      const LinearCondition& c = conditions_[static_cast<std::size_t>(i)];
      const Vector2d value = c.right - c.by_traction * pair_of(state.tractions, i) -
                             length_ * (c.by_slip * pair_of(state.slip, i));
      right[i] = value[0];
      right[cells_ + i] = value[1];
    }
    for (Index j = 0; j < free; ++j) {
      const Index component = free_[static_cast<std::size_t>(j)];
      right[size + j] = missing(state, component) / resultant_unit_[component];
    }
    const auto matrix = [&](const VectorXd& x, VectorXd& y) {
      slip_.resize(size);
      of_.influence.apply(x.head(size), slip_);
      for (Index j = 0; j < free; ++j) {
        slip_ += x[size + j] * of_.rigid.col(free_[static_cast<std::size_t>(j)]);
      }
      y.resize(size + free);
      for (Index i = 0; i < cells_; ++i) {
        const LinearCondition& c = conditions_[static_cast<std::size_t>(i)];
        const Vector2d value = c.by_traction * Vector2d(x[i], x[cells_ + i]) +
                               length_ * (c.by_slip * pair_of(slip_, i));
        y[i] = value[0];
        y[cells_ + i] = value[1];
      }
      for (Index j = 0; j < free; ++j) y[size + j] = resultant_row(j).dot(x.head(size));
    };
    const auto preconditioner = [&](const VectorXd& x, VectorXd& y) { precondition(x, y); };
    gmres_.solve(matrix, preconditioner, right, accuracy_of_systems, change);
    state.tractions += change.head(size);
    for (Index j = 0; j < free; ++j)
      state.motion[free_[static_cast<std::size_t>(j)]] += change[size + j];
  }

  Eigen::RowVectorXd resultant_row(Index j) const {
    const Index component = free_[static_cast<std::size_t>(j)];
    return of_.resultants.row(component) / resultant_unit_[component];
  }

  /// Factors the blocks of rows, and what the motion needs.
  void factor() {
    const Rectangles& of = of_.rectangles;
    blocks_.resize(static_cast<std::size_t>(of.rows()));
    for (Index k = 0; k < of.rows(); ++k) {
      const Index begin = of.first_of(k), m = of.first_of(k + 1) - begin;
      MatrixXd block(2 * m, 2 * m);
      for (Index j = 0; j < m; ++j) {
        for (Index i = 0; i < m; ++i) {
          const LinearCondition& c = conditions_[static_cast<std::size_t>(begin + i)];
          const Index distance = of.column(begin + i) - of.column(begin + j);
          Matrix2d part =
              length_ * c.by_slip *
              Vector2d(of_.influence.along(distance), of_.influence.across(distance)).asDiagonal();
          if (i == j) part += c.by_traction;
          block(i, j) = part(0, 0);
          block(m + i, j) = part(1, 0);
          block(i, m + j) = part(0, 1);
          block(m + i, m + j) = part(1, 1);
        }
      }
      if (m > 0) blocks_[static_cast<std::size_t>(k)].compute(block);
      count_work(2.0 / 3 * std::pow(2.0 * static_cast<double>(m), 3));
    }
    const Index free = static_cast<Index>(free_.size()), size = 2 * cells_;
    by_motion_.resize(size, free);
    for (Index j = 0; j < free; ++j) {
      VectorXd column(size), solved(size);
      const auto rigid = of_.rigid.col(free_[static_cast<std::size_t>(j)]);
      for (Index i = 0; i < cells_; ++i) {
        const LinearCondition& c = conditions_[static_cast<std::size_t>(i)];
        set_pair(column, i, length_ * (c.by_slip * Vector2d(rigid[i], rigid[cells_ + i])));
      }
      precondition_rows(column, solved);
      by_motion_.col(j) = solved;
    }
    MatrixXd schur(free, free);
    for (Index j = 0; j < free; ++j) schur.row(j) = resultant_row(j) * by_motion_;
    if (free > 0) schur_.compute(schur);
  }

  void precondition_rows(const VectorXd& x, VectorXd& y) const {
    const Rectangles& of = of_.rectangles;
    y.resize(x.size());
    for (Index k = 0; k < of.rows(); ++k) {
      const Index begin = of.first_of(k), m = of.first_of(k + 1) - begin;
      if (m == 0) continue;
      VectorXd part(2 * m);
      part << x.segment(begin, m), x.segment(cells_ + begin, m);
      const VectorXd solved = blocks_[static_cast<std::size_t>(k)].solve(part);
      y.segment(begin, m) = solved.head(m);
      y.segment(cells_ + begin, m) = solved.tail(m);
      count_work(2 * std::pow(2.0 * static_cast<double>(m), 2));
    }
  }

  void precondition(const VectorXd& x, VectorXd& y) const {
    const Index size = 2 * cells_, free = static_cast<Index>(free_.size());
    precondition_rows(x, y);
    if (free == 0) return;
    VectorXd wanted(free);
    for (Index j = 0; j < free; ++j) wanted[j] = resultant_row(j).dot(y.head(size)) - x[size + j];
    const VectorXd motion = schur_.solve(wanted);
    y.head(size) -= by_motion_ * motion;
    y.tail(free) = motion;
  }

  const RectangleConditions& of_;
  Index cells_;
  std::vector<LinearCondition> conditions_;
  double own_length_, length_ = 0;
  Vector3d resultant_unit_;  ///< by which rows of the system have the size 1
  Vector3d full_resultant_;  ///< the largest ones that the limits allow
  std::vector<Index> free_;
  std::vector<LuFactors> blocks_;
  MatrixXd by_motion_;
  LuFactors schur_;
  VectorXd slip_;
  Gmres gmres_{most_rectangle_iterations};
};

}  // namespace

RectangleState solve_rectangles(const RectangleConditions& conditions,
                                const RectangleState* start) {
  RectangleNewton newton(conditions);
  RectangleState state = start != nullptr ? *start : newton.at_rest();
  state.iterations = 0;
  bool found = start != nullptr && newton.converges(state, rectangle_attempts[0], true);
  const auto from = [&](const RectangleState& begin, const RectangleAttempt& attempt,
                        bool follows) {
    const int iterations = state.iterations;
    state = begin;
    state.iterations = iterations;
    return newton.converges(state, attempt, follows);
  };
  for (const RectangleAttempt& attempt : rectangle_attempts) {
    if (!found) found = from(newton.at_rest(), attempt, false);
  }
  double part = 1;
  if (!found) {
    RectangleState reached = newton.at_rest();
    bool follows = false;
    part = raise_load(conditions.load, [&](const PatchLoad& raised) {
      newton.load = raised;
      if (!from(reached, rectangle_attempts[0], follows)) return false;
      reached = state;
      return follows = true;
    });
  }
  if (part < 1) {
    throw NotConverged(
        fmt::format("stick and slip of equal rectangles are found up to {} of the load: the "
                    "resultants may be more than friction carries together",
                    format_roughly(part)),
        0, state.residual);
  }
  newton.finish(state);
  return state;
}

}  // namespace microslip
