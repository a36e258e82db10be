// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "microslip.h"
#include "microslip/rolling/large_creepage.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/transient.hpp"
#include "status.hpp"

/// The contact behind a handle of the C interface.
struct microslip_rolling {
  explicit microslip_rolling(const microslip::TransientProblem& given)
      : problem(given),
        contact(std::make_unique<microslip::TransientRolling>(problem)),
        method(microslip::name_of(problem.scheme)),
        spacing(problem.grid.spacing()),
        full_sliding(spacing * contact->bound().sum()),
        strain(microslip::bound_strain(problem.contact.bound, problem.contact.kernel)) {}

  microslip_rolling(const microslip_rolling& other)
      : problem(other.problem),
        contact(std::make_unique<microslip::TransientRolling>(*other.contact)),
        method(other.method),
        spacing(other.spacing),
        full_sliding(other.full_sliding),
        strain(other.strain),
        load(other.load),
        warning(other.warning) {}

  microslip::TransientProblem problem;
  std::unique_ptr<microslip::TransientRolling> contact;  ///< null if it was lost
  std::string method;                                    ///< name of its scheme
  double spacing;                                        ///< dx  [mm]
  double full_sliding;                                   ///< as the elements have it  [N/mm]
  double strain;                                         ///< mean bound over shear modulus  [1]
  std::optional<microslip::Load> load;
  char message[512] = "";  ///< of the last call that failed
  microslip::capi::Warning warning = {};
  mutable std::mutex mutex;  ///< held by each call, so that calls of several threads take turns
};

namespace microslip::capi {

/// Does the work with what a handle stands for, whose mutex the caller holds.
template <class Work>
microslip_status with_locked(microslip_rolling* handle, const Work& work) noexcept {
  const Message message{handle->message, sizeof handle->message};
  if (!handle->contact) {
    message.say("out of memory in an earlier step: expected no more than to be destroyed");
    return MICROSLIP_OUT_OF_MEMORY;
  }
  return guarded(message, [&] { work(*handle); });
}

/// Does the work with what a handle stands for, while no other thread does.
template <class Work>
microslip_status with(microslip_rolling* handle, const Work& work) noexcept {
  if (handle == nullptr) return MICROSLIP_BAD_INPUT;
  const std::lock_guard lock(handle->mutex);
  return with_locked(handle, work);
}

/// The same for work that changes the contact. Where memory runs out in between, the contact is
/// lost, and leaks: see TransientRolling.
/// \param failed  called without arguments if the work fails; throws nothing
template <class Work, class Failed>
microslip_status roll_with(microslip_rolling* handle, const Work& work,
                           const Failed& failed) noexcept {
  if (handle == nullptr) return MICROSLIP_BAD_INPUT;
  const std::lock_guard lock(handle->mutex);
  const microslip_status status = with_locked(handle, work);
  if (status == MICROSLIP_OUT_OF_MEMORY) static_cast<void>(handle->contact.release());
  if (status != MICROSLIP_OK) failed();
  return status;
}

template <class Work>
microslip_status roll_with(microslip_rolling* handle, const Work& work) noexcept {
  return roll_with(handle, work, [] {});
}

/// The largest force that the bound allows, of the contact that is set  [N/mm]
double full_sliding_of(const microslip_rolling& handle);

/// \throws std::invalid_argument for a force that is not below full sliding
void require_force(const microslip_rolling& handle, double force);

/// Sets the load, and warns of a creepage that is large.
/// \throws std::invalid_argument for a creepage that is not finite
void set_creepage(microslip_rolling& handle, double creepage);

/// Rejects a length dq that is out of its range, and a step without a load.
/// \return the load of the step
const Load& require_step(const microslip_rolling& handle, double dq);

microslip_state in_c(const TransientState& state);

}  // namespace microslip::capi
