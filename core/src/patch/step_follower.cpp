// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_follower.hpp"

#include <cmath>

#include "component_pairs.hpp"
#include "microslip/linalg/index_view.hpp"
#include "microslip/linalg/matrix_product.hpp"
#include "slip_system.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

constexpr int most_corrections = 12;

/// Residual of a solved step, below the one that other ways accept: corrections go on until they
/// are rounding, so that short steps do not inherit each other's errors.
constexpr double largest_residual = 1e-10;

/// Below this one, a residual that is not made smaller is rounding.
constexpr double rounding_of_corrections = 1e-8;

/// A correction that leaves more than this part is too slow.
constexpr double slowest = 0.5;

bool slips(const std::vector<bool>& slips, Index i) { return slips[static_cast<std::size_t>(i)]; }

}  // namespace

StepFollower::StepFollower(const PatchResponse& response, const VectorXd& limits,
                           const PatchState& state, const PatchLoad& load)
    : response_(&response), limits_(&limits), conditions_(response, limits) {
  const Index n = limits.size();
  SlipSystem system(response, limits);
  const ImposedSlip none{VectorXd::Zero(2 * n), VectorXd::Zero(2 * n)};
  conditions_.look_at(state);
  system.assemble(conditions_, state, conditions_.quotients(), load, none);
  const auto made = std::make_shared<Prepared>();
  made->state = state;
  made->load = load;
  made->columns = system.columns();
  made->free = system.free();
  made->factors.compute(system.matrix());
  for (Index c = 0; c < 2 * n; ++c) {
    if (conditions_.has_centre_slip(c % n, state.slips)) made->centres.push_back(c);
  }
  const auto columns = index_view(made->columns), centres = index_view(made->centres);
  const auto count = static_cast<Index>(made->columns.size());
  const auto free = static_cast<Index>(made->free.size());
  const MatrixXd units = system.motions().rightCols(free), stuck = system.stuck().rightCols(free);
  made->tractions.resize(2 * n, count + free);
  made->tractions << MatrixXd(response.unknowns()(Eigen::all, columns)),
      matrix_product(stuck.transpose(), response.unknowns().transpose()).transpose();
  made->centre_slip_elastic = response.centre_slip()(centres, Eigen::all);
  made->rigid = matrix_product(response.rigid_own_slip()(columns, Eigen::all), units);
  const auto slips = static_cast<Index>(made->centres.size());
  made->centre_slip.resize(slips, count + free);
  made->centre_slip << MatrixXd(response.centre_slip()(centres, columns)),
      matrix_product(stuck.transpose(), made->centre_slip_elastic.transpose()).transpose() +
          matrix_product(response.rigid_centre_slip()(centres, Eigen::all), units);
  prepared_ = made;
  elastic_.resize(2 * n);
  tractions_.resize(2 * n);
  missing_.resize(count + free);
  correction_.resize(count + free);
  slip_.resize(slips);
}

bool StepFollower::fits(const PatchLoad& load, const std::vector<bool>& slips) const {
  for (std::size_t j = 0; j < load.size(); ++j) {
    if (load[j].by_resultant != prepared_->load[j].by_resultant) return false;
  }
  return slips == prepared_->state.slips;
}

/// Keeps the own slip and the free components of the motion, and lets all else follow.
void StepFollower::begin(const PatchLoad& load, const ImposedSlip& imposed, PatchState& state) {
  for (std::size_t j = 0; j < load.size(); ++j) {
    if (!load[j].by_resultant) state.motion[static_cast<Index>(j)] = load[j].value;
  }
  elastic_ = state.own_slip - imposed.own;
  elastic_.noalias() -= response_->rigid_own_slip() * state.motion;
  state.unknowns.noalias() = response_->unknowns() * elastic_;
  slip_.noalias() = prepared_->centre_slip_elastic * elastic_;
  state.centre_slip.setZero();
  for (std::size_t r = 0; r < prepared_->centres.size(); ++r) {
    const Index c = prepared_->centres[r];
    state.centre_slip[c] = slip_[static_cast<Index>(r)] +
                           response_->rigid_centre_slip().row(c) * state.motion + imposed.centre[c];
  }
  state.iterations = 0;
}

/// The largest error; infinite if a cell begins or ends to slip. The state gets the slip that is seen.
double StepFollower::residual(const ImposedSlip& imposed, PatchState& state) {
  response_->see(state.own_slip, imposed.seen, state.seen_slip);
  conditions_.look_at(state);
  double largest = 0;
  for (Index i = 0; i < limits_->size(); ++i) {
    if (conditions_.slips_next(i, conditions_.quotient(i)) != slips(prepared_->state.slips, i))
      return INFINITY;
    const double found = conditions_.error(i).norm();
    if (!(found <= largest)) largest = found;
  }
  return largest;
}

/// Takes one correction, by what is missing in the conditions about the present state.
bool StepFollower::correct(const PatchLoad& load, PatchState& state) {
  const auto count = static_cast<Index>(prepared_->columns.size()), size = count / 2;
  for (Index r = 0; r < size; ++r) {
    const Index i = prepared_->columns[static_cast<std::size_t>(r)];
    const Vector2d error = conditions_.error(i);
    missing_[r] = -error[0];
    missing_[size + r] = -error[1];
  }
  for (std::size_t j = 0; j < prepared_->free.size(); ++j) {
    missing_[count + static_cast<Index>(j)] =
        load[static_cast<std::size_t>(prepared_->free[j])].value -
        response_->resultants().row(prepared_->free[j]).dot(state.unknowns);
  }
  prepared_->factors.solve(missing_, correction_);
  tractions_.noalias() = prepared_->tractions * correction_;
  state.unknowns += tractions_;
  slip_.noalias() = prepared_->centre_slip * correction_;
  for (std::size_t r = 0; r < prepared_->columns.size(); ++r) {
    const auto place = static_cast<Index>(r);
    double own = correction_[place];
    for (Index j = 0; j < prepared_->rigid.cols(); ++j)
      own += prepared_->rigid(place, j) * correction_[count + j];
    state.own_slip[prepared_->columns[r]] += own;
  }
  for (std::size_t r = 0; r < prepared_->centres.size(); ++r) {
    state.centre_slip[prepared_->centres[r]] += slip_[static_cast<Index>(r)];
  }
  for (std::size_t j = 0; j < prepared_->free.size(); ++j) {
    state.motion[prepared_->free[j]] += correction_[count + static_cast<Index>(j)];
  }
  ++state.iterations;
  return correction_.allFinite();
}

bool StepFollower::converges(const PatchLoad& load, const ImposedSlip& imposed, PatchState& state) {
  begin(load, imposed, state);
  state.residual = residual(imposed, state);
  for (int i = 0; i < most_corrections; ++i) {
    const double before = state.residual;
    // The first residual knows no resultant.
    if (before < largest_residual && (i > 0 || prepared_->free.empty())) return true;
    if (!std::isfinite(before) || !correct(load, state)) return false;
    state.residual = residual(imposed, state);
    const bool is_slow = i > 1 && state.residual > slowest * before;
    if (is_slow) return state.residual < rounding_of_corrections;
  }
  return false;
}

bool StepFollower::follow(const PatchLoad& load, const ImposedSlip& imposed, PatchState& state) {
  if (!converges(load, imposed, state)) return false;
  conditions_.find_carried(state.carried);
  return true;
}

}  // namespace microslip
