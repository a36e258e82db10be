// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/under_relaxation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "microslip/experiments/claims.hpp"
#include "microslip/experiments/contact_tables.hpp"
#include "microslip/experiments/profile.hpp"
#include "microslip/support/format.hpp"
#include "rolled_tables.hpp"
#include "study_keys.hpp"
#include "table_values.hpp"

namespace microslip::experiments {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Parameters = UnderRelaxationParameters;

/// Rises and falls below this fraction of the peak bound count as flat.
constexpr double flat = 1e-9;

double turns(const VectorXd& traction, const HertzBound& bound) {
  return static_cast<double>(turning_points(traction, flat * bound.peak()));
}

struct Tables {
  Table wiggles{"wiggles",
                "local extrema against the step ratio, on a coarser grid",
                {{"scheme", "1", "direct or relaxed"},
                 {"step_ratio", "1", "c = dq/dx"},
                 {"steps", "1", "steps made"},
                 {"turning_points", "1", "local extrema of the traction"},
                 {"total_variation", "N/mm^2", "sum of rises and falls"}}};
  Table comparison{"comparison",
                   "relaxation of A' (7.4) and of the tractions (7.10), step by step",
                   {{"q", "dx", "distance rolled"},
                    {"same_partition", "1", "1 if it was the same in all steps up to here"},
                    {"differing_elements", "1", "elements in adhesion in one of them only"},
                    {"difference", "N/mm^2", "largest one of the tractions", 1e-12}}};
  Table parting{"parting",
                "where (7.4) and (7.10) first part",
                {{"q", "dx", "distance rolled"},
                 {"x", "mm", "position"},
                 {"bound", "N/mm^2", "traction bound g"},
                 {"relaxed", "N/mm^2", "traction of (7.4)"},
                 {"relaxed_traction", "N/mm^2", "traction of (7.10)"},
                 {"relaxed_region", "1", "A adhesion, S slip in (7.4)"},
                 {"relaxed_traction_region", "1", "the same in (7.10)"}}};
};

std::vector<double> one_step(const Grid& grid, double step_ratio) {
  return {step_ratio * grid.spacing()};
}

void add_wiggles(Tables& tables, const Parameters& p, const Progress& progress, std::size_t done,
                 std::size_t total) {
  CattaneoToCarter small = p.rolling;
  small.grid = Grid({.half_width = p.rolling.grid.half_width(), .elements = p.small_elements});
  const double distance = p.distances.front();
  const auto add = [&](const std::string& name, const AdvectionScheme& scheme, double c) {
    const VectorXd traction = small.rolled(scheme, c, distance).state().traction;
    const auto steps = static_cast<double>(
        number_of_steps(distance * small.grid.spacing(), one_step(small.grid, c)));
    tables.wiggles.add({name, c, steps, turns(traction, small.bound), total_variation(traction)});
    progress(++done, total);
  };
  for (const double c : p.relaxed_step_ratios) add("relaxed", Relaxed{p.relaxation}, c);
  for (const double c : p.direct_step_ratios) add("direct", Direct{}, c);
}

/// The largest difference before and after the first step at which the partitions differ.
struct Differences {
  double before = 0;
  double after = 0;
  double first = 0;  ///< distance rolled until that step, in elements
};

Differences compare(Tables& tables, const Parameters& p) {
  const auto contact = [&](const AdvectionScheme& scheme) {
    return TransientRolling(p.rolling.problem(scheme), CattaneoShift{p.rolling.force});
  };
  TransientRolling of_matrix = contact(Relaxed{p.relaxation});
  TransientRolling of_traction = contact(RelaxedTraction{p.relaxation});
  const double dx = p.rolling.grid.spacing();
  const double length = p.compared_step_ratio * dx;
  const std::size_t steps = number_of_steps(p.distances.front() * dx, {length});
  bool same = true;
  Differences differences;
  for (std::size_t k = 0; k < steps; ++k) {
    for (TransientRolling* rolling : {&of_matrix, &of_traction}) {
      rolling->step(length, PrescribedForce{p.rolling.force});
    }
    const TransientState& a = of_matrix.state();
    const TransientState& b = of_traction.state();
    double differing = 0;
    for (std::size_t i = 0; i < a.zones.size(); ++i) differing += a.zones[i] != b.zones[i];
    const double difference = (a.traction - b.traction).lpNorm<Eigen::Infinity>();
    const bool part_now = same && differing > 0;
    same = same && differing == 0;
    const double q = a.distance / dx;
    tables.comparison.add({q, same ? 1.0 : 0.0, differing, difference});
    double& largest = same ? differences.before : differences.after;
    largest = std::max(largest, difference);
    if (!part_now) continue;
    differences.first = q;
    for (Index i = 0; i < of_matrix.x().size(); ++i) {
      const auto zone = static_cast<std::size_t>(i);
      tables.parting.add({q, of_matrix.x()[i], of_matrix.bound()[i], a.traction[i], b.traction[i],
                          region(a.zones[zone]), region(b.zones[zone])});
    }
  }
  return differences;
}

/// Returns the largest factor, from one step to the next, of the difference between (7.4) and
/// (7.10). Steps count that have equal partitions after the first step with different ones.
double decay(const Table& comparison) {
  double slowest = 0;
  for (std::size_t i = 1; i < comparison.rows(); ++i) {
    const bool same = comparison.number(i - 1, "differing_elements") == 0 &&
                      comparison.number(i, "differing_elements") == 0;
    const double before = comparison.number(i - 1, "difference");
    const double now = comparison.number(i, "difference");
    if (same && now < before && now > 1e-8) slowest = std::max(slowest, now / before);
  }
  return slowest;
}

/// Compares the tractions of two step ratios: their difference over their size.
double spread(const CattaneoToCarter& rolling, const AdvectionScheme& scheme, double distance) {
  const VectorXd large = rolling.rolled(scheme, 0.8, distance).state().traction;
  const VectorXd small = rolling.rolled(scheme, 0.2, distance).state().traction;
  return (large - small).lpNorm<1>() / large.lpNorm<1>();
}

Table claims_of(const Tables& tables, const RolledTables& rolled, const Parameters& p,
                const Differences& differences) {
  const double relaxed_turns = tables.wiggles.latest({{"scheme", "relaxed"}}, "turning_points");
  const double direct_turns = tables.wiggles.latest({{"scheme", "direct"}}, "turning_points");
  const double expected = tables.wiggles.number(0, "turning_points");
  const double worst = most(tables.wiggles, "turning_points", {{"scheme", "relaxed"}});
  const std::vector<std::pair<std::string, Cell>> smallest = {{"scheme", "relaxed"},
                                                              {"distance", p.distances.back()}};
  const double near = rolled.summary().latest(smallest, "near_unit_step");
  const double largest = rolled.summary().latest(smallest, "largest_error");
  const double direct_spread = spread(p.rolling, Direct{}, p.distances.back());
  const double relaxed_spread = spread(p.rolling, Relaxed{p.relaxation}, p.distances.back());
  const double dependence = relaxed_spread / direct_spread;
  const double theta = p.compared_step_ratio / p.relaxation;
  const double factor = decay(tables.comparison);
  return claims_table(
      {{"in transients, too, small steps wiggle (direct scheme)", "5", not_given, direct_turns, "1",
        holds_if({above(expected + 4)}),
        fmt::format("local extrema at the smallest c; {} at the largest", format_short(expected)),
        "under_relaxation_traction"},
       {"with c* = 1 there are no artificial wiggles, however small the step", "7.1", expected,
        relaxed_turns, "1", holds_if({{"the largest number for any c", worst, equal_to(expected)}}),
        "local extrema at the smallest c", "under_relaxation_wiggles"},
       {"relaxation of A' (7.4) and of the tractions (7.10) are the same while the partitions are",
        "7.1", 0, differences.before, "N/mm^2", holds_if({within(1e-12, 0)}),
        "largest difference up to where they part", "under_relaxation_comparison"},
       {"relaxation of A' and of the tractions differ while the partitions differ", "7.1",
        not_given, differences.after, "N/mm^2", holds_if({above(1e-4)}),
        fmt::format("largest difference from {} dx on", format_short(differences.first)),
        "under_relaxation_comparison"},
       {"relaxation of A' and of the tractions agree whenever the partitions do", "7.1", 0, factor,
        "1", holds_if({equal_to(0)}, {within(0.01, 1 - theta)}),
        "part of a difference that is left after a step; 1 - c/c* = " + format_short(1 - theta),
        "under_relaxation_comparison"},
       {"c < c* stays near c = 1 in a big part of the domain, but not around sharp edges", "7.1",
        not_given, near, "1",
        holds_if({above(0.5), {"the largest error over the peak", largest, above(0.05)}}),
        fmt::format("part of the nodes within 1 % of the peak, at the smallest c; largest error {} "
                    "of the peak",
                    format_short(std::round(1000 * largest) / 1000)),
        "under_relaxation_traction"},
       {"relaxed solutions depend much less on c than direct ones", "7.1", not_given, dependence,
        "1", holds_if({below(0.5)}, {below(1)}),
        "difference of c = 0.8 and 0.2, over the same difference by the direct scheme",
        "under_relaxation_traction"}});
}

}  // namespace

UnderRelaxationParameters read_under_relaxation(Scene& scene) {
  using P = UnderRelaxationParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::relaxation, "step.relaxation"},
       {&P::step_ratios, "step.ratios", "c of the tractions shown; the first is c*",
        range_from(1e-6), "at most step.relaxation"},
       {&P::distances, "motion.elements_rolled", "distances, in elements", above_zero, rising},
       {&P::refinement, "reference.refinement", "elements of the reference for each one",
        range(2, 1000)},
       {&P::compared_step_ratio, "comparison.step_ratio",
        "c at which relaxation of A' and of the tractions are compared", range_from(1e-6),
        "at most step.relaxation"},
       {&P::small_elements, "wiggles.elements", "N of the grid on which wiggles are counted",
        range(1, Grid::max_elements)},
       {&P::relaxed_step_ratios, "wiggles.relaxed_step_ratios", "c there, of the relaxed scheme",
        range_from(1e-6), "at most step.relaxation"},
       {&P::direct_step_ratios, "wiggles.direct_step_ratios", "c there, of the direct scheme",
        range_from(1e-6), "at most step.relaxation"}});
  P p = keys.read({.rolling = read_cattaneo_to_carter(scene)});
  const auto demand = [&](const char* key, const std::vector<double>& ratios) {
    for (const double c : ratios) scene.demand(key, c, c <= p.relaxation);
  };
  demand("step.ratios", p.step_ratios);
  demand("comparison.step_ratio", {p.compared_step_ratio});
  demand("wiggles.relaxed_step_ratios", p.relaxed_step_ratios);
  demand("wiggles.direct_step_ratios", p.direct_step_ratios);
  return p;
}

std::vector<Table> under_relaxation(const UnderRelaxationParameters& p, const Progress& progress) {
  Tables tables;
  const std::size_t solutions = 2 * p.step_ratios.size() * p.distances.size();
  const std::size_t total = solutions + p.relaxed_step_ratios.size() + p.direct_step_ratios.size();
  const Differences differences = compare(tables, p);
  RolledTables rolled(p.rolling, p.refinement);
  const auto add = [&](const std::string& name, const AdvectionScheme& scheme) {
    for (const double c : p.step_ratios) {
      for (const double distance : p.distances) {
        rolled.add(name, scheme, c, distance);
        progress(rolled.summary().rows(), total);
      }
    }
  };
  add("relaxed", Relaxed{p.relaxation});
  add("direct", Direct{});
  add_wiggles(tables, p, progress, solutions, total);
  return {rolled.traction(),
          rolled.reference(),
          rolled.summary(),
          tables.wiggles,
          tables.comparison,
          tables.parting,
          claims_of(tables, rolled, p, differences)};
}

}  // namespace microslip::experiments
