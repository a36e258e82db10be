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
  using enum Key::Type;
  static constexpr auto keys = std::to_array<Key>(
      {{"grid.sizes", wholes, "1", "numbers N of nodes", range(1, 200000),
        "odd multiples of three, in rising order"},
       {"timing.repeats", number, "s", "runs are repeated until they took so long together",
        above_zero},
       {"steady.operations", number, "1",
        "of a solution; runs that are expected to take more are only listed", above_zero},
       {"steady.stick_ratios", list, "1",
        "a' of steady rolling, of whose errors the largest counts", range_above(0, 0.99)},
       {"steady.step_ratios", list, "1", "c of steady rolling; the first of them for strips",
        range_above(0, 4)},
       {"steady.unknowns", wholes, "1", "of the Chebyshev collocation", range(1, 64)},
       {"transient.operations", number, "1", "as steady.operations", above_zero},
       {"transient.force_ratio", number, "1", "force over full sliding", range_above(0, 0.99)},
       {"transient.step_ratios", list, "1", "c of the transient", range_above(0, 4)},
       {"transient.reference", whole, "1", "N of the run that is taken as exact",
        range(1, Grid::max_elements)},
       {"cylinder.operations", number, "1", "as steady.operations", above_zero},
       {"cylinder.length", number, "mm", "L0, which sets the stiffness of the contact", above_zero},
       {"cylinder.distance", number, "mm", "distance from rest", above_zero},
       {"cylinder.step_ratios", list, "1", "c of the cylinder", range_above(0, 4)},
       {"cylinder.reference", whole, "1", "N of the run that is taken as exact",
        range(1, Grid::max_elements)},
       {"rough.hursts", list, "1", "Hurst exponents of rough bounds", range_above(0, 1)},
       {"rough.amplitude", number, "1", "root of the mean square of the roughness over the bound",
        range(0, 10)},
       {"rough.seed", whole, "1", "of the profiles", range(0, 4294967295)},
       {"rough.rows", whole, "1", "of the rough bounds", range(9, 1000001)},
       {"rough.force_ratio", number, "1", "force over full sliding", range_above(0, 0.99)},
       {"rough.sizes", wholes, "1", "numbers N of elements", range(11, Grid::max_elements)},
       {"rough.reference", whole, "1", "N of the solution that is taken as exact",
        range(11, Grid::max_elements)}});
  scene.declare(keys);

  const Material material = read_material(scene);
  const PolynomialBound bound = read_polynomial_bound(scene);
  const HertzBound hertz = hertz_like(bound);
  const double full = full_sliding_force(hertz);
  SpeedAccuracyParameters p{
      .bound = bound,
      .material = material,
      .length = scene.number("kernel.length"),
      .width = scene.positive("kernel.width"),
      .sizes = scene.wholes("grid.sizes"),
      .repeats = scene.number("timing.repeats"),
      .steady = {.limit = {scene.number("steady.operations")},
                 .stick_ratios = scene.numbers("steady.stick_ratios"),
                 .step_ratios = scene.numbers("steady.step_ratios"),
                 .unknowns = scene.wholes("steady.unknowns")},
      .transient = {.limit = {scene.number("transient.operations")},
                    .bound = hertz,
                    .force = full * scene.number("transient.force_ratio"),
                    .step_ratios = scene.numbers("transient.step_ratios"),
                    .reference = scene.whole("transient.reference")},
      .rolling = {.limit = {scene.number("cylinder.operations")},
                  .cylinder = {.mass = scene.positive("cylinder.mass"),
                               .inertia = scene.positive("cylinder.inertia"),
                               .radius = scene.positive("cylinder.radius"),
                               .slope_force = scene.positive("cylinder.slope_force")},
                  .length = scene.number("cylinder.length"),
                  .distance = scene.number("cylinder.distance"),
                  .step_ratios = scene.numbers("cylinder.step_ratios"),
                  .reference = scene.whole("cylinder.reference")},
      .rough = {.hursts = scene.numbers("rough.hursts"),
                .amplitude = scene.number("rough.amplitude"),
                .seed = static_cast<unsigned>(scene.whole("rough.seed")),
                .rows = scene.whole("rough.rows"),
                .force_ratio = scene.number("rough.force_ratio"),
                .sizes = scene.wholes("rough.sizes"),
                .reference = scene.whole("rough.reference")}};
  for (const Index n : p.sizes) {
    scene.demand("grid.sizes", static_cast<double>(n), n % 2 == 1 && n % 3 == 0);
  }
  demand_rising(scene, "grid.sizes", p.sizes);
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
