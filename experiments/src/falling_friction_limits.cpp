// SPDX-License-Identifier: GPL-3.0-or-later
#include "falling_friction_limits.hpp"

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "microslip/halfspace/influence.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/linalg/spectra.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// -d(ratio)/dv of a law.
double slope_of(const FrictionLaw& law, double speed) {
  const double by = 1e-4 * speed;
  return (law(speed - by) - law(speed + by)) / (2 * by);
}

/// The slip that follows tractions of the zone that slips, while the other nodes stick.
MatrixXd response_of_slip(const MatrixXd& influence, const std::vector<Index>& slips,
                          const std::vector<Index>& sticks) {
  if (sticks.empty()) return influence(slips, slips);
  const MatrixXd stuck = influence(sticks, sticks), beside = influence(sticks, slips);
  return influence(slips, slips) -
         influence(slips, sticks) * LuFactors(stuck).solve_columns(beside);
}

}  // namespace

double limit_of_unique_steps(const SteadyProblem& problem, const SteadySolution& solution) {
  const SlipFriction& friction = *problem.friction;
  std::vector<Index> slips, sticks;
  for (Index i = 0; i < solution.x.size(); ++i) {
    const bool in_adhesion = solution.zones[static_cast<std::size_t>(i)] == Zone::adhesion;
    (in_adhesion ? sticks : slips).push_back(i);
  }
  if (slips.empty()) return 0;
  const MatrixXd influence = influence_matrix(problem.contact.kernel, constant_basis(),
                                              problem.grid.spacing(), solution.x.size());
  const VectorXd lengths = VectorXd::Constant(solution.x.size(), problem.grid.spacing());
  const VectorXd at_rest = std::get<Differences>(problem.method).mean_bounds
                               ? element_means(problem.contact.bound, solution.x, lengths)
                               : bound_at(problem.contact.bound, solution.x);
  VectorXd follows(static_cast<Index>(slips.size()));
  for (std::size_t k = 0; k < slips.size(); ++k) {
    const Index i = slips[k];
    const double speed = std::abs(solution.slip[i]) * friction.speed;
    const double slope = slope_of(friction.law, speed);
    const double lag = solution.bound[i] / at_rest[i] - friction.law(speed);
    follows[static_cast<Index>(k)] =
        at_rest[i] * (friction.remembers() ? speed * slope + lag : friction.speed * slope);
  }
  const MatrixXd followed = response_of_slip(influence, slips, sticks) * follows.asDiagonal();
  return eigenvalues(followed).cwiseAbs().maxCoeff();
}

/// Elements leave the contact until no pressure pulls. The cylinder's height is x^2/(2 R); its
/// factor follows from Hertz's bound, and the approach from the load.
TabulatedBound bound_by_elements(const Material& material, const Kernel& kernel,
                                 const HertzBound& bound, double spacing) {
  const double a = bound.half_width();
  auto each_side = static_cast<Index>(std::ceil(a / spacing)) + 2;
  const double curvature = bound.peak() / a * (1 - material.poisson_ratio) / material.shear_modulus;
  for (;; --each_side) {
    const Index n = 2 * each_side + 1;
    const VectorXd x = spacing * VectorXd::LinSpaced(n, -static_cast<double>(each_side),
                                                     static_cast<double>(each_side));
    MatrixXd system = MatrixXd::Zero(n + 1, n + 1);
    system.topLeftCorner(n, n) = influence_matrix(kernel, constant_basis(), spacing, n);
    system.col(n).head(n).setConstant(-1);
    system.row(n).head(n).setConstant(spacing);
    VectorXd right(n + 1);
    right.head(n) = -curvature * x.cwiseAbs2();
    right[n] = bound.total();
    const VectorXd found = LuFactors(system).solve(right);
    if (found.head(n).minCoeff() < 0) continue;
    const double edge = (static_cast<double>(each_side) + 0.5) * spacing;
    return {edge, x, found.head(n)};
  }
}

}  // namespace microslip::experiments
