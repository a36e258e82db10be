// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace microslip {

/// Why a shear modulus is doubtful: no solid has one above 1e6 N/mm^2, and it may have another unit.
/// \param shear_modulus  > 0  [N/mm^2]
/// \return empty if there is no doubt
std::string doubt_of_modulus(double shear_modulus);

/// Why the largest traction is doubtful beside a shear modulus: strains above 0.05 are not small, and
/// one of the two may have another unit. Moduli below 10 N/mm^2 are those of rubber, or normalised:
/// there is no doubt then, and none where the modulus itself is doubtful.
/// \param traction       > 0  [N/mm^2]
/// \param shear_modulus  > 0  [N/mm^2]
/// \return empty if there is no doubt
std::string doubt_of_strain(double traction, double shear_modulus);

}  // namespace microslip
