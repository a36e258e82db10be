// SPDX-License-Identifier: GPL-3.0-or-later
#include "row_block_solver.hpp"

#include <algorithm>
#include <utility>

#include "microslip/linalg/index_view.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Systems from this size on take less time by GMRES.
constexpr Index least_of_iterative = 150;

/// Relative to what is missing at the start, which Newton's method makes smaller each time.
constexpr double gmres_tolerance = 1e-6;

}  // namespace

VectorXd RowBlockSolver::solve(const PatchResponse::Matrix& system, const VectorXd& right,
                               const VectorXd& near, const std::vector<Index>& rows) {
  if (right.size() < least_of_iterative) return LuFactors(system).solve(right);
  const VectorXd missing = right - system * near;
  factor(system, rows);
  VectorXd correction;
  const auto outcome =
      gmres_.solve([&](const VectorXd& x, VectorXd& y) { y.noalias() = system * x; },
                   [&](const VectorXd& x, VectorXd& y) { precondition(x, y); }, missing,
                   gmres_tolerance, correction);
  if (!(outcome.residual <= gmres_tolerance)) return LuFactors(system).solve(right);
  return near + correction;
}

/// A block has both components of the slip in a row.
void RowBlockSolver::factor(const PatchResponse::Matrix& system, const std::vector<Index>& rows) {
  blocks_.clear();
  const Index last = rows.empty() ? -1 : *std::ranges::max_element(rows);
  blocks_.resize(static_cast<std::size_t>(last + 1));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    blocks_[static_cast<std::size_t>(rows[i])].places.push_back(static_cast<Index>(i));
  }
  std::erase_if(blocks_, [](const Block& block) { return block.places.empty(); });
  for (Block& block : blocks_) {
    const auto places = index_view(block.places);
    block.factors.compute(system(places, places));
  }
}

void RowBlockSolver::precondition(const VectorXd& x, VectorXd& y) const {
  y = x;
  for (const Block& block : blocks_) {
    const auto places = index_view(block.places);
    const VectorXd part = block.factors.solve(x(places));
    y(places) = part;
  }
}

}  // namespace microslip
