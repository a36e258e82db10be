// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "microslip/experiments/contact_tables.hpp"
#include "microslip/experiments/scene_tables.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip::experiments {

namespace {

constexpr int most_steps = 1000000;

Table empty_history() {
  return {"history",
          "a cylinder rolls down a slope, a row a step; energies are zero at the start",
          {{"t", "s", "time"},
           {"X", "mm", "distance rolled"},
           {"v", "mm/s", "velocity"},
           {"omega", "1/s", "angular velocity"},
           {"force", "N/mm", "force F of the contact"},
           {"creepage", "1", "(v - omega R)/v of the step"},
           {"adhesion_elements", "1", "elements in adhesion"},
           {"slip_elements", "1", "elements in slip"},
           {"potential", "N", "-F_cm X, per mm of width as all energies"},
           {"translation", "N", "m v^2/2"},
           {"rotation", "N", "I omega^2/2"},
           {"elastic", "N", "half the integral of p u"},
           {"dissipated", "N", "with tractions at the end of each step"},
           {"total", "N", "sum of the five"},
           {"mean_dissipated", "N", "with mean tractions of material points; nan if not material"},
           {"mean_total", "N", "sum with that"}}};
}

void add(Table& history, const RollingCylinder& body) {
  const CylinderState& state = body.state();
  const TransientState& contact = body.contact().state();
  const EnergyLedger energy = body.ledger();
  history.add({state.time, state.position, state.velocity, state.angular_velocity, state.force,
               state.creepage, static_cast<double>(contact.adhesion_elements),
               static_cast<double>(contact.slip_elements), energy.potential, energy.translation,
               energy.rotation, energy.elastic, energy.dissipated, energy.total(),
               energy.mean_dissipated, energy.mean_total()});
}

}  // namespace

std::vector<Table> scene_tables(const CylinderScene& scene, const Progress& progress) {
  RollingCylinder body(scene.contact, scene.cylinder, scene.integrator, scene.step_ratio);
  Table history = empty_history();
  add(history, body);
  constexpr std::size_t parts = 1000;
  WorstOfSteps worst;
  while (body.state().position < scene.distance) {
    body.step();
    add(history, body);
    worst.include(body.contact().state());
    if (history.rows() > most_steps) {
      throw NotConverged("more steps than a history may hold", most_steps,
                         1 - body.state().position / scene.distance);
    }
    const double part = std::min(1.0, body.state().position / scene.distance);
    progress(static_cast<std::size_t>(std::floor(part * parts)), parts);
  }
  const CylinderState& state = body.state();
  const TransientState& last = body.contact().state();
  const EnergyLedger energy = body.ledger();
  Table summary = empty_summary("a cylinder rolls down a slope, the end");
  summary.add({"time", state.time, "s"});
  summary.add({"distance", state.position, "mm"});
  summary.add({"steps", static_cast<double>(history.rows() - 1), "1"});
  summary.add({"velocity", state.velocity, "mm/s"});
  summary.add({"angular_velocity", state.angular_velocity, "1/s"});
  summary.add({"force", state.force, "N/mm"});
  summary.add({"creepage", state.creepage, "1"});
  summary.add({"full_sliding_force", full_sliding_force(scene.contact.bound), "N/mm"});
  summary.add({"adhesion_elements", static_cast<double>(last.adhesion_elements), "1"});
  summary.add({"slip_elements", static_cast<double>(last.slip_elements), "1"});
  summary.add({"energy_error", energy.total() / -energy.potential, "1"});
  summary.add({"mean_energy_error", energy.mean_total() / -energy.potential, "1"});
  add_evidence(summary, worst.evidence, body.condition(), worst.iterations, scene.contact.solver);
  return {traction_table("a cylinder rolls down a slope, values at the nodes at the end",
                         {body.contact().x(), body.contact().bound_at_nodes(),
                          body.contact().traction_at_nodes(), last.slip,
                          body.contact().displacement(), last.zones}),
          history, summary};
}

}  // namespace microslip::experiments
