// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/archive.hpp"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "microslip/support/format.hpp"
#include "microslip/support/shown.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Removes the text up to a mark, and the mark, from the front. \return that text without the mark
std::string_view take_until(std::string_view& text, char mark) {
  const std::size_t end = text.find(mark);
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return taken;
}

/// Reads a word as a number; false if the word as a whole is not a number.
template <class Number, class... Style>
bool is_number(std::string_view word, Number& value, Style... style) {
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value, style...);
  return result.ec == std::errc() && result.ptr == end;
}

template <class Number, class... Style>
void append(std::string& text, Number value, Style... style) {
  std::array<char, 64> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, style...).ptr;
  text += ' ';
  text.append(digits.data(), end);
}

}  // namespace

void Archive::fail(std::string_view expected) const {
  throw std::invalid_argument(fmt::format("'{}': expected {}", name_, expected));
}

void Archive::begin_line(std::string_view name) {
  name_ = name;
  if (!reads_) {
    text_ += name;
    return;
  }
  line_ = take_until(rest_, '\n');
  const std::string_view found = take_until(line_, ' ');
  if (found != name) fail(fmt::format("a line of it, not of '{}'", shown(found)));
}

void Archive::end_line() {
  if (!reads_) {
    text_ += '\n';
  } else if (!line_.empty()) {
    fail("fewer values");
  }
}

std::string_view Archive::next_word() {
  if (line_.empty()) fail("more values");
  return take_until(line_, ' ');
}

void Archive::put(double value) {
  if (!std::isfinite(value)) throw std::logic_error(fmt::format("{} is not finite", name_));
  append(text_, value, std::chars_format::hex);
}

void Archive::put(Index value) { append(text_, value); }

double Archive::next_number() {
  double value = 0;
  if (!is_number(next_word(), value, std::chars_format::hex) || !std::isfinite(value)) {
    fail("finite hexadecimal numbers");
  }
  return value;
}

Index Archive::next_whole(Index least, Index most) {
  Index value = 0;
  if (!is_number(next_word(), value) || value < least || value > most) {
    fail(fmt::format("whole numbers from {} to {}", least, most));
  }
  return value;
}

void Archive::number(std::string_view name, double& value) {
  begin_line(name);
  if (reads_) {
    value = next_number();
  } else {
    put(value);
  }
  end_line();
}

void Archive::whole(std::string_view name, Index& value, Index least, Index most) {
  begin_line(name);
  if (reads_) {
    value = next_whole(least, most);
  } else {
    put(value);
  }
  end_line();
}

void Archive::flag(std::string_view name, bool& value) {
  Index number = value ? 1 : 0;
  whole(name, number, 0, 1);
  value = number == 1;
}

void Archive::numbers(std::string_view name, VectorXd& values, Index size) {
  begin_line(name);
  if (reads_) values.resize(size);
  for (double& value : values) {
    if (reads_) {
      value = next_number();
    } else {
      put(value);
    }
  }
  end_line();
}

void Archive::wholes(std::string_view name, std::vector<Index>& values, Index most_size,
                     Index least, Index most) {
  begin_line(name);
  if (reads_) {
    values.clear();
    while (!line_.empty()) {
      if (static_cast<Index>(values.size()) == most_size) fail("fewer values");
      values.push_back(next_whole(least, most));
    }
  } else {
    for (const Index value : values) put(value);
  }
  end_line();
}

void Archive::same(std::string_view name, double value) {
  double saved = value;
  number(name, saved);
  if (saved == value) return;
  throw std::invalid_argument(fmt::format("{} = {}: expected {}, as where the state was saved",
                                          name, format_short(value), format_short(saved)));
}

void Archive::same(std::string_view name, std::string_view word) {
  begin_line(name);
  if (!reads_) {
    text_ += ' ';
    text_ += word;
  } else if (const std::string_view saved = next_word(); saved != word) {
    throw std::invalid_argument(fmt::format(
        "{} = '{}': expected '{}', as where the state was saved", name, word, shown(saved)));
  }
  end_line();
}

void Archive::same(std::string_view name, const VectorXd& values) {
  VectorXd saved = values;
  numbers(name, saved, values.size());
  for (Index i = 0; i < values.size(); ++i) {
    if (saved[i] == values[i]) continue;
    throw std::invalid_argument(
        fmt::format("{} of element {} = {}: expected {}, as where the state was saved", name, i + 1,
                    format_short(values[i]), format_short(saved[i])));
  }
}

void Archive::require_end() const {
  if (!rest_.empty()) throw std::invalid_argument("expected no more lines");
}

}  // namespace microslip
