// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "back_and_forth.hpp"
#include "instants.hpp"
#include "lost_energy.hpp"
#include "microslip/experiments/contact_tables.hpp"
#include "microslip/experiments/scene_tables.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/not_converged_at.hpp"
#include "microslip/support/require.hpp"
#include "patch_tables.hpp"
#include "rolled_patch.hpp"

namespace microslip::experiments {

using Eigen::Vector3d;

namespace {

/// Ends of steps, or of shifts, as rows of a table. Where a component is 0 by symmetry, the steps of
/// Newton's method leave up to 4e-7 of the largest one.
class PatchRecord {
 public:
  /// \param size  of the patch  [mm]
  explicit PatchRecord(double size) : size_(size) {}

  /// \param before, behind  cells of columns before and behind those of the record
  void add(const PatchStepEnd& end, std::vector<Cell> before = {},
           const std::vector<Cell>& behind = {}) {
    std::vector<Cell>& row = before;
    row.insert(row.end(), end.resultants.begin(), end.resultants.end());
    row.insert(row.end(), end.motion.begin(), end.motion.end());
    row.insert(row.end(), {end.slip_share, end.dissipation, end.iterations});
    row.insert(row.end(), behind.begin(), behind.end());
    rows_.push_back(row);
    const Vector3d arms(1, 1, 1 / size_);
    force_ = std::max(force_, end.resultants.cwiseProduct(arms).lpNorm<Eigen::Infinity>());
    motion_ = std::max(motion_, end.motion.cwiseQuotient(arms).lpNorm<Eigen::Infinity>());
    power_ = std::max(power_, end.evidence.power);
  }

  std::size_t rows() const { return rows_.size(); }

  /// \param motions  names, units and meanings of the three columns of motions
  /// \param loss     those of the column of the energy that is lost
  Table table(const std::string& name, const std::string& description,
              const std::vector<Column>& before, std::vector<Column> motions, Column loss,
              const std::vector<Column>& behind) const {
    constexpr double rounding = 1e-6;
    std::vector<Column> columns = before;
    columns.push_back({"force", "N", "Fx, force along the rolling", rounding * force_});
    columns.push_back({"lateral_force", "N", "Fy, force across the rolling", rounding * force_});
    columns.push_back(
        {"spin_moment", "N mm", "Mz, moment about x = y = 0", rounding * force_ * size_});
    for (std::size_t j = 0; j < motions.size(); ++j) {
      motions[j].rounding = rounding * motion_ / (j < 2 ? 1 : size_);
      columns.push_back(motions[j]);
    }
    columns.push_back({"slip_share", "1", "part of the area that slips"});
    loss.rounding = rounding * power_;
    columns.push_back(loss);
    columns.push_back({"iterations", "1", "systems that were solved"});
    columns.insert(columns.end(), behind.begin(), behind.end());
    Table made(name, description, columns);
    for (const std::vector<Cell>& row : rows_) made.add(row);
    return made;
  }

 private:
  double size_;
  /// Largest ones; of moments over the size, of spin times it.
  double force_ = 0, motion_ = 0, power_ = 0;
  std::vector<std::vector<Cell>> rows_;
};

/// A step, or shifts where the bodies stand.
struct PatchRunRow {
  double q = 0;                       ///< [mm]
  Vector3d shift = Vector3d::Zero();  ///< rigid shifts [mm] and rotation [rad]
  double loss = 0;                    ///< [N mm]
  std::optional<double> time = {};    ///< [s]
};

/// The cells of the history behind those of all records.
std::vector<Cell> behind_steps(const PatchTransient& scene, const PatchRunRow& run,
                               const PatchStepEnd& end, double full_sliding) {
  std::vector<Cell> cells;
  if (run.time) cells.emplace_back(*run.time);
  if (scene.loads.changes_contact()) {
    const double size = end.contact.half_width;
    const PatchBound& bound = scene.patch.bound;
    cells.insert(cells.end(),
                 {size * bound.half_width(), size * bound.lateral_half_width(), full_sliding});
  }
  if (!scene.loads.stops().empty()) {
    cells.insert(cells.end(), {run.shift[0], run.shift[1], run.shift[2], run.loss});
  }
  return cells;
}

Table history_of(const PatchRecord& record, const PatchHistory& loads) {
  const bool stops = !loads.stops().empty();
  std::vector<Column> behind;
  if (loads.time_at(0)) behind.push_back({"t", "s", "time"});
  if (loads.changes_contact()) {
    behind.push_back({"half_width", "mm", "of the contact, along the rolling"});
    behind.push_back({"lateral_half_width", "mm", "of the contact, across the rolling"});
    behind.push_back({"full_sliding", "N", "the force of full sliding"});
  }
  if (stops) {
    behind.push_back({"shift", "mm", "rigid shift of the step, along; the bodies may stand"});
    behind.push_back({"lateral_shift", "mm", "rigid shift of the step, across"});
    behind.push_back({"rotation", "rad", "rigid rotation of the step"});
    behind.push_back({"loss", "N mm", "energy lost in the step"});
  }
  return record.table(
      "history",
      "transient rolling of a patch, a row a step; the first is the start, where nothing moves, or "
      "the end of the run that is continued",
      {{"q", "mm", stops ? "where the bodies are" : "distance rolled"}},
      {{"creepage", "1", "xi, as a mean over the step"},
       {"lateral_creepage", "1", "eta, as a mean over the step"},
       {"spin", "1/mm", "phi, as a mean over the step"}},
      {"dissipation", "N", "energy lost per mm rolled, over the step"}, behind);
}

Table shifts_of(const PatchRecord& record) {
  return record.table(
      "shifts",
      "shifts without rolling before the bodies roll, a row a shift; the first is the start", {},
      {{"shift", "mm", "rigid shift along the rolling"},
       {"lateral_shift", "mm", "rigid shift across the rolling"},
       {"rotation", "rad", "rigid rotation about x = y = 0"}},
      {"dissipation", "N mm", "energy lost in the shift"}, {});
}

/// Quantities that add up from step to step; lengths are below 0 where the bodies roll back.
struct PatchSums {
  Vector3d path = Vector3d::Zero();  ///< [mm, mm, rad]
  LostEnergy lost{true};

  void include(const PatchStepEnd& end, double length) {
    path += length * end.motion;
    lost.add({.length = std::abs(length),
              .rate = end.dissipation,
              .power = end.evidence.power,
              .sudden_rate = end.dissipation});
  }
};

/// The resultants of a load, as " under force -1 N, spin_moment 2 N mm", or nothing.
std::string resultants_in_words(const PatchLoad& load) {
  std::string words;
  for (std::size_t j = 0; j < load.size(); ++j) {
    if (!load[j].by_resultant) continue;
    words += fmt::format("{}{} {:.6g} {}", words.empty() ? " under " : ", ", name_of(load, j),
                         load[j].value, j < 2 ? "N" : "N mm");
  }
  return words;
}

/// A step or shift in messages.
struct PlaceOfRun {
  std::string words;
  PatchLoad load;
};

/// The result of a step or shift; a message that it failed says which one, and its resultants. Those of
/// rows are known to be carried, and between rows they may not be.
/// \param place  makes a PlaceOfRun
template <class Place, class Step>
PatchStepEnd at_place(const Place& place, const Step& step) {
  try {
    return step();
  } catch (const NotConverged& error) {
    const PlaceOfRun at = place();
    throw NotConvergedAt(at.words + resultants_in_words(at.load), error);
  } catch (const BadParameter& error) {
    const bool is_resultant = error.name().ends_with("force") || error.name() == "spin_moment";
    if (!is_resultant) throw;
    throw std::invalid_argument(place().words + ": " + error.what());
  }
}

}  // namespace

std::vector<Table> scene_tables(const PatchTransient& scene, const Progress& progress) {
  return scene_tables(scene, progress, [](const PatchRolling&) {});
}

std::vector<Table> scene_tables(const PatchTransient& scene, const Progress& progress,
                                const std::function<void(const PatchRolling&)>& at_end) {
  const std::vector<double> lengths = scene.step_lengths();
  const PatchHistory& loads = scene.loads;
  const double full_sliding = scene.patch.bound.total();
  const std::vector<double> ends = loads.ends_of_steps();
  const std::size_t steps = number_of_steps(scene.distance, lengths, scene.from, ends);
  std::size_t done = 0;
  progress(done, scene.shifts.size() + steps);
  RolledPatch rolled(scene.patch, scene.scheme, loads.contact_at(0));
  std::optional<CoarsePatch> coarse;  // has no state to continue from
  if (!scene.state) coarse.emplace(scene.patch, scene.scheme, loads.contact_at(0));
  WorstOfPatch worst;
  const auto take = [&](double length, const auto& step) {
    const PatchStepEnd end = step(rolled);
    if (coarse) coarse->follow(end, length, step);
    worst.include(end);
    ++done;
    progress(done, std::max(done, scene.shifts.size() + steps));
    return end;
  };

  PatchStepEnd end{.contact = loads.contact_at(0)};
  PatchRecord shifts(scene.patch.bound.size()), history = shifts;
  shifts.add(end);
  PatchSums of_shifts, sums;
  std::size_t doubled = 0;
  for (const PatchLoad& load : scene.shifts) {
    end = at_place(
        [&] {
          return PlaceOfRun{fmt::format("shift {}", shifts.rows()), load};
        },
        [&] { return take(1, [&](RolledPatch& patch) { return patch.shift(load); }); });
    of_shifts.include(end, 1);
    shifts.add(end);
  }

  const auto record = [&](const PatchRunRow& run) {
    history.add(end, {run.q}, behind_steps(scene, run, end, rolled.full_sliding()));
  };
  if (scene.state) {
    end = rolled.restore(*scene.state, loads.at(scene.from));
  } else if (scene.start) {
    end = rolled.start_from(*scene.start);
    if (coarse) coarse->start_from(*scene.start);
  } else {  // the start is no step
    end.motion.setZero();
    end.dissipation = 0;
    end.iterations = 0;
    end.evidence.power = 0;
  }
  BackAndForth forces(scene.patch.friction, end.resultants.head<2>() / full_sliding);
  record({.q = scene.from, .time = loads.time_at(scene.from)});
  InstantTables instants(scene.instants, !loads.stops().empty());
  std::size_t steps_done = 0;
  const auto keep = [&](double distance, std::optional<double> time) {
    if (!instants.wants(steps_done)) return;
    instants.take(steps_done, {distance, loads.position_at(distance), time},
                  {rolled.tractions(), rolled.edges()});
  };
  keep(scene.from, loads.time_at(scene.from));
  const auto stand = [&](double distance) {
    for (const PatchHistory::Standing& standing : loads.standing_at(distance)) {
      const auto place = [&] {
        return PlaceOfRun{fmt::format("shift at q = {:.6g} mm", loads.position_at(distance)),
                          standing.load};
      };
      end = at_place(place, [&] {
        return take(
            1, [&](RolledPatch& patch) { return patch.shift(standing.load, standing.contact); });
      });
      sums.path += end.motion;
      sums.lost.add_shift(end.dissipation);
      const PatchRunRow run{loads.position_at(distance), end.motion, end.dissipation,
                            standing.time};
      end.motion.setZero();
      end.dissipation = 0;
      end.evidence.power = 0;
      record(run);
      keep(distance, standing.time);
    }
  };
  if (scene.from == 0) stand(0);
  for_steps(scene.distance, lengths, scene.from, ends, [&](double from, double to, double length) {
    const double dq = loads.direction_to(to) * length;
    const auto place = [&] {
      return PlaceOfRun{fmt::format("step to q = {:.6g} mm", loads.position_at(to)),
                        loads.between(from, to)};
    };
    end = at_place(place, [&] {
      return take(dq, [&](RolledPatch& patch) { return patch.roll(loads, from, to, length); });
    });
    record({loads.position_at(to), dq * end.motion, length * end.dissipation, loads.time_at(to)});
    sums.include(end, dq);
    doubled += end.has_second ? 1 : 0;
    forces.take(end.resultants.head<2>() / full_sliding);
    ++steps_done;
    keep(to, loads.time_at(to));
    stand(to);
  });
  if (rolled.remembered()) at_end(*rolled.remembered());
  if (coarse) worst.evidence.change = coarse->change();

  Table summary = empty_summary("transient rolling of a patch, the whole contact at the end");
  summary.add({"distance", scene.distance, "mm"});
  if (!loads.stops().empty()) summary.add({"position", loads.position_at(scene.distance), "mm"});
  summary.add({"steps", steps, "1"});
  add_patch_load(summary, end.resultants, end.motion, scene.patch.bound);
  summary.add({"cumulative_creep", sums.path[0], "mm"});
  summary.add({"cumulative_lateral_creep", sums.path[1], "mm"});
  summary.add({"cumulative_spin", sums.path[2], "rad"});
  add_patch_shares(summary, rolled.full_sliding(), end.resultants.head<2>().norm(), end.slip_share);
  summary.add({"dissipation", end.dissipation, "N"});
  summary.add({"dissipated_energy", sums.lost.sum(), "N mm"});
  add_patch_sizes(summary, scene.patch, end.contact.half_width);
  if (!scene.shifts.empty()) {
    summary.add({"shifts", scene.shifts.size(), "1"});
    summary.add({"shift_dissipated_energy", of_shifts.lost.sum(), "N mm"});
  }
  const std::optional<SlipFriction>& friction = scene.patch.friction;
  if (friction) summary.add({"steps_with_second_solution", doubled, "1"});
  summary.add({"method", name_of(scene.scheme), "1"});
  summary.add({"iterations", worst.iterations, "1"});
  auto doubt = both(forces.doubt(), doubt_of_patch(worst.evidence));
  if (doubled > 0) doubt = both(second_solution_in_steps(doubled, friction->branch), doubt);
  add_evidence(summary, worst.evidence,
               {.condition = rolled.condition(),
                .iterations = worst.iterations,
                .accepted = scene.patch.accepted,
                .doubt = doubt ? doubt : sums.lost.doubt()});
  std::vector<Table> tables{rolled.tractions(), rolled.edges(), history_of(history, loads),
                            summary};
  if (!scene.shifts.empty()) tables.push_back(shifts_of(shifts));
  instants.add_to(tables);
  return tables;
}

}  // namespace microslip::experiments
