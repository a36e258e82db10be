// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace microslip {

/// Bytes of a file in the form that all readers expect: without the byte order mark that some
/// editors put in front of UTF-8, and with LF for CRLF at the end of lines.
/// \throws std::invalid_argument in one line, with the line's number, for UTF-16 and NUL bytes
std::string plain_text(std::string bytes);

/// The plain text of a file. The default limit is the size of a table of the finest grid.
/// \param most  the largest number of bytes; also for a device or pipe without an end
/// \throws std::invalid_argument if the file cannot be read, is larger, or is not text
std::string file_text(const std::string& path, std::size_t most = std::size_t{1} << 30);

}  // namespace microslip
