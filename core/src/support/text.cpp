// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace microslip {

std::string plain_text(std::string bytes) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    throw std::invalid_argument("line 1: expected text in UTF-8, not UTF-16");
  }
  if (const std::size_t at = bytes.find('\0'); at != std::string::npos) {
    const auto line =
        std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    throw std::invalid_argument(
        fmt::format("line {}: expected text in UTF-8, not a NUL byte", line + 1));
  }
  if (bytes.starts_with(mark)) bytes.erase(0, mark.size());
  boost::algorithm::replace_all(bytes, "\r\n", "\n");
  return bytes;
}

std::string file_text(const std::string& path, std::size_t most) {
  std::ifstream in(path, std::ios::binary);
  std::string text;
  for (std::array<char, 1 << 16> part; in.read(part.data(), part.size()) || in.gcount() > 0;) {
    text.append(part.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > most) {
      throw std::invalid_argument(fmt::format("expected at most {} bytes", most));
    }
    if (text.find('\0', text.size() - static_cast<std::size_t>(in.gcount())) != std::string::npos) {
      break;  // not a text, whatever follows
    }
  }
  if (in.bad() || !in.is_open()) {
    throw std::invalid_argument(fmt::format("cannot read it: {}", std::strerror(errno)));
  }
  return plain_text(std::move(text));
}

}  // namespace microslip
