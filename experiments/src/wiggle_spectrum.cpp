// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/wiggle_spectrum.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "microslip/experiments/claims.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/linalg/spectra.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "microslip/thesis/symbol.hpp"
#include "study_keys.hpp"
#include "unit_difference.hpp"

namespace microslip::experiments {

namespace {

using Parameters = WiggleSpectrumParameters;

/// The entries B_11, B_21 and B_12, on and next to the diagonal, in units of 2 (1 - nu) dx / G.
struct Diagonals {
  double main;
  double lower;
  double upper;
};

Diagonals diagonals(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                    double step_ratio) {
  const double unit = difference_unit(kernel, spacing);
  const auto entry = [&](double offset) {
    return influence_difference(kernel, shape, spacing, offset, step_ratio) / unit;
  };
  return {entry(0), entry(1), entry(-1)};
}

Eigen::MatrixXd difference(const Parameters& p, const ShapeFunction& shape, Eigen::Index n,
                           double step_ratio) {
  return unit_difference(p.kernel, shape, p.spacing, n, step_ratio).dense();
}

Table functions_table(const Parameters& p) {
  Table table("functions", "a function, the same shifted, and their difference, thesis Fig. 5.1",
              {{"basis", "1", "traction functions"},
               {"s", "dx", "distance from the node"},
               {"function", "1", "the function"},
               {"shifted", "1", "shifted to the right"},
               {"difference", "1", "function minus shifted"}});
  for (const auto& [name, shape] : uniform_shapes()) {
    for (int i = -300; i <= 300; ++i) {
      const double s = i / 200.0;
      const double shifted = shape.value(s - p.shift);
      table.add({name, s, shape.value(s), shifted, shape.value(s) - shifted});
    }
  }
  return table;
}

Table matrix_table(const Parameters& p) {
  Table table("matrix", "B = A - A' and its inverse, thesis Figs. 6.1, 6.2, 6.4 and 6.5",
              {{"basis", "1", "traction functions"},
               {"step_ratio", "1", "c = dq/dx"},
               {"row", "1", "row, from 1"},
               {"column", "1", "column, from 1"},
               {"difference", "2(1-nu)dx/G", "entry of A - A'"},
               {"inverse", "G/(2(1-nu)dx)", "entry of its inverse"}});
  for (const auto& [name, shape] : uniform_shapes()) {
    for (const double c : p.step_ratios) {
      const Eigen::MatrixXd b = difference(p, shape, p.elements, c);
      const Eigen::MatrixXd inverse = LuFactors(b).inverse();
      for (Eigen::Index i = 0; i < p.elements; ++i) {
        for (Eigen::Index j = 0; j < p.elements; ++j) {
          table.add({name, c, i + 1, j + 1, b(i, j), inverse(i, j)});
        }
      }
    }
  }
  return table;
}

Table diagonals_table(const Parameters& p) {
  Table table("diagonals", "entries of A - A' on and next to the diagonal, thesis Figs. 6.3, 6.6",
              {{"basis", "1", "traction functions"},
               {"step_ratio", "1", "c = dq/dx"},
               {"b11", "2(1-nu)dx/G", "on the diagonal"},
               {"b21", "2(1-nu)dx/G", "below it"},
               {"b12", "2(1-nu)dx/G", "above it; negative"},
               {"b11_scaled", "1", "|b11| over the largest of the three"},
               {"b21_scaled", "1", "|b21| over the largest of the three"},
               {"b12_scaled", "1", "|b12| over the largest of the three"}});
  for (const auto& [name, shape] : uniform_shapes()) {
    for (Eigen::Index k = 1; k <= p.samples; ++k) {
      const double c = static_cast<double>(k) / static_cast<double>(p.samples);
      const auto [main, lower, upper] = diagonals(p.kernel, shape, p.spacing, c);
      const double largest = std::max({std::abs(main), std::abs(lower), std::abs(upper)});
      table.add({name, c, main, lower, upper, std::abs(main) / largest, std::abs(lower) / largest,
                 std::abs(upper) / largest});
    }
  }
  return table;
}

Table crossing_table(const Parameters& p) {
  Table table("crossing", "the step ratio at which B11 = B21; the thesis: around 0.3939",
              {{"basis", "1", "traction functions"},
               {"kernel", "1", "the scene's, or a strip for comparison"},
               {"width", "dx", "strip width Dy; inf for plane strain"},
               {"step_ratio", "1", "c = dq/dx of the crossing"},
               {"entry", "2(1-nu)dx/G", "B11 = B21 there"}});
  for (const auto& [name, shape] : uniform_shapes()) {
    const auto add = [&, &name = name, &shape = shape](const std::string& kind,
                                                       const Kernel& kernel) {
      const double width = 2 * kernel.clear_distance() / p.spacing;
      const double c = diagonal_crossing(kernel, shape, p.spacing);
      table.add({name, kind, width, c, diagonals(kernel, shape, p.spacing, c).main});
    };
    add("scene", p.kernel);
    for (const double width : p.strip_widths) {
      add("strip", StripKernel(p.kernel.material(), width * p.spacing));
    }
  }
  return table;
}

/// Lists step ratios from 1 down to the smallest, in equal ratios.
std::vector<double> spectrum_steps(const Parameters& p) {
  std::vector<double> steps;
  for (int k = 0;; ++k) {
    const double c = std::pow(10.0, -static_cast<double>(k) / static_cast<double>(p.per_decade));
    if (c < p.smallest_step_ratio * (1 - 1e-12)) return steps;
    steps.push_back(c);
  }
}

/// Makes the tables spectrum and eigenvalues.
std::pair<Table, Table> spectrum_tables(const Parameters& p, const Progress& progress) {
  Table spectrum(
      "spectrum", "B = A - A' for falling step ratios",
      {{"basis", "1", "traction functions"},
       {"step_ratio", "1", "c = dq/dx"},
       {"condition", "1", "2-norm condition number, n elements"},
       {"condition_next", "1", "the same with n + 1 elements"},
       {"imaginary_to_real", "1", "sum of |Im| over sum of |Re| of the eigenvalues"},
       {"least_symbol", "2(1-nu)/G", "least |symbol| of B/(c dx) over all frequencies"}});
  Table values("eigenvalues", "eigenvalues of B/c = (A - A')/c, n elements",
               {{"basis", "1", "traction functions"},
                {"step_ratio", "1", "c = dq/dx"},
                {"real", "2(1-nu)dx/G", "real part, over c"},
                {"imaginary", "2(1-nu)dx/G", "imaginary part, over c"}});
  const std::vector<double> steps = spectrum_steps(p);
  for (const auto& [name, shape] : uniform_shapes()) {
    for (const double c : steps) {
      const Eigen::MatrixXd b = difference(p, shape, p.elements, c);
      const Eigen::VectorXcd found = eigenvalues(b);
      for (const std::complex<double>& value : found) {
        values.add({name, c, value.real() / c, value.imag() / c});
      }
      const double least = least_magnitude(Symbol::of_strain(p.kernel, shape, p.spacing, c)) /
                           compliance(p.kernel.material());
      spectrum.add({name, c, condition(b), condition(difference(p, shape, p.elements + 1, c)),
                    found.imag().cwiseAbs().sum() / found.real().cwiseAbs().sum(), least});
      progress(spectrum.rows(), 2 * steps.size());
    }
  }
  return {spectrum, values};
}

Table claims_of(const Parameters& p, const Table& spectrum) {
  const double crossing = diagonal_crossing(p.kernel, constant_shape(), p.spacing);
  const Diagonals at_one = diagonals(p.kernel, constant_shape(), p.spacing, 1);
  // The smallest step ratio of the constant functions.
  const std::size_t last = spectrum.rows() / 2 - 1;
  const auto growth = [&](const std::string& column) {
    return spectrum.number(last, column) / spectrum.number(0, column);
  };
  const bool odd = p.elements % 2 == 1;
  const double odd_growth = growth(odd ? "condition" : "condition_next");
  const double even_growth = growth(odd ? "condition_next" : "condition");
  const double linear_gain = spectrum.number(2 * last + 1, "least_symbol");
  return claims_table(
      {{"B11 = B21 around c = 0.3939", "6.1", 0.3939, crossing, "1",
        holds_if({within(0.01, 0.3939)}),
        "constant functions, the scene's kernel; 0.3939 is 39/99, the nearest of 100 samples",
        "wiggle_spectrum_diagonals"},
       {"at c = 1, B12 = -B11", "6.1", -1, at_one.upper / at_one.main, "1",
        holds_if({within(1e-12, -1)}), "B12 / B11", "wiggle_spectrum_diagonals"},
       {"at c = 1, B21 is less than half of B11", "6.1", not_given, at_one.lower / at_one.main, "1",
        holds_if({below(0.5)}), "B21 / B11 at c = 1", "wiggle_spectrum_diagonals"},
       {"upper diagonals of B are positive, lower ones negative", "6", not_given, at_one.upper,
        "2(1-nu)dx/G",
        holds_if({above(0), {"B21", at_one.lower, below(0)}},
                 {below(0), {"B21", at_one.lower, above(0)}}),
        "B12 at c = 1; B21 is " + format_short(std::round(1e4 * at_one.lower) / 1e4),
        "wiggle_spectrum_diagonals"},
       {"as c falls, imaginary parts of eigenvalues grow relative to real ones", "1", not_given,
        growth("imaginary_to_real"), "1", holds_if({above(10)}),
        "growth of their ratio from c = 1 to the smallest c", "wiggle_spectrum_spectrum"},
       {"as c falls, the condition number grows rapidly", "1", not_given, odd_growth, "1",
        holds_if({above(1000)}), "growth for an odd number of elements",
        "wiggle_spectrum_spectrum"},
       {"as c falls, the condition number grows rapidly for an even number of elements, too", "1",
        not_given, even_growth, "1",
        holds_if({above(1000)}, {{"that for an odd number", odd_growth, above(1000)}}),
        "growth for an even number of elements: B turns antisymmetric, singular for odd numbers "
        "only",
        "wiggle_spectrum_spectrum"},
       {"linear functions do not solve the problem", "6.2", not_given, linear_gain, "2(1-nu)/G",
        holds_if({below(0.01)}), "least |symbol| at the smallest c; 1 for the exact strain",
        "wiggle_spectrum_spectrum"}});
}

}  // namespace

double diagonal_crossing(const Kernel& kernel, const ShapeFunction& shape, double spacing) {
  const auto gap = [&](double c) {
    const Diagonals d = diagonals(kernel, shape, spacing, c);
    return d.main - d.lower;
  };
  std::uintmax_t iterations = 100;
  const auto [low, high] = boost::math::tools::toms748_solve(
      gap, 1e-3, 1.0, boost::math::tools::eps_tolerance<double>(), iterations);
  return (low + high) / 2;
}

WiggleSpectrumParameters read_wiggle_spectrum(Scene& scene) {
  using P = WiggleSpectrumParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::spacing, "grid.spacing", "mm", "dx", above_zero},
       {&P::elements, "grid.elements", "size of the matrices; of the spectra also one more",
        range(3, 1000)},
       {&P::step_ratios, "step.ratios", "c of the matrices shown", range_from(min_step_ratio)},
       {&P::shift, "functions.shift", "of the functions shown, in elements", inner_fraction},
       {&P::samples, "step.samples", "of the diagonals, c = 1/samples ... 1", range(1, 100000)},
       {&P::smallest_step_ratio, "spectrum.smallest_step_ratio", "c that spectra begin with",
        range_below(min_step_ratio, 1)},
       {&P::per_decade, "spectrum.per_decade", "spectra a decade of c", range(1, 100)},
       {&P::strip_widths, "crossing.strip_widths",
        "Dy/dx of strips whose crossing B11 = B21 is sought, too", above_zero}});
  return keys.read({.kernel = read_kernel(scene, read_material(scene))});
}

std::vector<Table> wiggle_spectrum(const WiggleSpectrumParameters& p, const Progress& progress) {
  const auto [spectrum, values] = spectrum_tables(p, progress);
  return {functions_table(p), matrix_table(p), diagonals_table(p),    crossing_table(p),
          spectrum,           values,          claims_of(p, spectrum)};
}

}  // namespace microslip::experiments
