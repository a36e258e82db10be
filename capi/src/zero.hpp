// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace microslip::capi {

/// The same number, and 0 for -0, which would be printed with its sign.
inline double without_sign_of_zero(double value) { return value + 0.0; }

}  // namespace microslip::capi
