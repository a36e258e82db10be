// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/patch/patch_bound.hpp"
#include "microslip/patch/traction_table.hpp"
#include "microslip/rolling/contact_scale.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip {

inline constexpr const char* patch_file = "contact.patch_file";
inline constexpr const char* bound_file = "contact.bound_file";

/// Reads the edges of a contact by contact.patch_file: columns y, trailing and leading, and lobe, a
/// number, if there are several lobes. Without it a new lobe begins behind a row in which the edges
/// meet, unless it is the first of its lobe, and where y does not rise.
PatchShape read_shape(Scene& scene);

/// Reads contact.bound_file with columns x, y and bound, and warns of a coarse one.
PatchBound read_bound_table(Scene& scene, const PatchShape& shape);

/// Reads start.file with columns x, y, traction_x and traction_y, and warns of points outside.
/// \param contact  at the start, over that of the bound
/// \return on the bound's own shape
TractionTable read_start_tractions(Scene& scene, const PatchBound& bound,
                                   const ContactScale& contact);

}  // namespace microslip
