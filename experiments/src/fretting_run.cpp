// SPDX-License-Identifier: GPL-3.0-or-later
#include "fretting_run.hpp"

#include <cmath>

namespace microslip::experiments::fretting_study {

namespace {

/// Each change of the force at standstill is divided into so many shifts.
constexpr int parts = 20;

/// Energies since the start.
struct Energies {
  double work = 0;         ///< of the force  [N]
  double turned_over = 0;  ///< the same without signs  [N]
  double dissipated = 0;   ///< [N]

  void add(double more_work, double more_dissipated) {
    work += more_work;
    turned_over += std::abs(more_work);
    dissipated += more_dissipated;
  }
};

}  // namespace

Table run_table(const FrettingParameters& p, TransientRolling rolling) {
  Table table(
      "run", "standstill, rolling and standstill in one run, Hertz's bound, remembered",
      {{"stage", "1", "which, from 1"},
       {"kind", "1", "standstill or rolling"},
       {"distance", "mm", "rolled"},
       {"force", "1", "part of full sliding"},
       {"displacement", "mm", "minus shift and creep since the start"},
       {"work", "N", "of the force since the start"},
       {"dissipated", "N", "since the start"},
       {"stored", "N", "now"},
       {"imbalance", "1", "work less the two, over the work done without signs", run_rounding}});
  const double sliding = p.bound.total();
  const double spacing = 2 * p.bound.half_width() / static_cast<double>(p.run_elements);
  Energies energies;
  double displacement = 0;
  double stage = 1;
  const auto add = [&](const char* kind) {
    const double stored = rolling.elastic_energy();
    table.add({stage, kind, rolling.state().distance, rolling.state().force / sliding, displacement,
               energies.work, energies.dissipated, stored,
               (energies.work - energies.dissipated - stored) / energies.turned_over});
  };
  double force = 0;
  const auto shift_to = [&](double part) {
    const double to = part * sliding;
    for (int i = 1; i <= parts; ++i) {
      const Shift shift = rolling.shift(PrescribedForce{force + (to - force) * i / parts});
      displacement -= shift.distance;
      energies.add(shift.work, shift.dissipation);
      add("standstill");
    }
    force = to;
  };
  const auto roll = [&] {
    double before = rolling.state().distance;
    rolling.roll(p.run_distance * spacing, {p.run_step_ratio * spacing}, PrescribedForce{force},
                 [&](const TransientState& state) {
                   const double length = state.distance - before;
                   before = state.distance;
                   displacement -= state.creepage * length;
                   energies.add(-state.mean_force * state.creepage * length,
                                state.dissipation * length);
                   add("rolling");
                 });
  };
  for (const double part : {p.run_force, -p.run_force, p.run_force}) shift_to(part);
  ++stage;
  roll();
  ++stage;
  for (const double part : {p.run_force - p.run_swing, p.run_force + p.run_swing, p.run_force}) {
    shift_to(part);
  }
  ++stage;
  roll();
  ++stage;
  shift_to(0);
  return table;
}

}  // namespace microslip::experiments::fretting_study
