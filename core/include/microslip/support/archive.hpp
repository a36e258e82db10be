// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// Text form of objects' members, one line each: `name value value ...`. An object lists its
/// members once; the same calls write and read them. Floating-point numbers are hexadecimal, as
/// std::to_chars writes them, so that any machine reads back the same bits.
///
/// Errors of reading: std::invalid_argument, with one line that names the member. A number must be
/// finite and within its range.
class Archive {
 public:
  using Index = Eigen::Index;

  /// An archive that writes.
  Archive() = default;

  /// An archive that reads.
  /// \param text  written by another archive; the text must outlive this archive
  explicit Archive(std::string_view text) : rest_(text), reads_(true) {}

  bool reads() const { return reads_; }

  /// Whether the next line to be read is that of a member.
  bool next_is(std::string_view name) const {
    return rest_.substr(0, rest_.find_first_of(" \n")) == name;
  }

  /// The text written so far.
  const std::string& text() const { return text_; }

  void number(std::string_view name, double& value);
  void flag(std::string_view name, bool& value);

  /// \param least, most  the accepted range
  void whole(std::string_view name, Index& value, Index least, Index most);

  /// \param size  the number of values
  void numbers(std::string_view name, Eigen::VectorXd& values, Index size);

  /// A list of any length up to `most_size`, within a range.
  void wholes(std::string_view name, std::vector<Index>& values, Index most_size, Index least,
              Index most);

  // Values of the problem: they are written, and a reader must have the same ones.
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
  std::string_view rest_;  ///< still to be read
  std::string_view line_;  ///< rest of the current line
  std::string_view name_;  ///< name at the start of the current line
  bool reads_ = false;
};

}  // namespace microslip
