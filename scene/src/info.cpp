// SPDX-License-Identifier: GPL-3.0-or-later
#include "info.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "microslip/scene/units.hpp"
#include "microslip/support/shown.hpp"
#include "number.hpp"

namespace microslip {

namespace {

constexpr std::string_view blank_characters = " \t\v\f\r";
constexpr std::string_view blanks_and_comment = " \t\v\f\r;";

constexpr std::string_view ends_words = "{}\";";

/// Largest number of words of a value with a unit; a longer line is not searched further.
constexpr std::size_t most_words = 16;

[[noreturn]] void fail(const std::string& what) { throw std::invalid_argument(what); }

std::string unescaped(std::string_view raw) {
  constexpr std::string_view letters("0abfnrtv\"'\\");
  constexpr std::string_view meant("\0\a\b\f\n\r\t\v\"'\\", letters.size());
  std::string text;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (raw[i] == '\\') {
      if (++i == raw.size()) fail("character expected after backslash");
      const std::size_t at = letters.find(raw[i]);
      if (at == std::string_view::npos) fail("unknown escape sequence");
      text += meant[at];
    } else {
      text += raw[i];
    }
  }
  return text;
}

/// The unread rest of a line.
class RestOfLine {
 public:
  explicit RestOfLine(std::string_view line) : text_(line) {}

  /// The next character that is not blank; at the end, a semicolon.
  char next() {
    text_.remove_prefix(std::min(text_.size(), text_.find_first_not_of(blank_characters)));
    return text_.empty() ? ';' : text_.front();
  }

  std::string_view all() const { return text_; }

  std::string_view take(std::size_t length) {
    const std::string_view taken = text_.substr(0, length);
    text_.remove_prefix(taken.size());
    return taken;
  }

  std::string_view word() { return take(text_.find_first_of(blanks_and_comment)); }

  /// A quoted text without its quotes.
  std::string_view quoted() {
    std::size_t end = 1;
    while (end < text_.size() && text_[end] != '"') end += text_[end] == '\\' ? 2 : 1;
    if (end >= text_.size()) fail("unexpected end of line");
    return take(end + 1).substr(1, end - 1);
  }

  /// A word; if the word is a number, with the following words that are its unit. A single word
  /// behind a number is taken as a unit.
  std::string_view word_with_unit() {
    const std::string_view from = text_;
    if (!finite_number(word())) return from.substr(0, from.size() - text_.size());
    RestOfLine behind = *this;
    std::vector<RestOfLine> ends{*this};
    while (ends.size() <= most_words && ends_words.find(behind.next()) == std::string_view::npos) {
      behind.word();
      ends.push_back(behind);
    }
    next();
    const auto unit_to = [&](const RestOfLine& end) {
      return text_.substr(0, text_.size() - end.text_.size());
    };
    std::size_t words = ends.size() - 1;
    while (words > 0 && !is_unit(unit_to(ends[words]))) --words;
    if (ends.size() == 2) words = 1;
    *this = ends[words];
    return from.substr(0, from.size() - text_.size());
  }

 private:
  std::string_view text_;
};

class InfoReader {
 public:
  std::vector<InfoEntry> read(std::string_view text) {
    for (line_ = 1; !text.empty(); ++line_) {
      const std::size_t end = std::min(text.size(), text.find('\n'));
      read_line(RestOfLine(text.substr(0, end)));
      text.remove_prefix(std::min(text.size(), end + 1));
    }
    if (!open_.empty()) {
      line_ = open_.back().line;
      fail("unmatched {");
    }
    return std::move(entries_);
  }

  /// Number of the current line, which is the wrong line after an error.
  int line() const { return line_; }

 private:
  struct Section {
    std::string key;
    std::size_t before;  ///< entries
    int line;
  };

  void read_line(RestOfLine rest) {
    if (rest.next() == '#') {
      fail(fmt::format("'{}': expected ; before comments, and no other files", shown(rest.all())));
    }
    wants_value_ = false;
    while (rest.next() != ';') {
      if (goes_on_) {
        if (rest.next() != '"') fail("expected \" after \\ in previous line");
        entries_.back().text += value(rest);
      } else if (rest.next() == '{') {
        rest.take(1);
        open_section();
      } else if (rest.next() == '}') {
        rest.take(1);
        close_section();
      } else if (wants_value_) {
        entries_.back().text = value(rest);
        wants_value_ = false;
      } else {
        add_key(unescaped(rest.next() == '"' ? rest.quoted() : rest.word()));
      }
    }
  }

  void add_key(const std::string& name) {
    const std::string key = open_.empty() ? name : open_.back().key + '.' + name;
    require_short(key);
    entries_.push_back({key, "", line_});
    may_open_ = wants_value_ = true;
  }

  std::string value(RestOfLine& rest) {
    if (rest.next() != '"') return unescaped(rest.word_with_unit());
    const std::string text = unescaped(rest.quoted());
    goes_on_ = rest.next() == '\\';
    if (goes_on_) {
      rest.take(1);
      if (rest.next() != ';') fail("expected end of line after \\");
    }
    return text;
  }

  void open_section() {
    if (!may_open_) fail("unexpected {");
    const InfoEntry& last = entries_.back();
    if (!last.text.empty()) {
      fail(fmt::format("key '{}' has both a value and keys below it", shown(last.key)));
    }
    open_.push_back({last.key, entries_.size() - 1, line_});
    entries_.pop_back();
    may_open_ = wants_value_ = false;
  }

  void close_section() {
    if (open_.empty()) fail("unmatched }");
    const Section& closed = open_.back();
    if (entries_.size() == closed.before) entries_.push_back({closed.key, "", closed.line});
    open_.pop_back();
    may_open_ = wants_value_ = false;
  }

  std::vector<InfoEntry> entries_;
  std::vector<Section> open_;
  bool may_open_ = false;     ///< whether the last key may open a section
  bool wants_value_ = false;  ///< whether the last key of this line has no value yet
  bool goes_on_ = false;      ///< whether the last value continues in the next line
  int line_ = 1;
};

}  // namespace

void require_short(const std::string& key) {
  if (key.size() <= longest_key) return;
  fail(fmt::format("key '{}': expected at most {} characters", shown(key), longest_key));
}

std::string place_in(const std::string& name, int line) {
  return fmt::format("{}:{}: ", shown(name), line);
}

std::vector<InfoEntry> read_info(const std::string& text, const std::string& name) {
  InfoReader reader;
  try {
    return reader.read(text);
  } catch (const std::invalid_argument& error) {
    fail(place_in(name, reader.line()) + error.what());
  }
}

}  // namespace microslip
