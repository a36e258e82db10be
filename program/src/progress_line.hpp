// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "microslip/support/progress.hpp"

namespace microslip::program {

/// A line on a terminal that is written again and again after two seconds, with rate and remaining
/// time, and ends with its life. Nothing where standard error is no terminal.
class ProgressLine {
 public:
  /// \param quiet  nothing at all
  ProgressLine(std::string name, bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Whether it would be written now.
  bool wants_one() const;

  /// \param done    with parts of the cases that have begun
  /// \param total   or unknown_total
  /// \param behind  what else there is to say
  void tell(double done, std::size_t total, const std::string& behind = "");

 private:
  using Clock = std::chrono::steady_clock;
  struct Mark {
    Clock::time_point time;
    double done;
  };
  std::string line(double done, std::size_t total, Clock::time_point now) const;

  std::string name_;
  Clock::time_point start_;
  bool off_;
  std::optional<Mark> first_;
  std::optional<Clock::time_point> shown_;
};

}  // namespace microslip::program
