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

/// The slip conditions of a line contact.
class SlippingLine : public SlipContact {
 public:
  SlippingLine(ActiveSet& active_set, SlipConditions& conditions, const Prescribed& load,
               const RatioOfSlip& ratio_of, ContactState& state)
      : active_set_(active_set),
        conditions_(conditions),
        load_(load),
        ratio_of_(ratio_of),
        state_(state),
        at_rest_(conditions.bound),
        start_(state) {}

  void begin(double slip, VectorXd& ratios) override {
    state_ = start_;
    ratios.resize(at_rest_.size());
    ratio_of_(VectorXd::Constant(at_rest_.size(), slip), ratios);
  }

  bool solve(const VectorXd& ratios) override {
    conditions_.bound = ratios.cwiseProduct(at_rest_);
    if (load_.by_force && std::abs(load_.value) >= carried_by(conditions_.bound)) return false;
    active_set_.solve(conditions_, load_, state_);
    partitions_ += state_.iterations;
    return true;
  }

  void find_ratios(VectorXd& ratios) override {
    ratios.resize(at_rest_.size());
    ratio_of_(state_.slip, ratios);
  }

  VectorXd tractions() const override { return state_.traction / at_rest_.maxCoeff(); }

  /// The force over that which friction carries at rest.
  double share() const { return std::abs(load_.value) / carried_by(at_rest_); }

  int partitions() const { return partitions_; }

 private:
  double carried_by(const VectorXd& bound) const { return active_set_.weights().dot(bound); }

  ActiveSet& active_set_;
  SlipConditions& conditions_;
  const Prescribed& load_;
  const RatioOfSlip& ratio_of_;
  ContactState& state_;
  VectorXd at_rest_;  ///< the bound
  ContactState start_;
  int partitions_ = 0;
};

}  // namespace

/// Goes on from a slip of all nodes alike until nothing changes.
/// \return whether the resultants are carried all the way
bool SlipFrictionSearch::come_to_an_end(SlipContact& contact, double slip) {
  VectorXd next;
  contact.begin(slip, ratio_);
  FixedPoint way;
  double change = 0;
  for (int round = 0; round < most_rounds; ++round) {
    if (!contact.solve(ratio_)) return false;
    contact.find_ratios(next);
    next -= ratio_;
    change = next.cwiseAbs().maxCoeff();
    if (change <= settled) return true;
    ratio_ = (ratio_ + way.next(next)).cwiseMax(0).cwiseMin(1);
  }
  throw NotConverged("friction that depends on slip: tractions and slip do not settle", most_rounds,
                     change);
}

bool SlipFrictionSearch::solve(SlipContact& contact) {
  constexpr double fast = std::numeric_limits<double>::infinity();
  constexpr double same = 1e-6;
  const bool least = branch_ == SlipBranch::least;
  const bool ends_elsewhere = come_to_an_end(contact, least ? fast : 0);
  const VectorXd other = ends_elsewhere ? contact.tractions() : VectorXd();
  if (!come_to_an_end(contact, least ? 0 : fast)) return false;
  has_second_ = ends_elsewhere && (other - contact.tractions()).cwiseAbs().maxCoeff() > same;
  return true;
}

void SlipFrictionSearch::solve(ActiveSet& active_set, SlipConditions& conditions,
                               const Prescribed& load, const RatioOfSlip& ratio_of,
                               ContactState& state) {
  SlippingLine line(active_set, conditions, load, ratio_of, state);
  if (!solve(line)) {
    throw NotConverged(
        "friction that depends on slip: no creepage is found for the force, as friction may carry "
        "less where the bodies slip",
        0, line.share());
  }
  state.iterations = line.partitions();
}

}  // namespace microslip
