// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>
#include <mutex>
#include <utility>

#include "ellipse_handle.hpp"
#include "handle.hpp"
#include "microslip/support/require.hpp"
#include "microslip_friction.h"

using namespace microslip::capi;

namespace {

void require_one_of(const char* name, int value, int count) {
  microslip::require(value >= 0 && value < count, name, value,
                     [&] { return fmt::format("a whole number 0 ... {}", count - 1); });
}

/// \throws std::invalid_argument for what is out of its range
microslip::SlipFriction friction_of(const microslip_friction& given) {
  require_one_of("form", given.form, 3);
  require_one_of("branch", given.branch, 2);
  const auto form = static_cast<microslip::FrictionLaw::Form>(given.form);
  const microslip::SlipFriction friction{.law = {form, given.kinetic_ratio, given.half_speed},
                                         .speed = given.speed,
                                         .memory_length = given.memory_length,
                                         .memory_speed = given.memory_speed,
                                         .branch = given.branch == MICROSLIP_LEAST_SLIP
                                                       ? microslip::SlipBranch::least
                                                       : microslip::SlipBranch::most};
  validate(friction);
  return friction;
}

}  // namespace

microslip_status microslip_set_friction(microslip_rolling* rolling,
                                        const microslip_friction* friction) {
  return with(rolling, [&](microslip_rolling& of) {
    microslip::TransientProblem problem = of.problem;
    problem.friction = friction_of(require_pointer(friction, "friction"));
    auto made = std::make_unique<microslip::TransientRolling>(problem);
    of.contact = std::move(made);
    of.problem = problem;
  });
}

microslip_status microslip_set_speed(microslip_rolling* rolling, double speed) {
  return with(rolling, [&](microslip_rolling& of) { of.contact->set_speed(speed); });
}

int microslip_has_second_solution(const microslip_rolling* rolling) {
  if (rolling == nullptr) return 0;
  const std::lock_guard lock(rolling->mutex);
  return rolling->contact && rolling->contact->state().has_second ? 1 : 0;
}

microslip_status microslip_ellipse_set_friction(microslip_ellipse* ellipse,
                                                const microslip_friction* friction) {
  return with_ellipse(ellipse, [&](microslip_ellipse& of) {
    microslip::SteadyPatch problem = of.problem;
    problem.friction = friction_of(require_pointer(friction, "friction"));
    const microslip::PatchRolling rolling(problem);
    of.trial = rolling;
    of.rolling = rolling;
    of.problem = problem;
    of.attempt.reset();
    of.solver.reset();
    of.has_second = false;
  });
}

microslip_status microslip_ellipse_set_speed(microslip_ellipse* ellipse, double speed) {
  return with_ellipse(ellipse, [&](microslip_ellipse& of) {
    of.rolling.set_speed(speed);
    of.attempt.reset();
    if (of.solver) of.solver->set_speed(speed);
    if (of.problem.friction) of.problem.friction->speed = speed;
  });
}

int microslip_ellipse_has_second_solution(const microslip_ellipse* ellipse) {
  if (ellipse == nullptr) return 0;
  const std::lock_guard lock(ellipse->mutex);
  return ellipse->has_second ? 1 : 0;
}
