// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/calibrated_rolling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Strips have a system of their own for each b; a coarse lattice tells where to look.
constexpr Index coarse_elements = 31;

/// So close to the stick-slip point, in elements, line loads are no picture of the elements.
constexpr double near_loads = 1.5;

/// The strain over the compliance, averaged from node i - 1 to node i, for i = 0 ... n, with nodes
/// -1 and n outside the elements; and, last, the creepage over the compliance.
MatrixXd strain_system(const Kernel& kernel, const Basis& basis, double spacing, Index n) {
  std::vector<Toeplitz> strains;
  for (const ShapeFunction& shape : basis.shapes()) {
    strains.push_back(influence_difference_toeplitz(kernel, shape, spacing, n + 1, 1));
  }
  const double scale = spacing * compliance(material_of(kernel));
  MatrixXd system(n + 1, n + 1);
  for (Index j = 0; j < n; ++j) {
    const Toeplitz& strain = strains[basis.shape_of(j, n)];
    for (Index i = 0; i <= n; ++i) system(i, j) = strain(i, j + 1) / scale;
  }
  system.rightCols(1).setOnes();
  return system;
}

MatrixXd plane_system(const Basis& basis, Index n) {
  return strain_system(PlaneKernel({.shear_modulus = 1, .poisson_ratio = 0}, 1), basis, 1, n);
}

/// Positions of the equations, from the centre of n nodes  [elements]
VectorXd middles(Index n) {
  const double last = static_cast<double>(n) / 2;
  return VectorXd::LinSpaced(n + 1, -last, last);
}

/// Positions of the nodes, likewise.
VectorXd places(Index n) {
  const double last = static_cast<double>(n - 1) / 2;
  return VectorXd::LinSpaced(n, -last, last);
}

EdgeCalibration calibration_by(const Eigen::PartialPivLU<MatrixXd>& factors, const Basis& basis,
                               Index n) {
  // With sqrt(r^2 - x^2) the strain is x, and the force pi r^2/2.
  const VectorXd coefficients = factors.solve(middles(n)).head(n);
  const double force = basis.weights(1, n).dot(coefficients);
  const double radius = std::sqrt(2 * force / std::numbers::pi);
  const VectorXd exact = (radius * radius - places(n).array().square()).sqrt();
  return {.offset = radius - static_cast<double>(n - 1) / 2,
          .values = exact.cwiseQuotient(coefficients)};
}

}  // namespace

EdgeCalibration edge_calibration(const Basis& basis, Index elements) {
  return calibration_by(plane_system(basis, elements).partialPivLu(), basis, elements);
}

CalibratedRolling::CalibratedRolling(const Kernel& kernel, const TractionBound& bound,
                                     const Basis& basis, Index elements)
    : kernel_(kernel),
      bound_(bound),
      basis_(basis),
      elements_(elements),
      sliding_(kernel, bound),
      plane_(std::holds_alternative<PlaneKernel>(kernel)) {
  require(elements >= 2, "grid.elements", static_cast<double>(elements),
          "at least 2 for calibrated edges");
  factors_ = plane_system(basis, elements).partialPivLu();
  calibration_ = calibration_by(factors_, basis, elements);
}

namespace {

/// What is left of values at the middles when their mean and slope are taken away.
VectorXd bent_part(const VectorXd& values) {
  const VectorXd x = middles(values.size() - 1);
  return values.array() - values.mean() - x.array() * (x.dot(values) / x.squaredNorm());
}

/// How much of the second is in the first, but for mean and slope.
double similarity(const VectorXd& first, const VectorXd& second) {
  const VectorXd bent = bent_part(second);
  const double size = bent.squaredNorm();
  const bool straight = size <= 1e-20 * second.squaredNorm();
  return straight ? 0 : bent.dot(bent_part(first)) / size;
}

}  // namespace

VectorXd CalibratedRolling::solve_system(double spacing, const VectorXd& strain) {
  if (plane_) return factors_.solve(strain);
  constexpr double nearby = 0.1;
  constexpr int most_refinements = 30;
  const MatrixXd system = strain_system(kernel_, basis_, spacing, elements_);
  const double enough = 1e-15 * strain.norm();
  if (std::abs(spacing / factored_spacing_ - 1) < nearby) {
    VectorXd unknowns = factors_.solve(strain);
    double before = HUGE_VAL;
    for (int i = 0; i < most_refinements; ++i) {
      const VectorXd residual = strain - system * unknowns;
      const double size = residual.norm();
      if (size <= enough || (size > before / 2 && before < 10 * enough)) return unknowns;
      if (size > before / 2) break;
      unknowns += factors_.solve(residual);
      before = size;
    }
  }
  factors_.compute(system);
  factored_spacing_ = spacing;
  return factors_.solve(strain);
}

StickLattice CalibratedRolling::lattice(double stick_edge) {
  const Index n = elements_;
  const double a = half_width_of(bound_);
  const double stiffness = 1 / compliance(material_of(kernel_));
  const double h = (a - stick_edge) / (static_cast<double>(n - 1) + 2 * calibration_.offset);
  const double centre = (a + stick_edge) / 2;
  const TractionBound known = stretched(bound_, (a - stick_edge) / 2);
  const FullSliding known_field(kernel_, known);
  const VectorXd at = h * middles(n);
  const VectorXd known_strain = at.unaryExpr([&](double x) { return known_field.strain(x); });
  VectorXd strain = at.unaryExpr([&](double x) { return sliding_.strain(centre + x); });
  const double part = similarity(strain, known_strain);
  strain = (strain - part * known_strain) * stiffness;
  const VectorXd unknowns = solve_system(h, strain);
  const VectorXd loads = basis_.weights(h, n).cwiseProduct(unknowns.head(n));
  return {.stick_edge = stick_edge,
          .spacing = h,
          .x = centre + h * places(n).array(),
          .elements = unknowns.head(n),
          .values = unknowns.head(n).cwiseProduct(calibration_.values),
          .loads = loads,
          .part = part,
          .stretched = known,
          .field = known_field,
          .force = loads.sum() + part * known_field.force(),
          .creepage = unknowns[n] / stiffness};
}

CreepageForce CalibratedRolling::at(double stick_edge) {
  const StickLattice found = lattice(stick_edge);
  return {stick_edge, found.creepage, found.force - sliding_.force()};
}

CreepageForceCurve CalibratedRolling::curve() {
  const double a = half_width_of(bound_);
  return {.at = [this](double b) { return at(b); },
          .half_width = a,
          .full_sliding_creepage = sliding_.strain(a),
          .full_sliding_force = sliding_.force()};
}

LoadedState CalibratedRolling::meet(const Load& load) {
  if (plane_ || elements_ < 2 * coarse_elements) return meet_load(curve(), load);
  CalibratedRolling coarse(kernel_, bound_, basis_, coarse_elements);
  const double near = coarse.meet(load).state.stick_edge;
  return meet_load(curve(), load, near, 0.005 * (half_width_of(bound_) - near));
}

CalibratedSolution CalibratedRolling::solve(const Load& load) { return {*this, meet(load)}; }

CalibratedSolution::CalibratedSolution(CalibratedRolling& rolling, const LoadedState& loaded)
    : LoadedSolution(loaded),
      kernel_(rolling.kernel()),
      bound_(rolling.bound()),
      sliding_(rolling.sliding()) {
  if (loaded.state.stick_edge >= half_width_of(bound_)) return;
  lattice_ = rolling.lattice(loaded.state.stick_edge);
  const Index n = lattice_->x.size();
  const Index middle = n / 2;
  anchor_ = lattice_->x[middle];
  double removed = lattice_->part * lattice_->field.displacement(anchor_ - lattice_->centre());
  for (Index j = 0; j < n; ++j) {
    const ShapeFunction& shape = rolling.basis().shapes()[rolling.basis().shape_of(j, n)];
    removed += lattice_->elements[j] *
               influence(kernel_, shape, lattice_->spacing, static_cast<double>(middle - j));
  }
  anchor_displacement_ = sliding_.displacement(anchor_) - removed;
}

/// The values at the nodes, without the square roots, are interpolated linearly.
double CalibratedSolution::removed(double x) const {
  const double a = half_width_of(bound_);
  if (!sticks(x) || x >= a) return 0;
  const auto roots = [&](double y) { return std::sqrt((y - stick_edge()) * (a - y)); };
  const Index last = lattice_->x.size() - 1;
  const double place =
      std::clamp((x - lattice_->x[0]) / lattice_->spacing, 0.0, static_cast<double>(last));
  const Index i = std::min(static_cast<Index>(place), last - 1);
  const double part = place - static_cast<double>(i);
  const auto smooth = [&](Index k) { return lattice_->values[k] / roots(lattice_->x[k]); };
  const double stretched =
      std::visit([&](const auto& g) { return g(x - lattice_->centre()); }, lattice_->stretched);
  return lattice_->part * stretched + roots(x) * ((1 - part) * smooth(i) + part * smooth(i + 1));
}

double CalibratedSolution::traction(double x) const {
  const double bound = std::visit([&](const auto& g) { return g(x); }, bound_);
  return -loaded_.direction * loaded_.part * (bound - removed(x));
}

double CalibratedSolution::removed_strain(double x) const {
  const auto sum = [&](const auto& kernel) {
    double strain = lattice_->part * lattice_->field.strain(x - lattice_->centre());
    for (Index j = 0; j < lattice_->x.size(); ++j) {
      strain -= lattice_->loads[j] * kernel.decay(lattice_->x[j] - x);
    }
    return strain;
  };
  return std::visit(sum, kernel_);
}

double CalibratedSolution::removed_displacement(double x) const {
  const auto sum = [&](const auto& kernel) {
    double displacement = lattice_->part * lattice_->field.displacement(x - lattice_->centre());
    for (Index j = 0; j < lattice_->x.size(); ++j) {
      displacement += lattice_->loads[j] * kernel.displacement(lattice_->x[j] - x);
    }
    return displacement;
  };
  return std::visit(sum, kernel_);
}

/// Under a positive creepage. Next to the stick-slip point it grows as a square root.
double CalibratedSolution::slip_behind(double x) const {
  const double creepage = loaded_.state.creepage;
  if (!lattice_) return creepage - sliding_.strain(x);
  const double behind = stick_edge() - near_loads * lattice_->spacing;
  const double from = std::max(std::min(x, behind), -half_width_of(bound_));
  const double slip = creepage - sliding_.strain(from) + removed_strain(from);
  return slip * std::sqrt((stick_edge() - x) / (stick_edge() - from));
}

double CalibratedSolution::slip(double x) const {
  return sticks(x) ? 0 : loaded_.direction * slip_behind(x);
}

double CalibratedSolution::displacement(double x) const {
  if (!lattice_) return -loaded_.direction * sliding_.displacement(x);
  const double behind = stick_edge() - near_loads * lattice_->spacing;
  const double u = x < behind ? sliding_.displacement(x) - removed_displacement(x)
                              : anchor_displacement_ - lattice_->creepage * (x - anchor_);
  return -loaded_.direction * loaded_.part * u;
}

double CalibratedSolution::violation() const {
  constexpr int samples = 200;
  const double a = half_width_of(bound_);
  const auto bound_at = [&](double x) {
    return std::visit([&](const auto& g) { return g(x); }, bound_);
  };
  double peak = 0;
  double worst_slip = 0;
  for (int i = 1; i < samples; ++i) {
    const double x = a * (2.0 * i / samples - 1);
    peak = std::max(peak, bound_at(x));
    if (!sticks(x)) worst_slip = std::max(worst_slip, -slip_behind(x));
  }
  double worst_traction = 0;
  for (Index j = 0; lattice_ && j < lattice_->x.size(); ++j) {
    const double x = lattice_->x[j];
    worst_traction = std::max({worst_traction, -removed(x), removed(x) - 2 * bound_at(x)});
  }
  const double creepage = loaded_.state.creepage;
  return std::max(worst_traction / peak, creepage > 0 ? worst_slip / creepage : worst_slip);
}

}  // namespace microslip
