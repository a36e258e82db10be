// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace microslip {

/// A text of someone else's as messages show it, in one line of a bounded length: control
/// characters and bytes that are not UTF-8 are written as `\xNN`, and what takes more than `most`
/// bytes then is cut, with its length behind.
std::string shown(std::string_view text, std::size_t most = 160);

}  // namespace microslip
