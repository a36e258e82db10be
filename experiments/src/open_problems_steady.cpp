// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_problems_steady.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "campaign.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/support/convergence.hpp"

namespace microslip::experiments::open_problems_study {

namespace {

/// Lists the schemes that are compared, by their order.
std::vector<SteadyEntry> treatments() {
  std::vector<SteadyEntry> all;
  for (const SteadyEntry& entry : steady_schemes()) {
    if (entry.name != "chebyshev") all.push_back(entry);  // the reference
  }
  std::ranges::stable_sort(all, {}, &SteadyEntry::order);
  return all;
}

/// Stick ratio and alignment of one case. Multiples of irrational numbers spread the cases evenly.
struct Case {
  double stick_ratio;
  double leading_offset;   ///< in (0, 1]
  double trailing_offset;  ///< in [0, 1)
};

std::vector<Case> cases_of(const OpenProblemsParameters& p) {
  const auto fraction = [](int i, double irrational) { return std::fmod(i * irrational, 1.0); };
  std::vector<Case> cases;
  for (int i = 1; i <= p.cases; ++i) {
    const double place = fraction(i, std::sqrt(2.0));
    cases.push_back({(1 - place) * p.stick_ratios[0] + place * p.stick_ratios[1],
                     1 - fraction(i, std::sqrt(3.0)), fraction(i, std::sqrt(5.0))});
  }
  return cases;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

/// Errors of one treatment, by [size][case].
struct Series {
  std::vector<std::vector<double>> force;
  std::vector<std::vector<double>> traction;
};

Series series_of(const OpenProblemsParameters& p, const SteadyEntry& treatment, Table& table,
                 const std::function<void()>& done) {
  const PlaneKernel kernel(p.material, p.length);
  const ChebyshevRolling reference(kernel, p.bound);
  const double a = p.bound.half_width();
  Series series;
  for (const Eigen::Index n : p.sizes) {
    series.force.emplace_back();
    series.traction.emplace_back();
    for (const auto& [stick_ratio, leading, trailing] : cases_of(p)) {
      const Truth truth = truth_of(reference, a, stick_ratio);
      const SteadyProblem problem =
          solved_by(treatment, {.contact = {kernel, p.bound},
                                .grid = Grid({.half_width = a,
                                              .elements = n,
                                              .leading_offset = leading,
                                              .trailing_offset = trailing}),
                                .basis = basis_of(treatment),
                                .load = PrescribedCreepage{truth.creepage}});
      const Compared found = compared(problem, truth);
      series.force.back().push_back(found.force_error);
      series.traction.back().push_back(found.mean_error);
      table.add({std::string(treatment.name), n, stick_ratio, leading, trailing, found.force_error,
                 found.mean_error});
    }
    done();
  }
  return series;
}

/// The reduction of errors with each doubling of N: of the median, and the least of any case. Both
/// are empty where errors are rounding.
struct Reductions {
  double order;
  double least;
};

Reductions reductions_of(const std::vector<Eigen::Index>& sizes,
                         const std::vector<std::vector<double>>& errors) {
  std::vector<double> n;
  std::vector<double> medians;
  std::vector<double> factors;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    n.push_back(static_cast<double>(sizes[k]));
    medians.push_back(median(errors[k]));
    for (std::size_t i = 0; k > 0 && i < errors[k].size(); ++i) {
      factors.push_back(errors[k - 1][i] / errors[k][i]);
    }
  }
  if (std::ranges::max(medians) < inversion_rounding) return {not_given, not_given};
  return {fitted_order(n, medians), std::ranges::min(factors)};
}

Table steady_steps(const OpenProblemsParameters& p) {
  const PlaneKernel kernel(p.material, p.length);
  const double a = p.bound.half_width();
  const Truth truth = truth_of(ChebyshevRolling(kernel, p.bound), a, p.steady_stick_ratio);
  const Grid grid({.half_width = a, .elements = p.steady_elements});
  Table table("steady_steps", "steady rolling, error against the step ratio",
              {{"scheme", "1", "leading_edge: standard or inversion"},
               {"step_ratio", "1", "c = dq/dx"},
               {"force_error", "1", "|force / exact - 1|", inversion_rounding},
               {"mean_error", "1", "mean over the nodes of |p - exact|, over the peak of the bound",
                inversion_rounding}});
  for (const std::string name : {"standard", "inversion"}) {
    for (const double c : p.steady_ratios) {
      const Compared found = compared(solved_by(steady_scheme(name),
                                                {.contact = {kernel, p.bound},
                                                 .grid = grid,
                                                 .load = PrescribedCreepage{truth.creepage}},
                                                c),
                                      truth);
      table.add({name, c, found.force_error, found.mean_error});
    }
  }
  return table;
}

}  // namespace

SteadyTables steady_tables(const OpenProblemsParameters& p, const Progress& progress) {
  SteadyTables tables{
      .cases = {"cases",
                "steady rolling, every case",
                {{"scheme", "1",
                  "leading_edge: standard, trimmed, known_edge, calibrated or inversion"},
                 {"elements", "1", "number of nodes N"},
                 {"stick_ratio", "1", "a', length in adhesion over the length of the contact"},
                 {"leading_offset", "1", "from the last node to the leading edge, in elements"},
                 {"trailing_offset", "1", "from the trailing edge to the first node, in elements"},
                 {"force_error", "1", "|force / exact - 1|", inversion_rounding},
                 {"mean_error", "1", "mean over the nodes of |p - exact|, over the peak",
                  inversion_rounding}}},
      .errors =
          {"errors",
           "steady rolling, errors over all cases",
           {{"scheme", "1", "leading_edge: standard, trimmed, known_edge, calibrated or inversion"},
            {"elements", "1", "number of nodes N"},
            {"force_median", "1", "median of |force / exact - 1|", inversion_rounding},
            {"force_least", "1", "least of them", inversion_rounding},
            {"force_largest", "1", "largest of them", inversion_rounding},
            {"mean_median", "1", "median of the mean errors of the tractions", inversion_rounding},
            {"mean_largest", "1", "largest of them", inversion_rounding}}},
      .orders = {"orders",
                 "steady rolling, orders of convergence",
                 {{"scheme", "1",
                   "leading_edge: standard, trimmed, known_edge, calibrated or inversion"},
                  {"force_order", "1", "fitted to force_median"},
                  {"force_reduction", "1", "least factor of a doubling of N in any case"},
                  {"mean_order", "1", "fitted to mean_median"},
                  {"mean_reduction", "1", "least factor of a doubling of N in any case"}}},
      .steps = steady_steps(p)};
  std::size_t done = 0;
  const std::size_t total = treatments().size() * p.sizes.size();
  for (const SteadyEntry& treatment : treatments()) {
    const Series series = series_of(p, treatment, tables.cases, [&] { progress(++done, total); });
    const std::string name(treatment.name);
    for (std::size_t k = 0; k < p.sizes.size(); ++k) {
      tables.errors.add({name, p.sizes[k], median(series.force[k]),
                         std::ranges::min(series.force[k]), std::ranges::max(series.force[k]),
                         median(series.traction[k]), std::ranges::max(series.traction[k])});
    }
    const Reductions force = reductions_of(p.sizes, series.force);
    const Reductions traction = reductions_of(p.sizes, series.traction);
    tables.orders.add({name, force.order, force.least, traction.order, traction.least});
  }
  return tables;
}

CurveTables curve_tables(const OpenProblemsParameters& p) {
  constexpr Eigen::Index all_unknowns = 64;
  const double a = p.bound.half_width();
  CurveTables tables{
      .curve = {"curve",
                "creepage and force by Chebyshev collocation",
                {{"width", "half-widths", "strip width Dy; inf in plane strain"},
                 {"stick_ratio", "1", "length in adhesion over the length of the contact"},
                 {"creepage", "1", "relative rigid slip w"},
                 {"force", "N/mm", "F"},
                 {"force_ratio", "1", "F over full sliding"}}},
      .digits = {"digits",
                 "creepage and force by Chebyshev collocation, against 64 unknowns",
                 {{"width", "half-widths", "strip width Dy; inf in plane strain"},
                  {"unknowns", "1", "n"},
                  {"largest_error", "1", "of creepage and force, relative, over the curve",
                   chebyshev_rounding}}}};
  std::vector<std::pair<double, Kernel>> kernels;
  for (const double width : p.widths)
    kernels.emplace_back(width, StripKernel(p.material, width * a));
  kernels.emplace_back(HUGE_VAL, PlaneKernel(p.material, p.length));
  for (const auto& [width, kernel] : kernels) {
    const ChebyshevRolling reference(kernel, p.bound, all_unknowns);
    std::vector<CreepageForce> curve;
    for (int i = 0; i < p.curve_points; ++i) {
      const double stick_ratio = 1 - (i + 0.5) / p.curve_points;
      curve.push_back(reference.at(a * (1 - 2 * stick_ratio)));
      tables.curve.add({width, stick_ratio, curve.back().creepage, curve.back().force,
                        curve.back().force / p.bound.total()});
    }
    for (const Eigen::Index n : p.unknowns) {
      const ChebyshevRolling rolling(kernel, p.bound, n);
      double worst = 0;
      for (const CreepageForce& exact : curve) {
        const CreepageForce point = rolling.at(exact.stick_edge);
        worst = std::max({worst, std::abs(point.creepage / exact.creepage - 1),
                          std::abs(point.force / exact.force - 1)});
      }
      tables.digits.add({width, n, worst});
    }
  }
  return tables;
}

}  // namespace microslip::experiments::open_problems_study
