// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/wiggle_spectrum.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "microslip/halfspace/influence.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/require.hpp"

namespace microslip::experiments {

namespace {

/// M_11, M_21 and M_12, the entries on and next to the diagonal, in units of 2 (1 - nu) dx / G.
struct Diagonals {
  double main;
  double lower;
  double upper;
};

double unit_of(const Kernel& kernel, double spacing) {
  return compliance(material_of(kernel)) * spacing;
}

Diagonals diagonals(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                    double step_ratio) {
  const auto entry = [&](double offset) {
    return influence_difference(kernel, shape, spacing, offset, step_ratio) /
           unit_of(kernel, spacing);
  };
  return {entry(0), entry(1), entry(-1)};
}

Table matrix_table(const WiggleSpectrumParameters& parameters, const Progress& progress) {
  const auto& [kernel, shape, spacing, n, step_ratios, samples, widths] = parameters;
  Table table("matrix", "M = A - A' and its inverse, thesis Figs. 6.1 and 6.2",
              {{"step_ratio", "1", "c = dq/dx"},
               {"row", "1", "row, from 1"},
               {"column", "1", "column, from 1"},
               {"difference", "2(1-nu)dx/G", "entry of A - A'"},
               {"inverse", "G/(2(1-nu)dx)", "entry of its inverse"}});
  for (std::size_t k = 0; k < step_ratios.size(); ++k) {
    const Eigen::MatrixXd difference =
        influence_difference_toeplitz(kernel, shape, spacing, n, step_ratios[k]).dense() /
        unit_of(kernel, spacing);
    const Eigen::MatrixXd inverse = difference.partialPivLu().inverse();
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        table.add({step_ratios[k], static_cast<double>(i + 1), static_cast<double>(j + 1),
                   difference(i, j), inverse(i, j)});
      }
    }
    progress(k + 1, step_ratios.size());
  }
  return table;
}

Table diagonals_table(const WiggleSpectrumParameters& parameters) {
  Table table("diagonals", "entries of M = A - A' on and next to the diagonal, thesis Fig. 6.3",
              {{"step_ratio", "1", "c = dq/dx"},
               {"m11", "2(1-nu)dx/G", "on the diagonal"},
               {"m21", "2(1-nu)dx/G", "below it"},
               {"m12", "2(1-nu)dx/G", "above it; negative"},
               {"m11_scaled", "1", "|m11| over the largest of the three"},
               {"m21_scaled", "1", "|m21| over the largest of the three"},
               {"m12_scaled", "1", "|m12| over the largest of the three"}});
  for (Eigen::Index k = 1; k <= parameters.samples; ++k) {
    const double c = static_cast<double>(k) / static_cast<double>(parameters.samples);
    const auto [main, lower, upper] =
        diagonals(parameters.kernel, parameters.shape, parameters.spacing, c);
    const double largest = std::max({std::abs(main), std::abs(lower), std::abs(upper)});
    table.add({c, main, lower, upper, std::abs(main) / largest, std::abs(lower) / largest,
               std::abs(upper) / largest});
  }
  return table;
}

double width_over_spacing(const Kernel& kernel, double spacing) {
  return std::visit([&](const auto& k) { return 2 * k.clear_distance() / spacing; }, kernel);
}

Table crossing_table(const WiggleSpectrumParameters& parameters) {
  Table table("crossing", "the step ratio at which M11 = M21; the thesis: around 0.3939",
              {{"kernel", "1", "the scene's, or a strip for comparison"},
               {"width", "dx", "strip width Dy; inf for plane strain"},
               {"step_ratio", "1", "c = dq/dx of the crossing"},
               {"entry", "2(1-nu)dx/G", "M11 = M21 there"}});
  const auto add = [&](const std::string& name, const Kernel& kernel) {
    const double c = diagonal_crossing(kernel, parameters.shape, parameters.spacing);
    table.add({name, width_over_spacing(kernel, parameters.spacing), c,
               diagonals(kernel, parameters.shape, parameters.spacing, c).main});
  };
  add("scene", parameters.kernel);
  for (const double width : parameters.strip_widths) {
    add("strip", StripKernel(material_of(parameters.kernel), width * parameters.spacing));
  }
  return table;
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
  WiggleSpectrumParameters parameters{.kernel = read_kernel(scene, read_material(scene)),
                                      .shape = read_shape(scene),
                                      .spacing = scene.number("grid.spacing"),
                                      .elements = scene.whole("grid.elements"),
                                      .step_ratios = scene.numbers("step.ratios"),
                                      .samples = scene.whole("step.samples"),
                                      .strip_widths = scene.numbers("crossing.strip_widths")};
  require_positive("grid.spacing", parameters.spacing);
  require(parameters.elements >= 3 && parameters.elements <= 1000, "grid.elements",
          static_cast<double>(parameters.elements), "a whole number in [3, 1000]");
  for (const double c : parameters.step_ratios) require_positive("step.ratios", c);
  require(parameters.samples >= 1 && parameters.samples <= 100000, "step.samples",
          static_cast<double>(parameters.samples), "a whole number in [1, 100000]");
  for (const double width : parameters.strip_widths) {
    require_positive("crossing.strip_widths", width);
  }
  return parameters;
}

std::vector<Table> wiggle_spectrum(const WiggleSpectrumParameters& parameters,
                                   const Progress& progress) {
  return {matrix_table(parameters, progress), diagonals_table(parameters),
          crossing_table(parameters)};
}

}  // namespace microslip::experiments
