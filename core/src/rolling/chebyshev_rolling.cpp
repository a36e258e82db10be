// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/chebyshev_rolling.hpp"

#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/friction/sliding_field.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

constexpr Index most_unknowns = 64;

/// Coefficients have converged when the last two are this fraction of the largest.
constexpr double resolved = 1e-14;

/// Largest violations of the contact conditions due to rounding errors, relative to the load, also
/// for a bound with a double zero; and relative to full sliding.
constexpr double tolerated = 1e-9;
constexpr double rounding_of_force = 1e-13;

/// Largest truncation error of the coefficients for the stick zone of a load, relative to the load.
constexpr double wanted_digits = 1e-10;

double tail_of(const VectorXd& coefficients) {
  return coefficients.tail(std::min<Index>(2, coefficients.size())).cwiseAbs().maxCoeff() /
         coefficients.cwiseAbs().maxCoeff();
}

}  // namespace

ChebyshevSolution::ChebyshevSolution(const LoadedState& loaded, ChebyshevField sliding,
                                     const std::optional<Adhesion>& adhesion)
    : LoadedSolution(loaded), sliding_(std::move(sliding)) {
  if (!adhesion) return;
  adhesion_ = adhesion->field;
  residual_ = adhesion->residual;
  condition_ = adhesion->condition;
}

double ChebyshevSolution::traction(double x) const {
  const double stuck = adhesion_ ? adhesion_->traction()(x) : 0;
  return -loaded_.direction * loaded_.scale * (sliding_.traction()(x) - stuck);
}

double ChebyshevSolution::slip(double x) const {
  if (sticks(x)) return 0;
  const double stuck = adhesion_ ? adhesion_->strain(x) : 0;
  return loaded_.direction *
         (loaded_.state.creepage - loaded_.scale * (sliding_.strain(x) - stuck));
}

double ChebyshevSolution::displacement(double x) const {
  const double stuck = adhesion_ ? adhesion_->displacement(x) : 0;
  return -loaded_.direction * loaded_.scale * (sliding_.displacement(x) - stuck);
}

Eigen::VectorXd ChebyshevSolution::displacement(const Eigen::VectorXd& x) const {
  return x.unaryExpr([this](double xi) { return displacement(xi); });
}

Evidence ChebyshevSolution::evidence() const {
  constexpr Index parts = 40;
  Evidence evidence = evidence_by_samples(
      PolynomialBound(sliding_.traction()), [this](double x) { return traction(x); },
      [this](double x) { return slip(x); }, stick_edge(), sliding_.traction().end(), parts, force(),
      creepage());
  evidence.residual = residual_;
  return evidence;
}

ChebyshevRolling::ChebyshevRolling(const Kernel& kernel, const TractionBound& bound, Index unknowns)
    : kernel_(kernel),
      sliding_(sliding_field_of(kernel, bound)),
      unknowns_(unknowns),
      fixed_(true) {
  require(unknowns >= 1 && unknowns <= most_unknowns, "unknowns", static_cast<double>(unknowns),
          "1 to 64");
  tabulate();
}

ChebyshevRolling::ChebyshevRolling(const Kernel& kernel, const TractionBound& bound)
    : ChebyshevRolling(kernel, bound, 4) {
  fixed_ = false;
  // Large stick zones need most unknowns; but if everything sticks, the solution is the bound
  // itself.
  const double a = sliding_.traction().half_length();
  const auto tail = [&] {
    return std::max(tail_of(zone(-0.9 * a).coefficients), tail_of(zone(-0.3 * a).coefficients));
  };
  while (tail() > resolved) {
    if (unknowns_ == most_unknowns) {
      throw NotConverged(
          fmt::format("Chebyshev collocation: 64 unknowns do not suffice, because the "
                      "last coefficients are {} of the largest",
                      format_roughly(tail())),
          0, tail());
    }
    add_unknowns();
  }
}

void ChebyshevRolling::add_unknowns() {
  unknowns_ = std::min(most_unknowns, unknowns_ < 16 ? unknowns_ + 4 : unknowns_ + 8);
  tabulate();
}

/// Computes the matrices that do not depend on the stick zone.
void ChebyshevRolling::tabulate() {
  const Index n = unknowns_;
  const double step = pi / static_cast<double>(n + 1);
  const VectorXd whole = VectorXd::LinSpaced(n + 1, 0, static_cast<double>(n));
  const VectorXd angles = step * (whole.array() + 0.5);
  collocation_ = angles.array().cos();
  quadrature_ = (step * whole.tail(n)).array().cos();
  strains_.resize(n + 1, n + 1);
  strains_.col(n).setOnes();
  loads_.resize(n, n);
  for (Index k = 0; k < n; ++k) {
    const auto order = static_cast<double>(k + 1);
    strains_.col(k) = (order * angles.array()).cos();
    // At a point, a term has the value sin((k + 1) angle).
    for (Index j = 0; j < n; ++j) {
      const double angle = step * whole[j + 1];
      loads_(j, k) = step * std::sin(angle) * std::sin(order * angle);
    }
  }
}

ChebyshevRolling::Zone ChebyshevRolling::zone(double stick_edge) const {
  const Index n = unknowns_;
  const double compliance = kernel_.log_factor() * pi;
  const double end = sliding_.traction().end();
  const double centre = (stick_edge + end) / 2;
  const double half_length = (end - stick_edge) / 2;
  const VectorXd x = centre + half_length * collocation_.array();
  // The equations are divided by the compliance; the unknowns are the coefficients and creepage /
  // compliance.
  MatrixXd matrix = strains_;
  if (std::isfinite(kernel_.clear_distance())) {
    count_work(std::pow(n + 1, 2) * (kernel_work + 2 * static_cast<double>(n)));
    const auto decays = [&](const auto& kernel) -> MatrixXd {
      return MatrixXd::NullaryExpr(n + 1, n, [&](Index i, Index j) {
        return kernel.regular_decay(half_length * (collocation_[i] - quadrature_[j]));
      });
    };
    matrix.leftCols(n) += half_length / compliance * (visit_half_space(decays, kernel_) * loads_);
  }
  const VectorXd strain =
      x.unaryExpr([&](double xi) { return sliding_.continued_strain(xi) / compliance; });
  count_work(2.0 / 3 * std::pow(n + 1, 3));
  const LuFactors factors(matrix);
  const VectorXd unknowns = factors.solve(strain);
  const double residual = (strain - matrix * unknowns).norm() / strain.norm();
  return {unknowns.head(n), compliance * unknowns[n], residual, 1 / factors.rcond()};
}

CreepageForce ChebyshevRolling::at(double stick_edge) const {
  const Zone found = zone(stick_edge);
  const ChebyshevTraction stuck(stick_edge, sliding_.traction().end(), found.coefficients);
  return {stick_edge, found.creepage, stuck.force() - sliding_.traction().force()};
}

CreepageForceCurve ChebyshevRolling::curve() const {
  const double a = sliding_.traction().half_length();
  return {.at = [this](double b) { return at(b); },
          .half_width = a,
          .full_sliding_creepage = sliding_.strain(a),
          .full_sliding_force = sliding_.traction().force()};
}

ChebyshevSolution ChebyshevRolling::solve(const Load& load) const {
  const LoadedState loaded = meet_load(curve(), load);
  const double edge = loaded.state.stick_edge;
  const double a = sliding_.traction().half_length();
  const double full_sliding = std::abs(sliding_.traction().force());
  const double amplified =
      loaded.state.force == 0 ? 1 : full_sliding / std::abs(loaded.state.force / loaded.scale);
  std::optional<ChebyshevSolution::Adhesion> adhesion;
  if (edge < a) {
    const Zone found = zone(edge);
    const Index last_two = std::min<Index>(2, found.coefficients.size());
    const double truncated = pi * (a - edge) / 2 *
                             found.coefficients.tail(last_two).cwiseAbs().maxCoeff() /
                             full_sliding * amplified;
    if (!fixed_ && truncated > wanted_digits + amplified * rounding_of_force) {
      if (unknowns_ == most_unknowns) {
        throw NotConverged("Chebyshev collocation: 64 unknowns do not suffice for so small a load",
                           loaded.evaluations, truncated);
      }
      ChebyshevRolling finer(*this);
      finer.add_unknowns();
      return finer.solve(load);
    }
    adhesion = {ChebyshevField(kernel_, ChebyshevTraction(edge, a, found.coefficients)),
                found.residual, found.condition};
  }
  ChebyshevSolution solution(loaded, sliding_, adhesion);
  const double violation = solution.evidence().violation();
  if (violation > tolerated + amplified * rounding_of_force) {
    throw NotConverged("Chebyshev collocation: more than one stick zone", loaded.evaluations,
                       violation);
  }
  return solution;
}

}  // namespace microslip
