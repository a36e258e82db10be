// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip.h"

#include <fmt/core.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <string>

#include "handle.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/shown.hpp"
#include "microslip/support/text.hpp"
#include "problem.hpp"
#include "text_file.hpp"
#include "version.hpp"
#include "zero.hpp"

using namespace microslip::capi;

namespace {

microslip_slopes in_c(const microslip::StepSlopes& slopes) {
  return {.force = without_sign_of_zero(slopes.force),
          .mean_force = without_sign_of_zero(slopes.mean_force),
          .creepage = without_sign_of_zero(slopes.creepage),
          .dissipation = without_sign_of_zero(slopes.dissipation)};
}

microslip_status shift_with(microslip_rolling* handle, const microslip::ShiftLoad& load,
                            microslip_shift* out) noexcept {
  return roll_with(handle, [&](microslip_rolling& of) {
    if (const auto* force = std::get_if<microslip::PrescribedForce>(&load)) {
      require_force(of, force->value);
    } else {
      microslip::require(true, "distance", std::get<microslip::PrescribedShift>(load).value,
                         "a finite number");
    }
    const microslip::Shift shift = of.contact->shift(load);
    if (out == nullptr) return;
    *out = {.distance = without_sign_of_zero(shift.distance),
            .force = without_sign_of_zero(of.contact->state().force),
            .dissipation = without_sign_of_zero(shift.dissipation),
            .work = without_sign_of_zero(shift.work)};
  });
}

/// Values at the nodes into an array of the caller's.
template <class Value, class Values>
microslip_status copy_values(microslip_rolling* handle, Value* to, std::size_t length,
                             const Values& values) noexcept {
  return with(handle, [&](const microslip_rolling& of) {
    require_pointer(to, "values");
    const auto size = static_cast<std::size_t>(of.contact->x().size());
    microslip::require(length >= size, "length", static_cast<double>(length),
                       [&] { return fmt::format("at least {}", size); });
    const auto from = values(*of.contact);
    std::transform(from.begin(), from.end(), to, [](auto value) {
      return static_cast<Value>(without_sign_of_zero(static_cast<double>(value)));
    });
  });
}

}  // namespace

const char* microslip_version(void) { return microslip::capi::version; }

microslip_status microslip_create(const microslip_material* material,
                                  const microslip_contact* contact, const microslip_kernel* kernel,
                                  const microslip_grid* grid, microslip_rolling** rolling,
                                  char* message, size_t message_size) {
  if (rolling != nullptr) *rolling = nullptr;
  return guarded({message, message_size}, [&] {
    microslip_rolling*& made = require_pointer(rolling, "rolling");
    made = new microslip_rolling(microslip::capi::make_problem(
        require_pointer(material, "material"), require_pointer(contact, "contact"),
        require_pointer(kernel, "kernel"), require_pointer(grid, "grid")));
    made->warning.say_of_units(doubt_of_units(*material, made->problem.contact.bound));
  });
}

microslip_status microslip_create_unlike(const microslip_material* material,
                                         const microslip_unlike* unlike,
                                         const microslip_contact* contact,
                                         const microslip_kernel* kernel, const microslip_grid* grid,
                                         microslip_rolling** rolling, char* message,
                                         size_t message_size) {
  if (rolling != nullptr) *rolling = nullptr;
  return guarded({message, message_size}, [&] {
    microslip_rolling*& made = require_pointer(rolling, "rolling");
    made = new microslip_rolling(microslip::capi::make_problem(
        require_pointer(material, "material"), require_pointer(unlike, "unlike"),
        require_pointer(contact, "contact"), require_pointer(kernel, "kernel"),
        require_pointer(grid, "grid")));
    made->warning.say_of_units(doubt_of_units(*material, made->problem.contact.bound));
  });
}

microslip_status microslip_copy(microslip_rolling* rolling, microslip_rolling** copy) {
  if (copy != nullptr) *copy = nullptr;
  return with(rolling, [&](const microslip_rolling& from) {
    microslip_rolling*& made = require_pointer(copy, "copy");
    made = new microslip_rolling(from);
  });
}

void microslip_destroy(microslip_rolling* rolling) { delete rolling; }

const char* microslip_message(microslip_rolling* rolling) {
  return rolling == nullptr ? "rolling = null: expected a handle" : rolling->message;
}

const char* microslip_warning(const microslip_rolling* rolling) {
  return rolling == nullptr ? "" : rolling->warning.text();
}

const char* microslip_method(const microslip_rolling* rolling) {
  return rolling == nullptr ? "" : rolling->method.c_str();
}

microslip_status microslip_save(microslip_rolling* rolling, const char* path) {
  return with(rolling, [&](microslip_rolling& of) {
    const std::string name = &require_pointer(path, "path");
    microslip::capi::write_text(name, of.contact->save());
  });
}

microslip_status microslip_restore(microslip_rolling* rolling, const char* path) {
  return with(rolling, [&](microslip_rolling& of) {
    const std::string name = &require_pointer(path, "path");
    try {
      of.contact->restore({microslip::file_text(name)});
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(
          fmt::format("path = '{}': {}", microslip::shown(name), error.what()));
    }
  });
}

microslip_status microslip_set_creepage(microslip_rolling* rolling, double creepage) {
  return with(rolling, [&](microslip_rolling& of) {
    of.warning.forget_load();
    set_creepage(of, creepage);
  });
}

microslip_status microslip_set_force(microslip_rolling* rolling, double force) {
  return with(rolling, [&](microslip_rolling& of) {
    require_force(of, force);
    of.warning.forget_load();
    of.load = microslip::PrescribedForce{force};
  });
}

microslip_status microslip_set_contact(microslip_rolling* rolling, double half_width_factor,
                                       double bound_factor) {
  return with(rolling, [&](microslip_rolling& of) {
    of.contact->set_contact({.half_width = half_width_factor, .bound = bound_factor});
  });
}

microslip_status microslip_start_from_shift(microslip_rolling* rolling, double force,
                                            double* shift) {
  return roll_with(rolling, [&](microslip_rolling& of) {
    require_force(of, force);
    const double found = of.contact->start_from_shift({force});
    if (shift != nullptr) *shift = without_sign_of_zero(found);
  });
}

microslip_status microslip_shift_to_force(microslip_rolling* rolling, double force,
                                          microslip_shift* shift) {
  return shift_with(rolling, microslip::PrescribedForce{force}, shift);
}

microslip_status microslip_shift_by_distance(microslip_rolling* rolling, double distance,
                                             microslip_shift* shift) {
  return shift_with(rolling, microslip::PrescribedShift{distance}, shift);
}

microslip_status microslip_advance(microslip_rolling* rolling, double dq) {
  return roll_with(rolling,
                   [&](microslip_rolling& of) { of.contact->step(dq, require_step(of, dq)); });
}

microslip_status microslip_attempt(microslip_rolling* rolling, double dq, microslip_state* state) {
  return roll_with(rolling, [&](microslip_rolling& of) {
    microslip_state& out = require_pointer(state, "state");
    out = in_c(of.contact->attempt(dq, require_step(of, dq)));
  });
}

microslip_status microslip_attempt_with_jacobian(microslip_rolling* rolling, double dq,
                                                 microslip_state* state,
                                                 microslip_jacobian* jacobian) {
  return roll_with(rolling, [&](microslip_rolling& of) {
    microslip_state& out = require_pointer(state, "state");
    microslip_jacobian& slopes = require_pointer(jacobian, "jacobian");
    microslip::StepJacobian found;
    out = in_c(of.contact->attempt(dq, require_step(of, dq), found));
    slopes = {.by_load = in_c(found.by_load), .by_length = in_c(found.by_length)};
  });
}

microslip_status microslip_get_state(microslip_rolling* rolling, microslip_state* state) {
  return with(rolling, [&](const microslip_rolling& of) {
    require_pointer(state, "state") = in_c(of.contact->state());
  });
}

microslip_status microslip_get_elastic_energy(microslip_rolling* rolling, double* energy) {
  return with(rolling, [&](const microslip_rolling& of) {
    require_pointer(energy, "energy") = of.contact->elastic_energy();
  });
}

microslip_status microslip_get_full_sliding(microslip_rolling* rolling, double* force) {
  return with(rolling, [&](const microslip_rolling& of) {
    require_pointer(force, "force") = full_sliding_of(of);
  });
}

size_t microslip_size(microslip_rolling* rolling) {
  if (rolling == nullptr) return 0;
  const std::lock_guard lock(rolling->mutex);
  return rolling->contact ? static_cast<std::size_t>(rolling->contact->x().size()) : 0;
}

microslip_status microslip_get_nodes(microslip_rolling* rolling, double* values, size_t length) {
  return copy_values(rolling, values, length, [](const auto& of) { return of.x(); });
}

microslip_status microslip_get_traction(microslip_rolling* rolling, double* values, size_t length) {
  return copy_values(rolling, values, length,
                     [](const auto& of) { return of.traction_at_nodes(); });
}

microslip_status microslip_get_bound(microslip_rolling* rolling, double* values, size_t length) {
  return copy_values(rolling, values, length, [](const auto& of) { return of.bound_at_nodes(); });
}

microslip_status microslip_get_slip(microslip_rolling* rolling, double* values, size_t length) {
  return copy_values(rolling, values, length, [](const auto& of) { return of.state().slip; });
}

microslip_status microslip_get_displacement(microslip_rolling* rolling, double* values,
                                            size_t length) {
  return copy_values(rolling, values, length, [](const auto& of) { return of.displacement(); });
}

microslip_status microslip_get_zones(microslip_rolling* rolling, int* values, size_t length) {
  return copy_values(rolling, values, length, [](const auto& of) { return of.state().zones; });
}
