// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/shown.hpp"

#include <fmt/core.h>

#include <boost/locale/utf.hpp>

namespace microslip {

namespace {

std::string escaped(std::string_view bytes) {
  std::string all;
  for (const char byte : bytes) all += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
  return all;
}

bool is_printable(boost::locale::utf::code_point point) {
  namespace utf = boost::locale::utf;
  const bool is_control = point < 0x20 || (point >= 0x7f && point < 0xa0);
  const bool ends_a_line = point == 0x2028 || point == 0x2029;
  return point != utf::illegal && point != utf::incomplete && !is_control && !ends_a_line;
}

}  // namespace

std::string shown(std::string_view text, std::size_t most) {
  std::string all;
  for (auto at = text.begin(); at != text.end();) {
    if (all.size() >= most) {
      return fmt::format("{}... ({} characters)", all, text.size());
    }
    const auto begin = at;
    const auto point = boost::locale::utf::utf_traits<char>::decode(at, text.end());
    if (point == boost::locale::utf::illegal) at = begin + 1;  // the bytes that follow may be valid
    const std::string_view bytes(begin, at);
    all += is_printable(point) ? std::string(bytes) : escaped(bytes);
  }
  return all;
}

}  // namespace microslip
