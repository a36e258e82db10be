// SPDX-License-Identifier: GPL-3.0-or-later
#include "slip_friction_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "microslip/support/not_converged.hpp"

namespace microslip {

using Eigen::VectorXd;

namespace {

constexpr int most_rounds = 3000;
constexpr double settled = 1e-8;

/// The way to a fixed point. Where the changes of many rounds have the same direction and fall by
/// the same factor, their sum is taken at once; where they do not fall, only a part of each is made.
class FixedPoint {
 public:
  /// \param change  that the next round asks for
  /// \return the change to make
  VectorXd next(const VectorXd& change) {
    const double size = change.cwiseAbs().maxCoeff();
    if (size < falling * least_) {
      least_ = size;
      since_ = 0;
    } else if (++since_ > patience) {
      part_ = std::max(part_ / 2, smallest_part);
      least_ = size;
      since_ = 0;
    }
    VectorXd made = part_ * change;
    if (++round_ % rounds_between == 0) made *= sum_of_rest(change);
    before_ = change;
    return made;
  }

 private:
  static constexpr double falling = 0.9, smallest_part = 1.0 / 16;
  static constexpr int patience = 50, rounds_between = 16;

  /// The sum of a geometric series over its first term; 1 if the changes are none.
  double sum_of_rest(const VectorXd& change) const {
    constexpr double slowest = 0.999, fastest = 0.5, aligned = 0.98;
    if (before_.size() == 0) return 1;
    const double along = change.dot(before_);
    const double ratio = along / before_.squaredNorm();
    const bool has_direction =
        along * along > aligned * change.squaredNorm() * before_.squaredNorm();
    if (!has_direction || !(ratio > fastest && ratio < slowest)) return 1;
    return 1 / (1 - ratio);
  }

  double least_ = std::numeric_limits<double>::infinity(), part_ = 1;
  int since_ = 0, round_ = 0;
  VectorXd before_;
};

}  // namespace

/// Goes on from a slip of all nodes alike until nothing changes.
/// \param at_rest  the bound at rest
/// \return whether a force is carried all the way
bool SlipFrictionSearch::come_to_an_end(ActiveSet& active_set, SlipConditions& conditions,
                                        const Prescribed& load, const RatioOfSlip& ratio_of,
                                        const VectorXd& at_rest, double slip, ContactState& state) {
  VectorXd next(at_rest.size());
  ratio_.resize(at_rest.size());
  ratio_of(VectorXd::Constant(at_rest.size(), slip), ratio_);
  FixedPoint way;
  double change = 0;
  int partitions = 0;
  for (int round = 0; round < most_rounds; ++round) {
    conditions.bound = ratio_.cwiseProduct(at_rest);
    if (load.by_force && std::abs(load.value) >= active_set.weights().dot(conditions.bound)) {
      return false;
    }
    active_set.solve(conditions, load, state);
    partitions += state.iterations;
    ratio_of(state.slip, next);
    next -= ratio_;
    change = next.cwiseAbs().maxCoeff();
    if (change <= settled) {
      state.iterations = partitions;
      return true;
    }
    ratio_ = (ratio_ + way.next(next)).cwiseMax(0).cwiseMin(1);
  }
  throw NotConverged("friction that depends on slip: tractions and slip do not settle", most_rounds,
                     change);
}

void SlipFrictionSearch::solve(ActiveSet& active_set, SlipConditions& conditions,
                               const Prescribed& load, const RatioOfSlip& ratio_of,
                               ContactState& state) {
  constexpr double fast = std::numeric_limits<double>::infinity();
  constexpr double same = 1e-6;
  const VectorXd at_rest = conditions.bound;
  const bool least = branch_ == SlipBranch::least;
  ContactState other = state;
  const auto from = [&](double slip, ContactState& to) {
    return come_to_an_end(active_set, conditions, load, ratio_of, at_rest, slip, to);
  };
  const bool ends_elsewhere = from(least ? fast : 0, other);
  if (!from(least ? 0 : fast, state)) {
    throw NotConverged(
        "friction that depends on slip: the force is more than it carries where the bodies slip", 0,
        std::abs(load.value) / active_set.weights().dot(at_rest));
  }
  const double largest = same * at_rest.maxCoeff();
  has_second_ = ends_elsewhere && (other.traction - state.traction).cwiseAbs().maxCoeff() > largest;
  state.iterations += other.iterations;
}

}  // namespace microslip
