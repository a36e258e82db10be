// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <new>
#include <optional>
#include <stdexcept>
#include <utility>

#include "handle.hpp"
#include "microslip/support/require.hpp"

namespace {

using namespace microslip::capi;

void validate(const microslip_steps& steps) {
  if (steps.count > 0) require_pointer(steps.dq, "steps.dq");
  if (steps.creepage != nullptr && steps.force != nullptr) {
    throw std::invalid_argument("steps.force: expected null where there are creepages");
  }
  if ((steps.half_width_factor == nullptr) != (steps.bound_factor == nullptr)) {
    throw std::invalid_argument(
        "steps.bound_factor: expected an array where steps.half_width_factor is one, else null");
  }
}

void make_step(microslip_rolling& of, const microslip_steps& steps, std::size_t k) {
  if (steps.half_width_factor != nullptr) {
    of.contact->set_contact(
        {.half_width = steps.half_width_factor[k], .bound = steps.bound_factor[k]});
  }
  if (steps.creepage != nullptr) {
    set_creepage(of, steps.creepage[k]);
  } else if (steps.force != nullptr) {
    of.load = microslip::PrescribedForce{steps.force[k]};
  }
  of.contact->step(steps.dq[k], require_step(of, steps.dq[k]));
}

/// Says in front of a message which step it is about. Allocates nothing.
void name_step(microslip_rolling& of, std::size_t k) {
  char text[sizeof of.message];
  std::snprintf(text, sizeof text, "steps[%zu]: %.*s", k, static_cast<int>(sizeof text) - 40,
                of.message);
  Message{of.message, sizeof of.message}.say(text);
}

}  // namespace

microslip_status microslip_roll(microslip_rolling* rolling, const microslip_steps* steps,
                                microslip_state* states) {
  std::optional<std::size_t> at;
  const auto roll = [&](microslip_rolling& of) {
    const microslip_steps& all = require_pointer(steps, "steps");
    validate(all);
    microslip_rolling before(of);
    if (all.creepage != nullptr || all.force != nullptr) of.warning.forget_load();
    try {
      for (std::size_t k = 0; k < all.count; ++k) {
        at = k;
        make_step(of, all, k);
        if (states != nullptr) states[k] = in_c(of.contact->state());
      }
    } catch (const std::bad_alloc&) {
      throw;
    } catch (...) {
      std::swap(of.contact, before.contact);
      of.load = before.load;
      throw;
    }
  };
  return roll_with(rolling, roll, [&] {
    if (at) name_step(*rolling, *at);
  });
}
