// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/fourier_inverse.hpp"

#include <Eigen/Core>
#include <cmath>

#include "microslip/experiments/claims.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "microslip/thesis/fourier_inverse.hpp"
#include "study_keys.hpp"
#include "unit_difference.hpp"

namespace microslip::experiments {

namespace {

using Parameters = FourierInverseParameters;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

Toeplitz difference(const Parameters& p, const ShapeFunction& shape, Index n, double step_ratio) {
  return unit_difference(p.kernel, shape, p.spacing, n, step_ratio);
}

VectorXcd coefficients_of(const Toeplitz& b) {
  return fourier_coefficients(diagonal_first(middle_column(b)));
}

/// Solves for the first, middle and last column of the inverse.
MatrixXd exact_columns(const Toeplitz& b) {
  const Index n = b.size();
  MatrixXd units = MatrixXd::Zero(n, 3);
  units(0, 0) = units(middle_index(n), 1) = units(n - 1, 2) = 1;
  return LuFactors(b.dense()).solve_columns(units);
}

Table coefficients_table(const Parameters& p) {
  Table table("coefficients", "Fourier coefficients of B and their reciprocals, steps 3 and 4",
              {{"basis", "1", "traction functions"},
               {"step_ratio", "1", "c = dq/dx"},
               {"index", "1", "frequency, from 0; the highest is in the middle"},
               {"real", "2(1-nu)dx/G", "real part"},
               {"imaginary", "2(1-nu)dx/G", "imaginary part"},
               {"magnitude", "2(1-nu)dx/G", "absolute value"},
               {"reciprocal", "G/(2(1-nu)dx)", "absolute value of the reciprocal"}});
  for (const auto& [name, shape] : uniform_shapes(p.basis)) {
    for (const double c : p.step_ratios) {
      const VectorXcd found = coefficients_of(difference(p, shape, p.elements, c));
      const VectorXcd inverse = reciprocals(found);
      for (Index m = 0; m < found.size(); ++m) {
        table.add({name, c, m, found[m].real(), found[m].imag(), std::abs(found[m]),
                   std::abs(inverse[m])});
      }
    }
  }
  return table;
}

Table columns_table(const Parameters& p) {
  Table table("columns", "the middle column of the inverse of B, approximate (step 6) and exact",
              {{"basis", "1", "traction functions"},
               {"step_ratio", "1", "c = dq/dx"},
               {"row", "1", "row, from 1"},
               {"approximate", "G/(2(1-nu)dx)", "by Fourier transformation"},
               {"without_mean", "G/(2(1-nu)dx)", "the same with the zero frequency dropped"},
               {"exact", "G/(2(1-nu)dx)", "by factorisation"}});
  for (const auto& [name, shape] : uniform_shapes(p.basis)) {
    for (const double c : p.step_ratios) {
      const Toeplitz b = difference(p, shape, p.elements, c);
      const VectorXd approximate = approximate_inverse_column(b);
      const VectorXd dropped = approximate_inverse_column(b, ZeroFrequency::drop);
      const MatrixXd exact = exact_columns(b);
      for (Index i = 0; i < b.size(); ++i) {
        table.add({name, c, i + 1, approximate[i], dropped[i], exact(i, 1)});
      }
    }
  }
  return table;
}

/// Largest errors of the approximate inverse relative to the largest entry of the exact columns.
struct InverseErrors {
  double with_boundary;     ///< first, middle and last column
  double without_boundary;  ///< middle half of the middle column
  double without_mean;      ///< the same with the zero frequency dropped
};

InverseErrors inverse_errors(const Toeplitz& b) {
  const Index n = b.size();
  const MatrixXd exact = exact_columns(b);
  const Toeplitz approximate = toeplitz_from_middle_column(approximate_inverse_column(b));
  const auto error = [&](Index i, int k, Index column) {
    return std::abs(approximate(i, column) - exact(i, k));
  };
  const VectorXd dropped = approximate_inverse_column(b, ZeroFrequency::drop);
  InverseErrors errors{0, 0, 0};
  for (Index i = 0; i < n; ++i) {
    for (const auto& [k, column] :
         {std::pair(0, Index{0}), std::pair(1, middle_index(n)), std::pair(2, n - 1)}) {
      errors.with_boundary = std::max(errors.with_boundary, error(i, k, column));
    }
    if (i >= n / 4 && i < 3 * n / 4) {
      errors.without_boundary = std::max(errors.without_boundary, error(i, 1, middle_index(n)));
      errors.without_mean = std::max(errors.without_mean, std::abs(dropped[i] - exact(i, 1)));
    }
  }
  const double scale = exact.cwiseAbs().maxCoeff();
  return {errors.with_boundary / scale, errors.without_boundary / scale,
          errors.without_mean / scale};
}

Table errors_table(const Parameters& p, const Progress& progress) {
  Table table(
      "errors", "the approximate inverse against the exact one",
      {{"basis", "1", "traction functions"},
       {"step_ratio", "1", "c = dq/dx"},
       {"elements", "1", "size of B"},
       {"with_boundary", "1", "largest error in the first, middle and last column, relative"},
       {"without_boundary", "1", "the same in the middle half of the middle column"},
       {"without_mean", "1", "the last with the zero frequency dropped"}});
  const std::size_t total = uniform_shapes(p.basis).size() * p.step_ratios.size() * p.sizes.size();
  for (const auto& [name, shape] : uniform_shapes(p.basis)) {
    for (const double c : p.step_ratios) {
      for (const Index n : p.sizes) {
        const InverseErrors e = inverse_errors(difference(p, shape, n, c));
        table.add(
            {name, c, static_cast<double>(n), e.with_boundary, e.without_boundary, e.without_mean});
        progress(table.rows(), total);
      }
    }
  }
  return table;
}

/// Divides |coefficient| at the highest frequency by the largest |coefficient|.
double highest_over_largest(const Parameters& p, const ShapeFunction& shape, double step_ratio) {
  const VectorXd magnitudes =
      coefficients_of(difference(p, shape, p.elements, step_ratio)).cwiseAbs();
  return magnitudes[p.elements / 2] / magnitudes.maxCoeff();
}

Rule minor_error(const InverseErrors& errors) {
  return holds_if({below(0.1)},
                  {{"that with the zero frequency dropped", errors.without_mean, below(0.1)}});
}

Table claims_of(const Parameters& p) {
  const double large = p.step_ratios.front();
  const double small = p.step_ratios.back();
  const double kept = highest_over_largest(p, constant_shape(), large);
  const double lost = highest_over_largest(p, constant_shape(), small);
  const double lost_linear = highest_over_largest(p, linear_shape(), small);
  const InverseErrors errors = inverse_errors(difference(p, constant_shape(), p.elements, large));
  const InverseErrors small_errors =
      inverse_errors(difference(p, constant_shape(), p.elements, small));
  return claims_table(
      {{"for c near 1 all frequencies are important", "6.3", not_given, kept, "1",
        holds_if({above(0.3)}), "coefficient at the highest frequency over the largest; constant",
        "fourier_inverse_constant"},
       {"for c -> 0 the high frequencies become very unimportant", "6.3", not_given, lost, "1",
        holds_if({below(0.05)}),
        "coefficient at the highest frequency over the largest, at the smallest c; constant",
        "fourier_inverse_constant"},
       {"linear functions do not solve this, their coefficients are very similar", "6.3", not_given,
        lost_linear, "1", holds_if({below(0.1)}),
        "coefficient at the highest frequency over the largest, at the smallest c; linear",
        "fourier_inverse_linear"},
       {"the approximate inverse has minor errors that arise at the boundary", "6.3", not_given,
        errors.without_boundary, "1", minor_error(errors),
        "largest relative error away from the boundary at c near 1; with the zero frequency "
        "dropped, which adds a constant, " +
            format_short(errors.without_mean),
        "fourier_inverse_error"},
       {"the approximate inverse has minor errors for small c, too", "6.3", not_given,
        small_errors.without_boundary, "1", minor_error(small_errors),
        "largest relative error away from the boundary at the smallest c; with the zero frequency "
        "dropped " +
            format_short(small_errors.without_mean),
        "fourier_inverse_error"}});
}

}  // namespace

FourierInverseParameters read_fourier_inverse(Scene& scene) {
  using P = FourierInverseParameters;
  const StudyKeys<P> keys(
      scene, {{&P::spacing, "grid.spacing", "mm", "dx", above_zero},
              {&P::elements, "grid.elements", "size of the matrices shown", range(4, 10000)},
              {&P::step_ratios, "step.ratios", "c, the first large, the last small",
               range_from(min_step_ratio)},
              {&P::sizes, "grid.sizes", "sizes of the matrices whose errors are measured",
               range(4, 10000)}});
  scene.declare({{.name = "basis",
                  .type = Key::Type::word,
                  .meaning = "functions of the tables",
                  .words = {"both", "constant", "linear"},
                  .first_is_default = true}});
  const Kernel kernel = read_kernel(scene, read_material(scene));
  return keys.read({.kernel = kernel, .basis = scene.word("basis")});
}

std::vector<Table> fourier_inverse(const FourierInverseParameters& p, const Progress& progress) {
  return {coefficients_table(p), columns_table(p), errors_table(p, progress), claims_of(p)};
}

}  // namespace microslip::experiments
