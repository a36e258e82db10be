// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/fractional_power.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "fractional_power_cost.hpp"
#include "microslip/experiments/claims.hpp"
#include "microslip/experiments/profile.hpp"
#include "microslip/rolling/fractional_shift.hpp"
#include "microslip/support/convergence.hpp"
#include "microslip/support/format.hpp"
#include "rolled_tables.hpp"
#include "study_keys.hpp"
#include "table_values.hpp"

namespace microslip::experiments {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Parameters = FractionalPowerParameters;

struct Tables {
  Table shapes{"shapes",
               "(A^-1 A')^steps on tractions of several shapes, thesis Figs. 8.1 and 8.2",
               {{"shape", "1", "name of what it starts from"},
                {"steps", "1", "number of steps of c"},
                {"position", "dx", "from the leading edge's node"},
                {"traction", "1", "traction"}}};
  Table shapes_summary{"shapes_summary",
                       "values of the shapes after rolling; exact: between 0 and 1",
                       {{"shape", "1", "name of what it starts from"},
                        {"steps", "1", "number of steps of c"},
                        {"distance", "dx", "travelled"},
                        {"above", "1", "largest value above 1"},
                        {"below", "1", "largest value below 0"},
                        {"total_variation", "1", "sum of rises and falls"},
                        {"start_variation", "1", "sum of rises and falls of the start"}}};
};

/// Makes the shapes of Fig. 8.2: some fill a third of the contact next to the leading edge, one is
/// a single value there.
std::map<std::string, VectorXd> start_shapes(Index n) {
  const Index length = n / 5;
  const auto shape = [&](const auto& height) -> VectorXd {
    VectorXd values = VectorXd::Zero(n);
    for (Index i = 0; i < length; ++i) {
      values[n - 1 - length / 2 - i] =
          height(static_cast<double>(i) / static_cast<double>(length - 1));
    }
    return values;
  };
  return {{"pulse", VectorXd::Unit(n, n - 1)},
          {"plateau", shape([](double) { return 1.0; })},
          {"ramp_up", shape([](double s) { return 1 - s; })},
          {"ramp_down", shape([](double s) { return s; })},
          {"pyramid", shape([](double s) { return 1 - std::abs(2 * s - 1); })}};
}

FractionalShift shape_shift(const Parameters& p) {
  return {p.rolling.kernel, p.rolling.basis.shapes().front(), p.rolling.grid.spacing(),
          p.shape_elements};
}

void add_shape(Tables& tables, const Parameters& p, const std::string& name, const VectorXd& start,
               const VectorXd& moved, Index steps) {
  const Index n = start.size();
  for (Index i = 0; i < n; ++i) {
    tables.shapes.add(
        {name, static_cast<double>(steps), static_cast<double>(i - (n - 1)), moved[i]});
  }
  const double above = std::max(0.0, moved.maxCoeff() - 1);
  const double below = std::max(0.0, -moved.minCoeff());
  tables.shapes_summary.add({name, steps, p.step_ratio * static_cast<double>(steps), above, below,
                             total_variation(moved), total_variation(start)});
}

void add_shapes(Tables& tables, const Parameters& p) {
  const FractionalShift shift = shape_shift(p);
  for (const auto& [name, start] : start_shapes(p.shape_elements)) {
    add_shape(tables, p, name, start, start, 0);
    VectorXd moved = start;
    Index done = 0;
    for (const Index steps : p.steps) {
      for (; done < steps; ++done) moved = shift.move(moved, p.step_ratio).traction;
      add_shape(tables, p, name, start, moved, steps);
    }
  }
}

bool is_whole(double value) { return std::abs(value - std::round(value)) < 1e-9; }

RolledTables roll_all(const Parameters& p) {
  RolledTables rolled(p.rolling, p.refinement);
  for (const double distance : p.distances) {
    if (is_whole(distance)) {
      for (const double c : p.step_ratios) rolled.add("fractional", Fractional{}, c, distance);
    } else {
      rolled.add("fractional", Fractional{}, p.step_ratio, distance);
    }
    rolled.add("direct", Direct{}, p.step_ratio, distance);
  }
  return rolled;
}

/// Compares (A^-1 A')^n p with (A^-1 A*)^m p, n c = m, thesis (8.1), for the sharpest of the
/// shapes.
double whole_distance_error(const Parameters& p) {
  const FractionalShift shift = shape_shift(p);
  const VectorXd start = start_shapes(p.shape_elements).at("pulse");
  VectorXd moved = start;
  Index steps = 0;
  do {
    moved = shift.move(moved, p.step_ratio).traction;
    ++steps;
  } while (steps < 100 && !is_whole(static_cast<double>(steps) * p.step_ratio));
  const double distance = std::round(static_cast<double>(steps) * p.step_ratio);
  return (moved - shift.move(start, distance).traction).lpNorm<Eigen::Infinity>();
}

std::vector<double> column_of(const Table& table, const std::string& name) {
  std::vector<double> values;
  for (std::size_t i = 0; i < table.rows(); ++i) values.push_back(table.number(i, name));
  return values;
}

Table claims_of(const Tables& tables, const RolledTables& rolled, const CostTables& costs,
                const Parameters& p) {
  const double whole_error = whole_distance_error(p);
  const auto middle = static_cast<double>(p.steps[p.steps.size() / 2]);
  const auto below_zero = [&](const std::string& shape) {
    return tables.shapes_summary.latest({{"shape", shape}, {"steps", middle}}, "below");
  };
  const double pulse = below_zero("pulse");
  const double pyramid = below_zero("pyramid");
  double spot = 0, trailing = 0;
  const Table& summary = rolled.summary();
  for (std::size_t i = 0; i < summary.rows(); ++i) {
    if (std::get<std::string>(summary.at(i, "scheme")) != "fractional") continue;
    if (!is_whole(summary.number(i, "distance"))) continue;
    spot = std::max(spot, summary.number(i, "from_unit_step_inside"));
    trailing = std::max(trailing, summary.number(i, "from_unit_step"));
  }
  const Cells odd{{"negative_eigenvalue", 0.0}}, even{{"negative_eigenvalue", 1.0}};
  const double worst_difference = most(costs.agreement, "difference", odd);
  const double odd_residual = most(costs.agreement, "schur_residual", odd);
  const double even_residual = most(costs.agreement, "schur_residual", even);
  const double part = p.distances.back();
  const auto at_end = [&](const std::string& scheme, const std::string& column) {
    return rolled.summary().latest({{"scheme", scheme}, {"distance", part}}, column);
  };
  const double fractional = at_end("fractional", "error");
  const double direct = at_end("direct", "error");
  const double extrema = at_end("fractional", "turning_points");
  std::vector<double> sizes = column_of(costs.cost, "elements");
  std::vector<double> work = column_of(costs.cost, "solves");
  for (std::size_t i = 0; i < work.size(); ++i) work[i] = 1 / (work[i] * sizes[i]);
  const double growth = fitted_order(sizes, work);
  return claims_table(
      {{"(A^-1 A')^n = (A^-1 A*)^m where n c = m", "8", 0, whole_error, "1",
        holds_if({within(1e-9, 0)}), "largest error of a unit pulse after the least such n",
        no_figure},
       {"a single peak has huge wiggles", "8", not_given, pulse, "1", holds_if({above(0.05)}),
        fmt::format("largest value below zero after {} steps", format_short(middle)),
        "fractional_power_shapes"},
       {"a relatively smooth traction prevents wiggles", "8", not_given, pyramid, "1",
        holds_if(
            {below(0.02), {"its ratio to the one of the unit pulse", pyramid / pulse, below(0.2)}}),
        "largest value below zero of the pyramid after the same steps", "fractional_power_shapes"},
       {"solutions of all c are on spot with c = 1 after whole distances", "8", 0, spot, "N/mm^2",
        holds_if({within(1e-9, 0)}, {within(0.1, 0)}),
        fmt::format("largest difference without the trailing node; {} with it",
                    format_short(std::round(1000 * trailing) / 1000)),
        "fractional_power_traction"},
       {"sharp edges are kept that the direct scheme smooths", "8", not_given, fractional / direct,
        "1", holds_if({below(0.7)}),
        fmt::format("error after {} dx, over the error of the direct scheme", format_short(part)),
        "fractional_power_traction"},
       {"wiggles arise after parts of elements", "8", not_given, extrema, "1", holds_if({above(4)}),
        fmt::format("local extrema after {} dx; exact: 3", format_short(part)),
        "fractional_power_traction"},
       {"non-integer powers cost too much", "8", 3, growth, "1", holds_if({above(1.5)}),
        "exponent of work against N: solves of O(N) instead of a Schur method of O(N^3)",
        "fractional_power_cost"},
       {"the action on a vector agrees with a Schur method", "8", 0, worst_difference, "1",
        holds_if({within(1e-8, 0)}), "largest relative difference, N odd", no_figure},
       {"the power is the thesis's (8.4) for any N", "8", 0, even_residual, "1",
        holds_if({within(1e-8, 0)}, {above(1e-3), {"that for N odd", odd_residual, below(1e-8)}}),
        "residual of a Schur method for N even, where the power is complex; N odd: " +
            text_above_rounding(odd_residual, agreement_rounding),
        "fractional_power_eigenvalues"}});
}

}  // namespace

FractionalPowerParameters read_fractional_power(Scene& scene) {
  using P = FractionalPowerParameters;
  using enum Key::Type;
  scene.declare(
      {{"grid.elements", whole, "1", "number N of nodes", range(3, Grid::max_elements), "odd"}});
  const StudyKeys<P> keys(
      scene,
      {{&P::step_ratios, "step.ratios", "c; the first is a whole number", range_from(1e-6)},
       {&P::distances, "motion.elements_rolled", "distances, in elements", above_zero},
       {&P::step_ratio, "step.ratio",
        "c of the shapes, of the tractions at the last distance and of the cost", inner_fraction},
       {&P::refinement, "reference.refinement", "elements of the reference for each one",
        range(2, 1000)},
       {&P::shape_elements, "shapes.elements", "N of the shapes that travel",
        range(51, Grid::max_elements), odd},
       {&P::steps, "shapes.steps", "steps after which they are shown", range(1, Grid::max_elements),
        rising},
       {&P::cost_sizes, "cost.sizes", "numbers N of nodes, for the cost",
        range(3, Grid::max_elements), odd},
       {&P::largest_schur, "cost.largest_schur", "N up to which the Schur method is tried",
        range(1, Grid::max_elements), "at least the third of cost.sizes"}});
  P p = keys.read({.rolling = read_cattaneo_to_carter(scene)});
  const Index elements = p.rolling.grid.size();
  scene.demand("grid.elements", static_cast<double>(elements), elements % 2 == 1);
  const auto tried =
      std::ranges::count_if(p.cost_sizes, [&](Index size) { return size <= p.largest_schur; });
  scene.demand("cost.largest_schur", static_cast<double>(p.largest_schur), tried >= 3);
  return p;
}

std::vector<Table> fractional_power(const FractionalPowerParameters& p, const Progress& progress) {
  Tables tables;
  add_shapes(tables, p);
  progress(1, 3);
  const RolledTables rolled = roll_all(p);
  progress(2, 3);
  const CostTables costs = measure_cost(p);
  progress(3, 3);
  return {tables.shapes,     tables.shapes_summary,
          rolled.traction(), rolled.reference(),
          rolled.summary(),  costs.eigenvalues,
          costs.agreement,   costs.cost,
          costs.timing,      claims_of(tables, rolled, costs, p)};
}

}  // namespace microslip::experiments
