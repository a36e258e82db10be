// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/calibrated_rolling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/work.hpp"
#include "strain_system.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

bool is_plane(const Kernel& kernel) { return std::holds_alternative<PlaneKernel>(kernel); }

/// From so many elements on, sums over them are interpolated.
constexpr Index many_elements = 256;

/// A coarse lattice tells where to look for b, which pays early for strips: each b has a system of
/// its own there.
constexpr Index coarse_elements = 31;

/// So close to the stick-slip point, in elements, line loads are no picture of the elements.
constexpr double near_loads = 1.5;

/// Positions of n nodes, from their centre  [elements]
VectorXd places(Index n) {
  const double last = static_cast<double>(n - 1) / 2;
  return VectorXd::LinSpaced(n, -last, last);
}

/// \param system  of plane strain
EdgeCalibration calibration_by(StrainSystem& system, double compliance, const Basis& basis,
                               Index n) {
  // With sqrt(r^2 - x^2) the strain is x, and the force pi r^2/2.
  const VectorXd coefficients = compliance * system.solve(1, middles_of(n)).elements;
  const double force = basis.weights(1, n).dot(coefficients);
  const double radius = std::sqrt(2 * force / std::numbers::pi);
  const VectorXd exact = (radius * radius - places(n).array().square()).sqrt();
  return {.offset = radius - static_cast<double>(n - 1) / 2,
          .values = exact.cwiseQuotient(coefficients)};
}

}  // namespace

EdgeCalibration edge_calibration(const Basis& basis, Index elements, const Solver& solver) {
  constexpr Material unit{.shear_modulus = 2, .poisson_ratio = 0};
  StrainSystem system(PlaneKernel(unit, 1), basis, elements, solver);
  return calibration_by(system, compliance(unit), basis, elements);
}

CalibratedRolling::CalibratedRolling(const Kernel& kernel, const TractionBound& bound,
                                     const Basis& basis, Index elements, const Solver& solver)
    : kernel_(kernel),
      bound_(bound),
      basis_(basis),
      elements_(elements),
      sliding_(kernel, bound),
      solver_(solver),
      system_(std::make_unique<StrainSystem>(kernel, basis, elements, solver)) {
  require(elements >= 2, "grid.elements", static_cast<double>(elements),
          "at least 2 for calibrated edges");
  calibration_ = is_plane(kernel)
                     ? calibration_by(*system_, compliance(material_of(kernel)), basis, elements)
                     : edge_calibration(basis, elements, solver);
}

CalibratedRolling::~CalibratedRolling() = default;
CalibratedRolling::CalibratedRolling(CalibratedRolling&&) noexcept = default;
CalibratedRolling& CalibratedRolling::operator=(CalibratedRolling&&) noexcept = default;

namespace {

/// What is left of values at the middles when their mean and slope are taken away.
VectorXd bent_part(const VectorXd& values) {
  const VectorXd x = middles_of(values.size() - 1);
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

const StickLattice& CalibratedRolling::lattice(double stick_edge) {
  if (!lattice_ || lattice_->stick_edge != stick_edge) lattice_ = make_lattice(stick_edge);
  return *lattice_;
}

StickLattice CalibratedRolling::make_lattice(double stick_edge) {
  const Index n = elements_;
  const double a = half_width_of(bound_);
  const double h = (a - stick_edge) / (static_cast<double>(n - 1) + 2 * calibration_.offset);
  const double centre = (a + stick_edge) / 2;
  const TractionBound known = stretched(bound_, (a - stick_edge) / 2);
  const FullSliding known_field(kernel_, known);
  const VectorXd at = h * middles_of(n);
  const VectorXd known_strain = known_field.strain(at);
  VectorXd strain = sliding_.strain(centre + at.array());
  const double part = similarity(strain, known_strain);
  const auto [elements, creepage, residual] = system_->solve(h, strain - part * known_strain);
  const VectorXd loads = basis_.weights(h, n).cwiseProduct(elements);
  return {.stick_edge = stick_edge,
          .spacing = h,
          .x = centre + h * places(n).array(),
          .elements = elements,
          .values = elements.cwiseProduct(calibration_.values),
          .loads = loads,
          .part = part,
          .stretched = known,
          .field = known_field,
          .force = loads.sum() + part * known_field.force(),
          .creepage = creepage,
          .residual = residual};
}

double CalibratedRolling::condition() const { return system_->condition(); }

CreepageForce CalibratedRolling::at(double stick_edge) {
  const StickLattice& found = lattice(stick_edge);
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
  if (elements_ < (is_plane(kernel_) ? 16 : 2) * coarse_elements) return meet_load(curve(), load);
  CalibratedRolling coarse(kernel_, bound_, basis_, coarse_elements, solver_);
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
  residual_ = lattice_->residual;
  condition_ = rolling.condition();
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
  interpolate_loads();
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

/// By the elements as line loads, at a place behind them.
double CalibratedSolution::strain_of_loads(double x) const {
  count_work(kernel_work * static_cast<double>(lattice_->x.size()));
  const auto sum = [&](const auto& kernel) {
    double strain = 0;
    for (Index j = 0; j < lattice_->x.size(); ++j) {
      strain -= lattice_->loads[j] * kernel.decay(lattice_->x[j] - x);
    }
    return strain;
  };
  return std::visit(sum, kernel_);
}

double CalibratedSolution::displacement_of_loads(double x) const {
  count_work(kernel_work * static_cast<double>(lattice_->x.size()));
  const auto sum = [&](const auto& kernel) {
    double displacement = 0;
    for (Index j = 0; j < lattice_->x.size(); ++j) {
      displacement += lattice_->loads[j] * kernel.displacement(lattice_->x[j] - x);
    }
    return displacement;
  };
  return std::visit(sum, kernel_);
}

/// Sums over many elements are interpolated: behind them they are analytic.
void CalibratedSolution::interpolate_loads() {
  const double a = half_width_of(bound_);
  const double nearest = lattice_->x[0] - behind_elements();
  if (lattice_->x.size() < many_elements || behind_elements() <= -a) return;
  const double origin = lattice_->x[0];
  strain_behind_.emplace([&](double distance) { return strain_of_loads(origin - distance); },
                         nearest, origin + a);
  nearest_displacement_ = displacement_of_loads(behind_elements());
}

double CalibratedSolution::removed_strain(double x) const {
  return lattice_->part * lattice_->field.strain(x - lattice_->centre()) +
         (strain_behind_ ? (*strain_behind_)(lattice_->x[0] - x) : strain_of_loads(x));
}

double CalibratedSolution::removed_displacement(double x) const {
  return lattice_->part * lattice_->field.displacement(x - lattice_->centre()) +
         (strain_behind_ ? nearest_displacement_ + strain_behind_->integral(lattice_->x[0] - x)
                         : displacement_of_loads(x));
}

/// From here on back, elements may be taken as line loads.
double CalibratedSolution::behind_elements() const {
  return stick_edge() - near_loads * lattice_->spacing;
}

/// Under a positive creepage. Next to the stick-slip point it grows as a square root.
double CalibratedSolution::slip_behind(double x) const {
  const double creepage = loaded_.state.creepage;
  if (!lattice_) return creepage - sliding_.strain(x);
  const double from = std::max(std::min(x, behind_elements()), -half_width_of(bound_));
  const double slip = creepage - loaded_.part * (sliding_.strain(from) - removed_strain(from));
  return slip * std::sqrt((stick_edge() - x) / (stick_edge() - from));
}

double CalibratedSolution::slip(double x) const {
  return sticks(x) ? 0 : loaded_.direction * slip_behind(x);
}

double CalibratedSolution::displacement(double x) const {
  if (!lattice_) return -loaded_.direction * sliding_.displacement(x);
  const double u = x < behind_elements()
                       ? sliding_.displacement(x) - removed_displacement(x)
                       : anchor_displacement_ - lattice_->creepage * (x - anchor_);
  return -loaded_.direction * loaded_.part * u;
}

Evidence CalibratedSolution::evidence() const {
  const Index parts = lattice_ ? lattice_->x.size() : 1;
  Evidence evidence = evidence_by_samples(
      bound_, [this](double x) { return traction(x); }, [this](double x) { return slip(x); },
      stick_edge(), parts, force(), creepage());
  evidence.residual = residual_;
  return evidence;
}

}  // namespace microslip
