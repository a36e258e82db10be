// SPDX-License-Identifier: GPL-3.0-or-later
#include "fractional_power_cost.hpp"

#include <Eigen/Core>
#include <algorithm>

#include "least_time.hpp"
#include "microslip/experiments/claims.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/linalg/spectra.hpp"
#include "microslip/rolling/fractional_shift.hpp"
#include "microslip/thesis/schur_powers.hpp"

namespace microslip::experiments {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Parameters = FractionalPowerParameters;

class Sized {
 public:
  Sized(const Parameters& p, Index elements)
      : kernel_(p.rolling.kernel),
        basis_(p.rolling.basis),
        spacing_(2 * p.rolling.grid.half_width() / static_cast<double>(elements)),
        elements_(elements) {}

  FractionalShift shift() const { return {kernel_, basis_.shapes().front(), spacing_, elements_}; }

  MatrixXd difference(double step_ratio) const {
    return influence_difference_matrix(kernel_, basis_, spacing_, elements_, step_ratio);
  }

  /// Returns C for any number of elements.
  MatrixXd matrix() const {
    const MatrixXd a = influence_matrix(kernel_, basis_, spacing_, elements_);
    return MatrixXd::Identity(elements_, elements_) - LuFactors(a).solve_columns(difference(1));
  }

 private:
  Kernel kernel_;
  Basis basis_;
  double spacing_;
  Index elements_;
};

void add_eigenvalues(CostTables& tables, const Parameters& p, Index elements) {
  const Eigen::VectorXcd values = eigenvalues(Sized(p, elements).matrix());
  for (const auto& value : values) {
    tables.eigenvalues.add({elements, value.real(), value.imag(), is_negative(value) ? 1.0 : 0.0});
  }
}

void add_agreement(CostTables& tables, const Parameters& p, Index elements) {
  const MatrixXd matrix = Sized(p, elements).matrix();
  const Eigen::VectorXcd values = eigenvalues(matrix);
  const bool negative = std::any_of(values.begin(), values.end(), is_negative);
  SchurPowers powers(matrix);
  for (const double c : {p.step_ratio, 0.5, 0.05}) {
    const MatrixXd power = powers.power(c);
    double difference = not_given;
    if (!negative) {
      const VectorXd pulse = VectorXd::Unit(elements, elements - 1);
      const VectorXd moved = Sized(p, elements).shift().move(pulse, c).traction;
      difference =
          (power * pulse - moved).lpNorm<Eigen::Infinity>() / moved.lpNorm<Eigen::Infinity>();
    }
    tables.agreement.add(
        {elements, c, negative ? 1.0 : 0.0, powers.residual(power, c), difference});
  }
}

void add_cost(CostTables& tables, const Parameters& p, Index elements) {
  const Sized sized(p, elements);
  const FractionalShift shift = sized.shift();
  const VectorXd pulse = VectorXd::Unit(elements, elements - 1);
  const auto n = static_cast<double>(elements);
  tables.cost.add({n, shift.move(pulse, p.step_ratio).solves});
  const double setup = least_time([&] { return sized.shift(); });
  const double action = least_time([&] { return shift.move(pulse, p.step_ratio); });
  const MatrixXd difference = sized.difference(p.step_ratio);
  VectorXd product = VectorXd::Random(elements);
  const double dense = least_time([&] { product = (difference * product).eval(); });
  double schur = not_given;
  if (elements <= p.largest_schur) {
    const MatrixXd matrix = shift_matrix(shift);
    schur = least_time([&] { return SchurPowers(matrix).power(p.step_ratio); });
  }
  tables.timing.add({n, setup, action, dense, schur});
}

}  // namespace

CostTables measure_cost(const FractionalPowerParameters& p) {
  CostTables tables;
  const Index odd = std::min<Index>(p.shape_elements, 51);
  add_eigenvalues(tables, p, odd);
  add_eigenvalues(tables, p, odd - 1);
  add_agreement(tables, p, odd - 1);
  for (const Index elements : p.cost_sizes) {
    if (elements <= p.largest_schur) add_agreement(tables, p, elements);
    add_cost(tables, p, elements);
  }
  return tables;
}

}  // namespace microslip::experiments
