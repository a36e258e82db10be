// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace microslip {

/// FNV-1a of 64 bits, in hexadecimal digits.
std::string checksum(const std::string& text);

}  // namespace microslip
