// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/sealed_text.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "microslip/support/checksum.hpp"
#include "microslip/support/shown.hpp"

namespace microslip {

namespace {

constexpr std::string_view sum_mark = "checksum ";

std::string last_line(std::string_view text) {
  return std::string(sum_mark) + checksum(std::string(text)) + '\n';
}

}  // namespace

std::string SealedText::sealed(std::string_view members) const {
  const std::string text = fmt::format("{}{}\n{}", mark, version, members);
  return text + last_line(text);
}

std::string_view SealedText::members_of(std::string_view text) const {
  if (!text.starts_with(mark)) {
    throw std::invalid_argument(
        fmt::format("expected a state that microslip has saved, which begins with '{}'", mark));
  }
  const std::size_t end = text.find('\n');
  const std::string_view found = text.substr(mark.size(), end - mark.size());
  const std::size_t last = text.rfind(sum_mark);
  const bool is_whole = end != std::string_view::npos && last != std::string_view::npos &&
                        last > end && text.substr(last) == last_line(text.substr(0, last));
  if (!is_whole) {
    throw std::invalid_argument(
        "expected the whole state as it was saved; its checksum is missing or of another text");
  }
  if (found.find(' ') != std::string_view::npos) {
    throw std::invalid_argument(
        fmt::format("expected '{}{}' in the first line, not '{}{}', which is "
                    "a state of another kind of contact",
                    mark, version, mark, shown(found)));
  }
  if (found != version) {
    throw std::invalid_argument(
        fmt::format("version = '{}': expected {}, the version of this program's states",
                    shown(found), version));
  }
  return text.substr(end + 1, last - end - 1);
}

}  // namespace microslip
