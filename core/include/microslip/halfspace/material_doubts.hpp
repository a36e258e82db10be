// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace microslip {

/// Why a shear modulus is doubtful: no solid has one above 1e6 N/mm^2, and it may have another unit.
/// \param shear_modulus  > 0  [N/mm^2]
/// \param traction       largest one; if it is large as well, numbers are normalised  [N/mm^2]
/// \return empty if there is no doubt
std::string doubt_of_modulus(double shear_modulus, double traction = 0);

/// Why the largest traction is doubtful beside a shear modulus: strains above 0.05 are not small, and
/// one of the two may have another unit. There is no doubt of moduli below 10 and above 1e6 N/mm^2:
/// rubber has 1, and others are normalised.
/// \param traction       > 0  [N/mm^2]
/// \param shear_modulus  > 0  [N/mm^2]
/// \return empty if there is no doubt
std::string doubt_of_strain(double traction, double shear_modulus);

}  // namespace microslip
