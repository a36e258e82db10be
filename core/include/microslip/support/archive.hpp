// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// Members of objects as a text, a line each: `name value value ...`. An object lists its members
/// once, and the same calls write and read them. Floating-point numbers are hexadecimal, as
/// std::to_chars writes them, so that they come back to the bit on any machine.
///
/// Errors of reading: std::invalid_argument, with one line that names the member. A number is read
/// only if it is finite and within its range.
class Archive {
 public:
  using Index = Eigen::Index;

  /// Writes.
  Archive() = default;

  /// Reads.
  /// \param text  that another archive wrote; it must outlive this one
  explicit Archive(std::string_view text) : rest_(text), reads_(true) {}

  bool reads() const { return reads_; }

  /// The text that was written.
  const std::string& text() const { return text_; }

  void number(std::string_view name, double& value);
  void flag(std::string_view name, bool& value);

  /// \param least, most  the range that is read
  void whole(std::string_view name, Index& value, Index least, Index most);

  /// \param size  of the values
  void numbers(std::string_view name, Eigen::VectorXd& values, Index size);

  /// A list of any length up to `most_size`, within a range.
  void wholes(std::string_view name, std::vector<Index>& values, Index most_size, Index least,
              Index most);

  // Values of the problem are written, and have to be the same where they are read.
  void same(std::string_view name, double value);
  void same(std::string_view name, std::string_view word);
  void same(std::string_view name, const Eigen::VectorXd& values);

  /// \throws std::invalid_argument unless all lines have been read
  void require_end() const;

 private:
  void begin_line(std::string_view name);
  void end_line();
  std::string_view next_word();
  void put(double value);
  void put(Index value);
  double next_number();
  Index next_whole(Index least, Index most);
  void fail(std::string_view expected) const;

  std::string text_;
  std::string_view rest_;  ///< to be read
  std::string_view line_;  ///< its rest
  std::string_view name_;  ///< of the line
  bool reads_ = false;
};

}  // namespace microslip
