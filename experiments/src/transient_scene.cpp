// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>

#include "back_and_forth.hpp"
#include "instants.hpp"
#include "lost_energy.hpp"
#include "microslip/experiments/contact_tables.hpp"
#include "microslip/experiments/scene_tables.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged_at.hpp"
#include "microslip/support/require.hpp"

namespace microslip::experiments {

namespace {

double full_sliding_of(const TransientScene& scene, const TransientState& state) {
  return full_sliding_force(scene.problem.contact.bound) * state.scale.full_sliding();
}

Table tractions_of(const TransientRolling& rolling) {
  const TransientState& state = rolling.state();
  return traction_table("transient rolling, values at the nodes at the end",
                        {rolling.x(), rolling.bound_at_nodes(), rolling.traction_at_nodes(),
                         state.slip, rolling.displacement(), state.zones});
}

/// A step, or a shift where the bodies stand.
struct RunRow {
  double shift = 0;            ///< rigid shift  [mm]
  double loss = 0;             ///< energy per mm width  [N]
  std::optional<double> time;  ///< at the end  [s]
};

Table empty_history(const LoadHistory& loads) {
  const bool stops = !loads.stops().empty();
  std::vector<Column> columns{
      {"q", "mm", stops ? "where the bodies are" : "distance rolled"},
      {"force", "N/mm", "total force F"},
      {"creepage", "1", "relative rigid slip w of the step"},
      {"adhesion_elements", "1", "elements in adhesion"},
      {"slip_elements", "1", "elements in slip"},
      {"dissipation", "N/mm", "energy lost per mm rolled and mm width, over the step"},
      {"iterations", "1", "stick/slip partitions tried"}};
  if (loads.time_at(0)) columns.push_back({"t", "s", "time"});
  if (loads.changes_contact()) {
    columns.push_back({"half_width", "mm", "of the contact"});
    columns.push_back({"full_sliding", "N/mm", "the force of full sliding"});
  }
  if (stops) {
    columns.push_back({"shift", "mm", "rigid shift of the step; the bodies may stand"});
    columns.push_back({"loss", "N", "energy lost in the step per mm width"});
  }
  return {"history",
          "transient rolling, a row a step; the first is the start, where there is no rate",
          columns};
}

void add(Table& history, const TransientState& state, const RunRow& run,
         const TransientScene& scene) {
  std::vector<Cell> row{state.distance,
                        state.force,
                        state.creepage,
                        static_cast<double>(state.adhesion_elements),
                        static_cast<double>(state.slip_elements),
                        state.dissipation,
                        static_cast<double>(state.iterations)};
  if (run.time) row.emplace_back(*run.time);
  if (scene.loads.changes_contact()) {
    row.emplace_back(state.scale.half_width * scene.problem.grid.half_width());
    row.emplace_back(full_sliding_of(scene, state));
  }
  if (!scene.loads.stops().empty()) {
    row.emplace_back(run.shift);
    row.emplace_back(run.loss);
  }
  history.add(row);
}

/// A record of all shifts before rolling, with their sums.
struct ShiftRecord {
  std::vector<std::vector<Cell>> rows = {};  ///< of the table
  double distance = 0;                       ///< [mm]
  double dissipation = 0;                    ///< [N]
  double largest_work = 0;                   ///< of a single shift  [N]
  WorstOfSteps worst = {};
};

ShiftRecord shift_all(TransientRolling& rolling, const TransientScene& scene,
                      const std::function<void()>& after_each) {
  ShiftRecord record;
  const auto include = [&](const Shift& shift) {
    const TransientState& state = rolling.state();
    record.distance += shift.distance;
    record.dissipation += shift.dissipation;
    record.largest_work = std::max(record.largest_work, std::abs(shift.work));
    record.rows.push_back({state.force, shift.distance, record.distance, shift.dissipation,
                           shift.work, rolling.elastic_energy(),
                           static_cast<double>(state.adhesion_elements),
                           static_cast<double>(state.slip_elements)});
  };
  include({});
  for (const ShiftLoad& load : scene.shifts) {
    include(rolling.shift(load));
    record.worst.include(rolling.state());
    after_each();
  }
  return record;
}

Table shifts_table(const ShiftRecord& record) {
  Table table(
      "shifts",
      "shifts without rolling before the bodies roll, a row a shift; the first is the start",
      {{"force", "N/mm", "total force F at its end"},
       {"shift", "mm", "rigid shift; a positive one gives negative tractions"},
       {"total_shift", "mm", "the sum so far"},
       {"dissipation", "N", "energy lost per mm width", 1e-12 * record.largest_work},
       {"work", "N", "of the force: dissipation plus what is stored more"},
       {"elastic_energy", "N", "stored per mm width at its end"},
       {"adhesion_elements", "1", "elements in adhesion"},
       {"slip_elements", "1", "elements in slip"}});
  for (const std::vector<Cell>& row : record.rows) table.add(row);
  return table;
}

/// Warns about shifts that are accepted but doubtful; returns none otherwise.
/// \throws as require_evidence
std::optional<std::string> doubt_of(const ShiftRecord& shifts, const Acceptance& accepted) {
  constexpr double no_condition = 1;  // estimated once, after the last step
  require_evidence(shifts.worst.evidence, no_condition, shifts.worst.iterations, accepted);
  const auto doubt = microslip::doubt_of(shifts.worst.evidence, accepted, false);
  return doubt ? std::optional("in the shifts, " + *doubt) : std::nullopt;
}

}  // namespace

std::vector<Table> scene_tables(const TransientScene& scene, const Progress& progress) {
  return scene_tables(scene, progress, [](TransientRolling&) {});
}

std::vector<Table> scene_tables(const TransientScene& scene, const Progress& progress,
                                const std::function<void(TransientRolling&)>& at_end) {
  const std::vector<double> lengths = scene.step_lengths();
  const std::vector<double> ends = scene.loads.ends_of_steps();
  const std::size_t steps = number_of_steps(scene.distance, lengths, scene.from, ends);
  TransientRolling rolling(scene.problem, scene.start, scene.loads.contact_at(0));
  std::size_t done = 0;
  const auto count = [&] { progress(++done, scene.shifts.size() + steps); };
  const ShiftRecord shifts = shift_all(rolling, scene, count);
  const auto shift_doubt = doubt_of(shifts, scene.problem.accepted);
  Table history = empty_history(scene.loads);
  TransientState start = rolling.state();
  if (scene.from == 0) start.iterations = 0;  // the start is no step
  add(history, start, {.time = scene.loads.time_at(scene.from)}, scene);
  double cumulative_creep = 0;
  std::size_t doubled = 0;
  LostEnergy lost;
  const double full = full_sliding_force(scene.problem.contact.bound);
  BackAndForth forces(scene.problem.friction, {start.force / full, 0});
  double distance_before = start.distance, force_before = start.force;
  WorstOfSteps worst;
  InstantTables instants(scene.instants, !scene.loads.stops().empty());
  std::size_t step = 0;
  double way = scene.from;
  const auto keep = [&](std::optional<double> time) {
    if (!instants.wants(step)) return;
    instants.take(step, {way, rolling.state().distance, time}, {tractions_of(rolling)});
  };
  keep(scene.loads.time_at(scene.from));
  const auto take = [&](const TransientState& state, const RunRow& run) {
    add(history, state, run, scene);
    cumulative_creep += run.shift;
    distance_before = state.distance;
    force_before = state.force;
    doubled += state.has_second ? 1 : 0;
    worst.include(state);
  };
  const TransientRolling::Observer observer{
      .after_step =
          [&](const TransientState& state, std::optional<double> time) {
            const double length = state.distance - distance_before;
            lost.add(state, std::abs(length), force_before, full);
            forces.take({state.force / full, 0});
            take(state, {.shift = state.creepage * length,
                         .loss = state.dissipation * std::abs(length),
                         .time = time});
            ++step;
            way += std::abs(length);
            keep(time);
            count();
          },
      .after_shift =
          [&](const TransientState& state, const Shift& shift, std::optional<double> time) {
            lost.add_shift(shift.dissipation);
            take(state, {.shift = shift.distance, .loss = shift.dissipation, .time = time});
            keep(time);
          }};
  try {
    rolling.roll_to(scene.distance, lengths, scene.loads, observer);
  } catch (const NotConverged& error) {
    throw NotConvergedAt(fmt::format("behind q = {:.6g} mm", rolling.state().distance), error);
  } catch (const BadParameter& error) {
    if (error.name() != "force") throw;
    // Rows are carried, and what is between them may not be.
    throw std::invalid_argument(
        fmt::format("behind q = {:.6g} mm: {}", rolling.state().distance, error.what()));
  }
  at_end(rolling);  // before the estimate of the condition, which refactorises

  const TransientState& last = rolling.state();
  const double full_sliding = full_sliding_of(scene, last);
  Table summary = empty_summary("transient rolling, the whole contact at the end");
  summary.add({"distance", scene.distance, "mm"});
  if (!scene.loads.stops().empty()) summary.add({"position", last.distance, "mm"});
  summary.add({"steps", steps, "1"});
  summary.add({"force", last.force, "N/mm"});
  summary.add({"creepage", last.creepage, "1"});
  summary.add({"cumulative_creep", cumulative_creep, "mm"});
  summary.add({"force_ratio", full_sliding > 0 ? last.force / full_sliding : 0, "1"});
  summary.add({"full_sliding_force", full_sliding, "N/mm"});
  summary.add({"adhesion_elements", last.adhesion_elements, "1"});
  summary.add({"slip_elements", last.slip_elements, "1"});
  summary.add({"dissipation", last.dissipation, "N/mm"});
  summary.add({"dissipated_energy", lost.sum(), "N"});
  if (!scene.shifts.empty()) {
    summary.add({"shifts", scene.shifts.size(), "1"});
    summary.add({"shift_sum", shifts.distance, "mm"});
    summary.add({"shift_dissipated_energy", shifts.dissipation, "N"});
  }
  const std::optional<SlipFriction>& friction = scene.problem.friction;
  if (friction) summary.add({"steps_with_second_solution", doubled, "1"});
  summary.add({"method", name_of(scene.problem.scheme), "1"});
  auto doubt =
      both(forces.doubt(),
           both(shift_doubt, microslip::doubt_of(worst.evidence, scene.problem.accepted, false)));
  if (doubled > 0) doubt = both(second_solution_in_steps(doubled, friction->branch), doubt);
  if (!doubt) doubt = lost.doubt();
  add_evidence(summary, worst.evidence,
               {.condition = rolling.condition(),
                .iterations = worst.iterations,
                .accepted = scene.problem.accepted,
                .doubt = doubt});
  std::vector<Table> tables{tractions_of(rolling), history, summary};
  if (!scene.shifts.empty()) tables.push_back(shifts_table(shifts));
  instants.add_to(tables);
  return tables;
}

}  // namespace microslip::experiments
