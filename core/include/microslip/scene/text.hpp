// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace microslip {

/// Bytes of a file as all readers take them: without the mark that some editors put in front of
/// UTF-8, and with lines that end in LF where they ended in CRLF.
/// \throws std::invalid_argument in one line, with the line's number, for UTF-16 and NUL bytes
std::string plain_text(std::string bytes);

}  // namespace microslip
