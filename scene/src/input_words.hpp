// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// A number of an input file of CONTACT, and its line there.
struct InputNumber {
  double value = 0;
  int line = 0;
  std::string text = "";  ///< as in the file
};

/// Refuses a value: "file:line: name = value: expected accepted".
/// \throws std::invalid_argument
[[noreturn]] void refuse_input(const std::string& file, int line, std::string_view name,
                               std::string_view value, std::string_view accepted);

/// The words of an input file of CONTACT. Blanks, tabs, commas and equal signs separate them, % and
/// what follows it in a line is a comment. Numbers belong to groups: a group begins on a new line,
/// continues on the next ones until it is complete, and what is left of the last line is ignored.
class InputWords {
 public:
  InputWords(std::string_view text, std::string file) : rest_(text), file_(std::move(file)) {}

  /// Reads a group.
  /// \param names  of its numbers with blanks between them; # before a whole number, < before an
  ///               angle, which a d behind it makes one in degrees; [ before the first of those
  ///               that need not be there
  /// \return as many numbers as there are, in [rad]
  std::vector<InputNumber> group(const std::string& names);

  /// Reads a group of `count` numbers, which have one name.
  std::vector<InputNumber> numbers(const std::string& name, double count);

  /// Passes over a group of `count` words.
  void skip(const std::string& name, double count);

  int line() const { return line_; }  ///< that was read last
  const std::string& file() const { return file_; }

 private:
  /// Reads the next line that has words. \throws std::invalid_argument at the end of the file
  std::vector<std::string> next_line(const std::string& name);

  std::string_view rest_;
  std::string file_;
  int line_ = 0;
};

}  // namespace microslip
