// SPDX-License-Identifier: GPL-3.0-or-later
#include "strain_system.hpp"

#include <cmath>
#include <vector>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Factors of spacings that differ by more cost more iterations than new ones.
constexpr double nearby = 0.1;

constexpr int most_iterations = 40;

}  // namespace

VectorXd middles_of(Index n) {
  const double last = static_cast<double>(n) / 2;
  return VectorXd::LinSpaced(n + 1, -last, last);
}

StrainSystem::StrainSystem(const Kernel& kernel, const Basis& basis, Index elements,
                           const Solver& solver)
    : kernel_(kernel),
      basis_(basis),
      elements_(elements),
      solver_(solver),
      plane_(std::holds_alternative<PlaneKernel>(kernel)),
      gmres_(most_iterations) {}

/// Strain over compliance; all but the creepage are columns of Toeplitz matrices, which begin with
/// node -1.
void StrainSystem::assemble(double spacing) {
  const bool known = spacing_ > 0 && (plane_ || spacing == spacing_);
  if (known) return;
  spacing_ = spacing;
  const double unit = 1 / (spacing * compliance(material_of(kernel_)));
  const auto toeplitz_of = [&](const ShapeFunction& shape) {
    return influence_difference_toeplitz(kernel_, shape, spacing, elements_ + 1, 1).times(unit);
  };
  if (by_fft(solver_, basis_, elements_)) {
    matrix_ = toeplitz_of(basis_.shapes().front());
    return;
  }
  require_dense(elements_);
  std::vector<Toeplitz> strains;
  for (const ShapeFunction& shape : basis_.shapes()) strains.push_back(toeplitz_of(shape));
  MatrixXd bordered(elements_ + 1, elements_ + 1);
  for (Index j = 0; j < elements_; ++j) {
    const Toeplitz& strain = strains[basis_.shape_of(j, elements_)];
    for (Index i = 0; i <= elements_; ++i) bordered(i, j) = strain(i, j + 1);
  }
  bordered.rightCols(1).setOnes();
  matrix_ = bordered;
}

void StrainSystem::factorise() {
  factored_spacing_ = spacing_;
  if (const Toeplitz* toeplitz = matrix_->toeplitz()) {
    factors_ = ToeplitzInverse(*toeplitz);
    std::get<1>(factors_).apply(VectorXd::Ones(elements_ + 1), unit_strain_);
    return;
  }
  count_work(2.0 / 3 * std::pow(elements_ + 1, 3));
  factors_ = matrix_->entries()->partialPivLu();
}

/// Of the bordered system.
void StrainSystem::multiply(const VectorXd& unknowns, VectorXd& strain) const {
  if (matrix_->toeplitz() == nullptr) return matrix_->apply(unknowns, strain);
  padded_.resize(elements_ + 1);
  padded_ << 0, unknowns.head(elements_);
  matrix_->apply(padded_, strain);
  strain.array() += unknowns[elements_];
}

/// With the factors that there are. Node -1 has no element: that determines the creepage.
void StrainSystem::solve_nearby(const VectorXd& strain, VectorXd& unknowns) {
  if (const auto* factors = std::get_if<0>(&factors_)) {
    count_work(2 * static_cast<double>(strain.size() * strain.size()));
    unknowns = factors->solve(strain);
    return;
  }
  std::get<1>(factors_).apply(strain, padded_);
  const double creepage = padded_[0] / unit_strain_[0];
  unknowns.resize(elements_ + 1);
  unknowns.head(elements_) = padded_.tail(elements_) - creepage * unit_strain_.tail(elements_);
  unknowns[elements_] = creepage;
}

/// With the factors that there are, until 1e-5 of the tolerance is reached, or rounding.
/// \return the residual, over the strain
double StrainSystem::refine(const VectorXd& strain, VectorXd& unknowns) {
  const double size = strain.norm();
  const double enough = 1e-5 * solver_.tolerance * size;
  solve_nearby(strain, unknowns);
  for (double before = HUGE_VAL;;) {
    multiply(unknowns, product_);
    rest_ = strain - product_;
    const double rest = rest_.norm();
    if (rest <= enough || !(rest < before / 2)) return size > 0 ? rest / size : 0;
    gmres_.solve([this](const VectorXd& p, VectorXd& y) { multiply(p, y); },
                 [this](const VectorXd& p, VectorXd& y) { solve_nearby(p, y); }, rest_,
                 enough / rest, correction_);
    unknowns += correction_;
    before = rest;
  }
}

StrainSystem::Unknowns StrainSystem::solve(double spacing, const VectorXd& strain) {
  assemble(spacing);
  if (!(std::abs(spacing_ / factored_spacing_ - 1) <= nearby)) factorise();
  VectorXd unknowns;
  double residual = refine(strain, unknowns);
  if (!(residual <= solver_.tolerance) && spacing_ != factored_spacing_) {
    factorise();
    residual = refine(strain, unknowns);
  }
  if (!(residual <= solver_.tolerance)) {
    throw NotConverged("steady rolling: the residual of the equations in adhesion is above " +
                           format_short(solver_.tolerance),
                       0, residual);
  }
  const double stiffness = 1 / compliance(material_of(kernel_));
  return {.elements = unknowns.head(elements_) * stiffness,
          .creepage = unknowns[elements_],
          .residual = residual};
}

double StrainSystem::condition() const {
  const auto* factors = std::get_if<0>(&factors_);
  return factors != nullptr ? 1 / factors->rcond() : std::get<1>(factors_).condition();
}

}  // namespace microslip
