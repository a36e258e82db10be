// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/checksum.hpp"

#include <fmt/core.h>

#include <cstdint>

namespace microslip {

std::string checksum(const std::string& text) {
  constexpr std::uint64_t offset = 0xcbf29ce484222325;
  constexpr std::uint64_t prime = 0x100000001b3;
  std::uint64_t hash = offset;
  for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * prime;
  return fmt::format("{:016x}", hash);
}

}  // namespace microslip
