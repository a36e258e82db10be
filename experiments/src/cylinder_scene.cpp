// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "microslip/experiments/contact_tables.hpp"
#include "microslip/experiments/scene_tables.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"

namespace microslip::experiments {

namespace {

constexpr int most_steps = 1000000;

/// An error of the energy balance up to this fraction of the energy turned over is rounding only.
constexpr double relative_rounding = 1e-12;

/// Refuses more steps than a run may have: near rest, a small slope takes more steps than the
/// distance suggests.
void require_few_steps(const RollingCylinder& body, const CylinderScene& scene) {
  const double steps = body.steps_from_start(scene.distance);
  require(steps <= most_steps, "cylinder.slope_force", scene.cylinder.slope_force, [&] {
    return fmt::format(
        "a force that rolls {} mm in at most {} steps, not about {}; near rest they "
        "are parts of the period on the contact, {} s",
        format_short(scene.distance), format_short(most_steps), format_short(std::round(steps)),
        format_short(body.period()));
  });
}

/// Adds the work of the slope on the way to the kinetic energy at the start  [N]
double energy_turned_over(const Cylinder& body, double distance) {
  const double angular_velocity = body.velocity / body.radius;
  return body.slope_force * distance + body.mass * body.velocity * body.velocity / 2 +
         body.inertia * angular_velocity * angular_velocity / 2;
}

Table empty_history(double energy) {
  return {"history",
          "a cylinder rolls down a slope, a row a step; energies are zero at the start",
          {{"t", "s", "time"},
           {"X", "mm", "distance rolled"},
           {"v", "mm/s", "velocity"},
           {"omega", "rad/s", "angular velocity"},
           {"force", "N/mm", "force F of the contact"},
           {"creepage", "1", "(v - omega R)/v of the step"},
           {"adhesion_elements", "1", "elements in adhesion"},
           {"slip_elements", "1", "elements in slip"},
           {"potential", "N", "-F_cm X, per mm of width as all energies"},
           {"translation", "N", "change of m v^2/2"},
           {"rotation", "N", "change of I omega^2/2"},
           {"elastic", "N", "half the integral of p u"},
           {"dissipated", "N", "by slip"},
           {"total", "N", "sum of the five", relative_rounding * energy}}};
}

void add(Table& history, const RollingCylinder& body) {
  const CylinderState& state = body.state();
  const TransientState& contact = body.contact().state();
  const EnergyLedger energy = body.ledger();
  history.add({state.time, state.position, state.velocity, state.angular_velocity, state.force,
               state.creepage, contact.adhesion_elements, contact.slip_elements, energy.potential,
               energy.translation, energy.rotation, energy.elastic, energy.dissipated,
               energy.total()});
}

}  // namespace

std::vector<Table> scene_tables(const CylinderScene& scene, const Progress& progress) {
  RollingCylinder body(scene.problem, scene.cylinder, scene.integrator, scene.step_ratio,
                       scene.tolerance);
  require_few_steps(body, scene);
  Table history = empty_history(energy_turned_over(scene.cylinder, scene.distance));
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
  summary.add({"steps", history.rows() - 1, "1"});
  summary.add({"velocity", state.velocity, "mm/s"});
  summary.add({"angular_velocity", state.angular_velocity, "rad/s"});
  summary.add({"force", state.force, "N/mm"});
  summary.add({"creepage", state.creepage, "1"});
  summary.add({"full_sliding_force", full_sliding_force(scene.problem.contact.bound), "N/mm"});
  summary.add({"adhesion_elements", last.adhesion_elements, "1"});
  summary.add({"slip_elements", last.slip_elements, "1"});
  summary.add(
      {"energy_error", energy.total() / energy_turned_over(scene.cylinder, state.position), "1"},
      {"value", relative_rounding});
  summary.add({"method", name_of(scene.problem.scheme), "1"});
  add_evidence(summary, worst.evidence,
               {.condition = body.condition(),
                .iterations = worst.iterations,
                .accepted = scene.problem.accepted});
  return {traction_table("a cylinder rolls down a slope, values at the nodes at the end",
                         {body.contact().x(), body.contact().bound_at_nodes(),
                          body.contact().traction_at_nodes(), last.slip,
                          body.contact().displacement(), last.zones}),
          history, summary};
}

}  // namespace microslip::experiments
