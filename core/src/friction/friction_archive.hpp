// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "microslip/friction/friction_law.hpp"
#include "microslip/support/archive.hpp"

namespace microslip {

/// The law by its values: at the speed of rolling, a half of it, and so on. Coulomb's friction has
/// none.
inline void archive_friction(Archive& archive, const std::optional<SlipFriction>& of_contact) {
  constexpr const char* name = "friction_law";
  if (archive.reads() && archive.next_is(name) != of_contact.has_value()) {
    throw std::invalid_argument(fmt::format(
        "'{}': expected a state of {}, as the contact has it", name,
        of_contact ? "friction that falls with slip" : "Coulomb's friction without a law"));
  }
  if (!of_contact) return;
  const SlipFriction& friction = *of_contact;
  constexpr Eigen::Index values = 30;
  Eigen::VectorXd law(values);
  for (Eigen::Index i = 0; i < values; ++i) {
    law[i] = friction.law(friction.speed * std::exp2(-static_cast<double>(i)));
  }
  archive.same(name, law);
  archive.same("friction_memory", friction.memory_length);
  archive.same("memory_speed", friction.memory_speed);
}

}  // namespace microslip
