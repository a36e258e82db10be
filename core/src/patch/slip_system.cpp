// SPDX-License-Identifier: GPL-3.0-or-later
#include "slip_system.hpp"

#include "component_pairs.hpp"
#include "microslip/linalg/index_view.hpp"
#include "microslip/linalg/matrix_product.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::RowVectorXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Splits the motion of a load into the prescribed one and the components that follow.
void SlipSystem::split_motion(const PatchLoad& load) {
  free_.clear();
  for (std::size_t j = 0; j < load.size(); ++j) {
    if (load[j].by_resultant) free_.push_back(static_cast<Index>(j));
  }
  motions_.setZero(3, 1 + static_cast<Index>(free_.size()));
  for (std::size_t j = 0; j < load.size(); ++j) {
    if (!load[j].by_resultant) motions_(static_cast<Index>(j), 0) = load[j].value;
  }
  for (std::size_t j = 0; j < free_.size(); ++j) {
    motions_(free_[j], 1 + static_cast<Index>(j)) = 1;
  }
}

void SlipSystem::assemble(const CellConditions& conditions, const PatchState& state,
                          const VectorXd& q, const PatchLoad& load, const ImposedSlip& imposed) {
  const Index cells = limits_.size();
  split_motion(load);
  columns_.clear();
  slides_.assign(static_cast<std::size_t>(cells), false);
  stuck_ = -matrix_product(response_.rigid_own_slip(), motions_);
  stuck_.col(0) -= imposed.own;
  for (Index i = 0; i < cells; ++i) {
    if (!state.slips[static_cast<std::size_t>(i)]) continue;
    columns_.push_back(i);
    stuck_.row(i).setZero();
    stuck_.row(cells + i).setZero();
  }
  const auto size = static_cast<Index>(columns_.size());
  places_.resize(static_cast<std::size_t>(cells));
  for (Index r = 0; r < size; ++r) {
    places_[static_cast<std::size_t>(columns_[static_cast<std::size_t>(r)])] = r;
    columns_.push_back(cells + columns_[static_cast<std::size_t>(r)]);
  }
  const auto free = static_cast<Index>(free_.size());
  matrix_.resize(2 * size + free, 2 * size + free);
  right_.resize(2 * size + free);
  for (Index r = 0; r < size; ++r) {
    const Index i = columns_[static_cast<std::size_t>(r)];
    const CellCondition condition = conditions.about(i, pair_of(q, i));
    slides_[static_cast<std::size_t>(i)] = condition.slides;
    set_condition(condition, r, size, imposed);
  }
  for (Index j = 0; j < free; ++j) set_resultant(load, j, 2 * size);
}

void SlipSystem::set_condition(const CellCondition& condition, Index r, Index size,
                               const ImposedSlip& imposed) {
  const Index cells = limits_.size(), i = columns_[static_cast<std::size_t>(r)];
  const Eigen::Matrix2d by_q = condition.by_q / limits_[i];
  const Index free = motions_.cols() - 1;
  for (Index c = 0; c < 2; ++c) {
    const Index row = r + c * size;
    RowVectorXd by_motion = RowVectorXd::Zero(1 + free);
    by_elastic_.setZero(2 * cells);
    for (Index d = 0; d < 2; ++d)
      by_elastic_ += by_q(c, d) * response_.unknowns().row(i + d * cells);
    matrix_.row(row).setZero();
    for (const auto& [cell, own, centre, by_pole, q_of_cell] : condition.by_slip()) {
      if (by_pole[c] != 0) by_elastic_ += by_pole[c] * response_.pole_slip().row(cell);
      for (Index d = 0; d < 2; ++d) {
        const Index of = cell + d * cells;
        const double by_centre = centre(c, d), by_own = own(c, d), by_q_of = q_of_cell(c, d);
        if (by_q_of != 0) by_elastic_ += by_q_of / limits_[cell] * response_.unknowns().row(of);
        if (by_centre == 0 && by_own == 0) continue;
        by_elastic_ += by_centre * response_.centre_slip().row(of);
        by_motion += (by_centre * response_.rigid_centre_slip().row(of) +
                      by_own * response_.rigid_own_slip().row(of)) *
                     motions_;
        by_motion[0] += by_centre * imposed.centre[of] + by_own * imposed.own[of];
        if (by_own != 0) matrix_(row, places_[static_cast<std::size_t>(cell)] + d * size) += by_own;
      }
    }
    by_motion.noalias() += by_elastic_ * stuck_;
    matrix_.row(row).head(2 * size) += by_elastic_(index_view(columns_));
    matrix_.row(row).tail(free) = by_motion.tail(free);
    right_[row] = condition.right[c] - by_motion[0];
  }
}

/// \param j  number of the component among those that follow
void SlipSystem::set_resultant(const PatchLoad& load, Index j, Index size) {
  const Index component = free_[static_cast<std::size_t>(j)], row = size + j;
  const RowVectorXd by_slip = response_.relief().row(component);
  RowVectorXd by_motion = RowVectorXd::Zero(stuck_.cols());
  by_motion.noalias() += by_slip * stuck_;
  matrix_.row(row).head(size) = by_slip(index_view(columns_));
  matrix_.row(row).tail(by_motion.size() - 1) = by_motion.tail(by_motion.size() - 1);
  right_[row] = load[static_cast<std::size_t>(component)].value - by_motion[0];
}

std::vector<Index> SlipSystem::rows_of_unknowns() const {
  std::vector<Index> rows;
  for (const Index column : columns_) {
    rows.push_back(column % limits_.size() / response_.rows().elements());
  }
  return rows;
}

VectorXd SlipSystem::unknowns_of(const PatchState& state, const ImposedSlip& imposed) const {
  VectorXd values(right_.size());
  const auto size = static_cast<Index>(columns_.size());
  for (Index r = 0; r < size; ++r) {
    const Index column = columns_[static_cast<std::size_t>(r)];
    values[r] = state.own_slip[column] - response_.rigid_own_slip().row(column) * state.motion -
                imposed.own[column];
  }
  values.tail(values.size() - size) = state.motion(index_view(free_));
  return values;
}

void SlipSystem::apply(const VectorXd& solution, const CellConditions& conditions,
                       const ImposedSlip& imposed, PatchState& state) const {
  const auto columns = index_view(columns_);
  const auto free = static_cast<Index>(free_.size());
  VectorXd motion(1 + free);
  motion << 1, solution.tail(free);
  state.motion = motions_ * motion;
  VectorXd elastic = stuck_ * motion;
  elastic(columns) = solution.head(static_cast<Index>(columns_.size()));
  state.unknowns.noalias() = response_.unknowns() * elastic;
  state.own_slip.setZero();
  for (const Index c : columns_) {
    state.own_slip[c] =
        elastic[c] + response_.rigid_own_slip().row(c) * state.motion + imposed.own[c];
  }
  response_.see(state.own_slip, imposed.seen, state.seen_slip);
  const Index cells = limits_.size();
  state.centre_slip.setZero();
  for (Index c = 0; c < 2 * cells; ++c) {
    if (!conditions.has_centre_slip(c % cells, state.slips)) continue;
    state.centre_slip[c] = response_.centre_slip().row(c).dot(elastic) +
                           response_.rigid_centre_slip().row(c) * state.motion + imposed.centre[c];
  }
}

}  // namespace microslip
