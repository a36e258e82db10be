// SPDX-License-Identifier: GPL-3.0-or-later
#include "handle.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "zero.hpp"

namespace microslip::capi {

namespace {

/// A step of more elements would look like a program that hangs.
constexpr double most_elements = 1e6;

}  // namespace

double full_sliding_of(const microslip_rolling& handle) {
  return handle.full_sliding * handle.contact->contact().full_sliding();
}

void require_force(const microslip_rolling& handle, double force) {
  require_carried(force, handle.contact->contact(), handle.full_sliding);
}

void set_creepage(microslip_rolling& handle, double creepage) {
  require(true, "creepage", creepage, "a finite number");
  handle.load = PrescribedCreepage{creepage};
  const std::string doubt = doubt_of_creepage(creepage, handle.strain);
  if (doubt.empty()) return;
  handle.warning.say(fmt::format("creepage = {:.6g}: {}", creepage, doubt));
}

const Load& require_step(const microslip_rolling& handle, double dq) {
  const double now = handle.contact->state().scale.half_width;
  const double larger = std::max(now, handle.contact->contact().half_width);
  const double spacing = handle.spacing * (larger > 0 ? larger : 1);
  const bool rolls_back = handle.method == name_of(Remembered{});
  const double elements = (rolls_back ? std::abs(dq) : dq) / spacing;
  require(dq == 0 || (elements >= min_step_ratio && elements <= most_elements), "dq", dq, [&] {
    return fmt::format("0, or from {} to {} elements, one of which is {}{}",
                       format_short(min_step_ratio), format_short(most_elements),
                       format_short(spacing),
                       rolls_back ? ", or by as much below 0"
                       : dq < 0   ? "; the scheme remembered alone rolls back"
                                  : "");
  });
  if (!handle.load) throw std::invalid_argument("load: expected a creepage or a force to be set");
  const auto* force = std::get_if<PrescribedForce>(&*handle.load);
  if (force != nullptr) require_force(handle, force->value);
  return *handle.load;
}

microslip_state in_c(const TransientState& state) {
  return {.distance = without_sign_of_zero(state.distance),
          .force = without_sign_of_zero(state.force),
          .mean_force = without_sign_of_zero(state.mean_force),
          .creepage = without_sign_of_zero(state.creepage),
          .dissipation = without_sign_of_zero(state.dissipation),
          .residual = state.evidence.residual,
          .violation = state.evidence.violation(),
          .adhesion_elements = static_cast<int>(state.adhesion_elements),
          .slip_elements = static_cast<int>(state.slip_elements),
          .iterations = state.iterations};
}

}  // namespace microslip::capi
