// SPDX-License-Identifier: GPL-3.0-or-later
#include "rolled_tables.hpp"

#include "microslip/experiments/profile.hpp"
#include "microslip/support/interpolation.hpp"

namespace microslip::experiments {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Returns the largest x at which |p| reaches the level.
double flank_of(const VectorXd& x, const VectorXd& traction, double level) {
  const VectorXd p = traction.cwiseAbs();
  Index i = p.size() - 1;
  while (i > 0 && p[i - 1] < level) --i;
  return i == 0 ? x[0] : x[i] - (x[i] - x[i - 1]) * (level - p[i]) / (p[i - 1] - p[i]);
}

}  // namespace

RolledTables::RolledTables(const CattaneoToCarter& rolling, Index refinement)
    : rolling_(rolling),
      refinement_(refinement),
      traction_("traction", "from a Cattaneo shift to Carter's solution",
                {{"scheme", "1", "advection scheme"},
                 {"step_ratio", "1", "c = dq/dx"},
                 {"distance", "dx", "rolled"},
                 {"x", "mm", "position; the leading edge is at x = +half_width"},
                 {"bound", "N/mm^2", "traction bound g"},
                 {"traction", "N/mm^2", "tangential traction p"},
                 {"reference", "N/mm^2", "traction on a finer grid, interpolated"}}),
      reference_("reference", "the same on a finer grid, with c = 1 there",
                 {{"distance", "dx", "rolled, in elements of the coarser grid"},
                  {"x", "mm", "position"},
                  {"traction", "N/mm^2", "tangential traction p"}}),
      summary_("summary", "from a Cattaneo shift to Carter's solution, errors",
               {{"scheme", "1", "advection scheme"},
                {"step_ratio", "1", "c = dq/dx"},
                {"distance", "dx", "rolled"},
                {"error", "1", "integral of |p - reference|, over the integral of |reference|"},
                {"largest_error", "N/mm^2", "of the traction at a node"},
                {"peak", "N/mm^2", "largest |p|"},
                {"reference_peak", "N/mm^2", "largest |p| of the reference"},
                {"flank_motion", "dx",
                 "where |p| falls to a third of the reference's peak towards the leading edge: by "
                 "how much it is ahead of the reference's"},
                {"total_variation", "N/mm^2", "sum of rises and falls"},
                {"turning_points", "1", "local extrema above 1e-6 of the peak bound"},
                {"from_unit_step", "N/mm^2", "largest difference to the direct scheme with c = 1"},
                {"from_unit_step_inside", "N/mm^2", "the same without the trailing node"},
                {"near_unit_step", "1", "part of the nodes within 1 % of the peak bound of it"}}) {}

const RolledTables::Yardstick& RolledTables::yardstick(double distance) {
  const auto known = yardsticks_.find(distance);
  if (known != yardsticks_.end()) return known->second;
  const TransientRolling fine = rolling_.refined(distance, refinement_);
  const VectorXd& traction = fine.state().traction;
  for (Index i = 0; i < traction.size(); ++i) reference_.add({distance, fine.x()[i], traction[i]});
  const double peak = traction.cwiseAbs().maxCoeff();
  const Yardstick made{.fine = interpolated(fine.x(), traction, rolling_.grid.nodes()),
                       .peak = peak,
                       .flank = flank_of(fine.x(), traction, peak / 3),
                       .unit = rolling_.rolled(Direct{}, 1, distance).state().traction};
  return yardsticks_.emplace(distance, made).first->second;
}

void RolledTables::add(const std::string& name, const AdvectionScheme& scheme, double step_ratio,
                       double distance) {
  const auto& [fine, exact_peak, exact_flank, unit] = yardstick(distance);
  const TransientRolling rolling = rolling_.rolled(scheme, step_ratio, distance);
  const VectorXd& x = rolling.x();
  const VectorXd& p = rolling.state().traction;
  for (Index i = 0; i < x.size(); ++i) {
    traction_.add({name, step_ratio, distance, x[i], rolling.bound()[i], p[i], fine[i]});
  }
  const VectorXd error = p - fine;
  const VectorXd from_unit = (p - unit).cwiseAbs();
  const double peak_bound = rolling_.bound.peak();
  const double relative_error = error.lpNorm<1>() / fine.lpNorm<1>();
  const double motion = (exact_flank - flank_of(x, p, exact_peak / 3)) / rolling_.grid.spacing();
  const auto turns = static_cast<double>(turning_points(p, 1e-6 * peak_bound));
  const double near = (from_unit.array() < 0.01 * peak_bound).cast<double>().mean();
  summary_.add({name, step_ratio, distance, relative_error, error.lpNorm<Eigen::Infinity>(),
                p.cwiseAbs().maxCoeff(), exact_peak, motion, total_variation(p), turns,
                from_unit.maxCoeff(), from_unit.tail(x.size() - 1).maxCoeff(), near});
}

}  // namespace microslip::experiments
