// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

namespace microslip {

/// The shortest decimal that reads back as the same double; for messages and parameter lists.
std::string format_short(double value);

/// Two digits, for estimates in messages.
std::string format_roughly(double value);

/// Two numbers with as few digits, two at least, as tell them apart: of a > b the first text is above
/// b, and the second one below a.
std::pair<std::string, std::string> format_apart(double a, double b);

/// A share in percent with two digits, or all of a whole number: "0.012 %", "120 %".
std::string format_percent(double share);

/// "%.17g", independent of the locale; for table cells.
std::string format_full(double value);

}  // namespace microslip
