// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_scale.hpp"

#include <fmt/core.h>

#include <cmath>

#include "component_pairs.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

PatchLoad PatchUnits::scaled(PatchLoad load, const Eigen::Vector3d& motions) const {
  for (std::size_t j = 0; j < load.size(); ++j) {
    load[j].value /= (load[j].by_resultant ? resultant : motions)[static_cast<Index>(j)];
  }
  return load;
}

JoinedRows rows_of(const SteadyPatch& problem) {
  return {problem.bound.shape().scaled(1 / problem.bound.size()), problem.rows, problem.elements};
}

VectorXd limits_of(const JoinedRows& rows, const PatchBound& bound) {
  VectorXd limits(rows.cells());
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      const double theta = rows.theta(i);
      const double limit = bound(rows.lobe(k), rows.psi(k), theta) / bound.peak();
      require(limit > 0, "bound", limit * bound.peak(), "a number > 0 at the centres of all cells");
      limits[rows.cell(i, k)] = limit / std::tan(theta / 2);
    }
  }
  return limits;
}

Eigen::MatrixX2d centres_of(const JoinedRows& rows) {
  Eigen::MatrixX2d centres(rows.cells(), 2);
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      centres.row(rows.cell(i, k)) << rows.x(2 * i + 1, k), rows.y(k);
    }
  }
  return centres;
}

Eigen::MatrixX2d slip_of(const PatchState& state) {
  const auto cells = static_cast<Index>(state.slips.size());
  Eigen::MatrixX2d slip = state.centre_slip.reshaped(cells, 2);
  for (Index i = 0; i < cells; ++i) {
    if (!state.slips[static_cast<std::size_t>(i)]) slip.row(i).setZero();
  }
  return slip;
}

VectorXd within_limits(const VectorXd& unknowns, const VectorXd& limits) {
  VectorXd within = unknowns;
  for (Index i = 0; i < limits.size(); ++i) {
    set_pair(within, i, onto_disc(pair_of(unknowns, i), limits[i]));
  }
  return within;
}

Eigen::MatrixX2d tractions_of(const JoinedRows& rows, const VectorXd& unknowns, double peak) {
  Eigen::MatrixX2d tractions = unknowns.reshaped(rows.cells(), 2);
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      tractions.row(rows.cell(i, k)) *= std::tan(rows.theta(i) / 2) * peak;
    }
  }
  return tractions;
}

Eigen::MatrixX2d tractions_within(const Eigen::MatrixX2d& tractions, const VectorXd& bound) {
  constexpr double rounding = 1e-9;
  require(tractions.rows() == bound.size(), "number of tractions",
          static_cast<double>(tractions.rows()),
          [&] { return fmt::format("one for each of the {} elements", bound.size()); });
  Eigen::MatrixX2d within = tractions;
  for (Index i = 0; i < bound.size(); ++i) {
    const double size = tractions.row(i).norm();
    require(size <= bound[i] + rounding * bound.maxCoeff(), "traction", size,
            [&] { return fmt::format("at most the bound, {}", format_short(bound[i])); });
    if (size > bound[i]) within.row(i) *= bound[i] / size;
  }
  return within;
}

}  // namespace microslip
