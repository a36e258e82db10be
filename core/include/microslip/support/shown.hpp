// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace microslip {

/// A text of unknown origin in a form for messages, on one line: control characters and bytes that
/// are not UTF-8 become `\xNN`. A text of more than `most` bytes is cut, and its length is
/// appended.
std::string shown(std::string_view text, std::size_t most = 160);

}  // namespace microslip
