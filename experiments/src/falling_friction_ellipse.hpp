// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "falling_friction_tables.hpp"
#include "microslip/friction/friction_law.hpp"

namespace microslip::experiments::falling_friction_study {

/// The study's law with a memory  [mm].
using FrictionOfMemory = std::function<SlipFriction(double memory)>;

/// Fills the table `ellipse`: runs of a contact ellipse from rest, beside steady rolling.
/// \param count  called after each run, of which there is one for each memory and step ratio
void add_ellipse(const FallingFrictionParameters& parameters, const FrictionOfMemory& friction,
                 const std::function<void()>& count, Table& table);

}  // namespace microslip::experiments::falling_friction_study
