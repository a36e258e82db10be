// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/speed_accuracy.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "campaign.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "speed_accuracy_fronts.hpp"
#include "speed_accuracy_problems.hpp"
#include "study_keys.hpp"

namespace microslip::experiments {

using namespace speed_accuracy_study;

namespace {

using Eigen::Index;

Table runs_table(const std::vector<Run>& runs) {
  std::vector<Column> columns = contestant_columns();
  columns.push_back({"elements", "1", "N; unknowns of chebyshev; nodes shown of inversion"});
  columns.insert(
      columns.end(),
      {{"force_error", "1",
        "steady: largest over the loads, relative; creepage: root of the mean square over the "
        "steps, over the first"},
       {"creep_error", "1",
        "transient: cumulative creep after each step, root of the mean square, over the last"},
       {"noise_error", "1",
        "transient: deviation of the error of the creepages of the steps of the second half from "
        "its mean, over the mean creepage"},
       {"traction_error", "1", "integral of |p - exact| over the force; steady: largest"},
       {"peak_error", "1",
        "transient: height of the travelling peak over the exact one at the same nodes, less 1"},
       {"energy_error", "1", "cylinder: error of the energy balance over the energy turned over"},
       {"motion_error", "1", "cylinder: velocity over the second half of the way"},
       {"rounds", "1", "stick/slip partitions tried, systems solved, or steps of the cylinder"},
       {"work", "1", "counted floating-point operations for a solution"},
       {"status", "1", "ok, or why there is no result"}});
  Table table("runs", "error and counted work of every scheme, solver and size", columns);
  for (const Run& run : runs) {
    std::vector<Cell> row = contestant_cells(run.contestant);
    row.emplace_back(static_cast<double>(run.elements));
    for (const double error : run.judgement.errors.values) row.emplace_back(error);
    row.insert(row.end(),
               {run.status == "ok" ? run.judgement.rounds : not_given, run.work, run.status});
    table.add(row);
  }
  return table;
}

Table times_table(const std::vector<Run>& runs) {
  std::vector<Column> columns = contestant_columns();
  columns.push_back({"elements", "1", "N; unknowns of chebyshev; nodes shown of inversion"});
  for (const char* quantity : quantity_names) {
    columns.push_back({fmt::format("{}_error", quantity), "1", "as in runs"});
  }
  columns.insert(columns.end(),
                 {{"work", "1", "counted operations"},
                  {"time", "s", "of the processor, for a solution, least of the repeats"},
                  {"rate", "ns", "time for an operation"}});
  Table table("runs_timing", "measured time of every run that succeeded", columns);
  for (const Run& run : runs) {
    if (run.status != "ok") continue;
    std::vector<Cell> row = contestant_cells(run.contestant);
    row.emplace_back(static_cast<double>(run.elements));
    for (const double error : run.judgement.errors.values) row.emplace_back(error);
    row.insert(row.end(), {run.work, run.time, 1e9 * run.time / run.work});
    table.add(row);
  }
  return table;
}

/// Returns the least work, among the accepted runs in plane strain, for an error of the force of
/// 1e-3.
template <class Accept>
double work_for_force(const std::vector<Run>& runs, const Accept& accept) {
  double least = not_given;
  for (const Run& run : runs) {
    const bool enough = run.status == "ok" && run.contestant.problem == "plane" &&
                        run.judgement.errors.values.front() <= 1e-3;
    if (enough && accept(run.contestant)) least = std::fmin(least, run.work);
  }
  return least;
}

Table claims_of(const std::vector<Run>& runs) {
  const auto with_edge = [&](const std::string& edge) {
    return work_for_force(runs, [&](const Contestant& c) { return c.edge == edge; });
  };
  const double standard = with_edge("standard");
  const double gain = standard / std::fmin(with_edge("aligned"), with_edge("calibrated"));
  const double known = standard / with_edge("known_edge");
  return claims_table(
      {{"a better leading edge will decrease the cost of a given accuracy drastically", "11",
        not_given, gain, "1", holds_if({above(100)}),
        "counted work for 1e-3 of the force in plane strain: standard, any basis and step ratio, "
        "over the best by elements",
        "speed_accuracy_force_time"},
       {"the cost decreases drastically if the displacement at the edge is known", "10.3",
        not_given, known, "1", holds_if({above(10)}), "the same, over leading_edge known_edge",
        "speed_accuracy_force_time"}});
}

}  // namespace

SpeedAccuracyParameters read_speed_accuracy(Scene& scene) {
  using P = SpeedAccuracyParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::length, "kernel.length"},
       {&P::width, "kernel.width"},
       {&P::sizes, "grid.sizes", "numbers N of nodes", range(1, 200000),
        Demand(
            "odd multiples of three, in rising order",
            [](double n) { return std::fmod(n, 6) == 3; }, is_above)},
       {&P::repeats, "timing.repeats", "s", "runs are repeated until they took so long together",
        above_zero},
       {&P::steady_operations, "steady.operations",
        "of a solution; runs that are expected to take more are only listed", above_zero},
       {&P::stick_ratios, "steady.stick_ratios",
        "a' of steady rolling, of whose errors the largest counts", range_above(0, 0.99)},
       {&P::step_ratios, "steady.step_ratios", "c of steady rolling; the first of them for strips",
        range_above(0, 4)},
       {&P::unknowns, "steady.unknowns", "of the Chebyshev collocation", range(1, 64)},
       {&P::transient_operations, "transient.operations", "as steady.operations", above_zero},
       {&P::force, "transient.force_ratio", "force over full sliding", range_above(0, 0.99)},
       {&P::transient_ratios, "transient.step_ratios", "c of the transient", range_above(0, 4)},
       {&P::transient_reference, "transient.reference", "N of the run that is taken as exact",
        range(1, Grid::max_elements)},
       {&P::cylinder_operations, "cylinder.operations", "as steady.operations", above_zero},
       {in(&P::cylinder, &Cylinder::mass), "cylinder.mass"},
       {in(&P::cylinder, &Cylinder::inertia), "cylinder.inertia"},
       {in(&P::cylinder, &Cylinder::radius), "cylinder.radius"},
       {in(&P::cylinder, &Cylinder::slope_force), "cylinder.slope_force"},
       {&P::cylinder_length, "cylinder.length", "mm", "L0, which sets the stiffness of the contact",
        above_zero},
       {&P::distance, "cylinder.distance", "mm", "distance from rest", above_zero},
       {&P::cylinder_ratios, "cylinder.step_ratios", "c of the cylinder", range_above(0, 4)},
       {&P::cylinder_reference, "cylinder.reference", "N of the run that is taken as exact",
        range(1, Grid::max_elements)},
       {&P::hursts, "rough.hursts", "Hurst exponents of rough bounds", range_above(0, 1)},
       {&P::roughness, "rough.amplitude", "root of the mean square of the roughness over the bound",
        range(0, 10)},
       {&P::seed, "rough.seed", "of the profiles", range(0, 4294967295)},
       {&P::rough_rows, "rough.rows", "of the rough bounds", range(9, 1000001)},
       {&P::rough_load, "rough.force_ratio", "force over full sliding", range_above(0, 0.99)},
       {&P::rough_sizes, "rough.sizes", "numbers N of elements", range(11, Grid::max_elements)},
       {&P::rough_reference, "rough.reference", "N of the solution that is taken as exact",
        range(11, Grid::max_elements)}});
  const Material material = read_material(scene);
  const PolynomialBound bound = read_polynomial_bound(scene);
  const HertzBound hertz = hertz_like(bound);
  P p = keys.read({.bound = bound, .material = material, .hertz = hertz});
  p.force *= full_sliding_force(hertz);
  return p;
}

std::vector<Table> speed_accuracy(const SpeedAccuracyParameters& p, const Progress& progress) {
  std::vector<RunSeries> all;
  for (const auto& contest :
       {steady_contest(p), transient_contest(p), creepage_contest(p), cylinder_contest(p)}) {
    all.insert(all.end(), contest.begin(), contest.end());
  }
  std::vector<Run> runs;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::vector<Run> more = runs_of(all[k], p.repeats);
    runs.insert(runs.end(), more.begin(), more.end());
    progress(k + 1, all.size());
  }
  const Cost work{"work", "1", "counted operations for a solution", &Run::work};
  const Cost time{"time", "s", "of the processor, for a solution", &Run::time};
  return {runs_table(runs),
          fronts_table("fronts", work, runs),
          cheapest_table("cheapest", work, runs),
          rough_table(p),
          times_table(runs),
          fronts_table("fronts_timing", time, runs),
          cheapest_table("cheapest_timing", time, runs),
          claims_of(runs)};
}

}  // namespace microslip::experiments
