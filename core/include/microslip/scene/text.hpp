// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace microslip {

/// Bytes of a file as all readers take them: without the mark that some editors put in front of
/// UTF-8, and with lines that end in LF where they ended in CRLF.
/// \throws std::invalid_argument in one line, with the line's number, for UTF-16 and NUL bytes
std::string plain_text(std::string bytes);

/// The plain text of a file; what is larger than a table of the finest grid is none of ours.
/// \param most  of bytes, which also bounds what is read of a device or pipe without an end
/// \throws std::invalid_argument if it cannot be read, is larger, or is not text
std::string file_text(const std::string& path, std::size_t most = std::size_t{1} << 30);

}  // namespace microslip
