// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace microslip {

/// The shortest decimal that reads back as the same double; for messages and parameter lists.
std::string format_short(double value);

/// Two digits, for estimates in messages.
std::string format_roughly(double value);

/// "%.17g", independent of the locale; for table cells.
std::string format_full(double value);

}  // namespace microslip
