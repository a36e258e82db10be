// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_friction.hpp"

#include <cmath>

#include "cell_conditions.hpp"
#include "microslip/support/not_converged.hpp"
#include "patch_scale.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// The equations are over the bound. One that the law takes away is as small as this part of that at
/// rest.
constexpr double least_ratio = 1e-6;

}  // namespace

SlippingPatch::SlippingPatch(const Equations& equations, const FrictionRows& rows, double dq,
                             double speed)
    : given_(equations),
      rows_(rows),
      dq_(dq),
      speed_(speed),
      arms_(centres_of(equations.response.rows()).rowwise().norm()) {}

void SlippingPatch::begin(double slip, VectorXd& ratios) {
  is_new_ = true;
  rows_.follow(dq_, VectorXd::Constant(given_.at_rest.size(), slip), ratios);
}

/// Whether friction carries each resultant on its own, and the vector of the forces.
bool SlippingPatch::carries() const {
  const Index n = limits_.size();
  const VectorXd forces =
      given_.response.resultants().row(0).head(n).transpose().cwiseProduct(limits_);
  double squares = 0;
  for (std::size_t j = 0; j < 2; ++j) {
    if (given_.load[j].by_resultant) squares += given_.load[j].value * given_.load[j].value;
  }
  const double force = forces.sum();
  const auto& [turns, moment] = given_.load[2];
  return squares < force * force && !(turns && std::abs(moment) >= forces.dot(arms_));
}

bool SlippingPatch::solve(const VectorXd& ratios) {
  limits_ = ratios.cwiseMax(least_ratio).cwiseProduct(given_.at_rest);
  if (!carries()) return false;
  try {
    state_ = solve_stick_slip(given_.response, limits_, given_.load,
                              is_new_ ? given_.start : &state_, given_.imposed);
  } catch (const NotConverged&) {
    return false;
  }
  is_new_ = false;
  iterations_ += state_.iterations;
  state_.iterations = iterations_;
  return true;
}

VectorXd SlippingPatch::speeds() const {
  CellConditions conditions(given_.response, limits_);
  conditions.look_at(state_);
  VectorXd speeds = VectorXd::Zero(limits_.size());
  for (Index i = 0; i < speeds.size(); ++i) {
    if (!state_.slips[static_cast<std::size_t>(i)]) continue;
    speeds[i] = speed_ * conditions.slip(i).norm();
  }
  return speeds;
}

void SlippingPatch::find_ratios(VectorXd& ratios) { rows_.follow(dq_, speeds(), ratios); }

VectorXd SlippingPatch::tractions() const {
  return tractions_of(given_.response.rows(), state_.unknowns, 1).reshaped();
}

bool solve_by_friction(SlippingPatch& patch, SlipBranch branch) {
  SlipFrictionSearch search(branch);
  if (!search.solve(patch)) {
    throw NotConverged(
        "friction that depends on slip: no solution is found, as friction falls too fast with "
        "slip; "
        "a longer memory has one, and so have smaller resultants, if any are prescribed",
        0, 0);
  }
  return search.has_second();
}

}  // namespace microslip
