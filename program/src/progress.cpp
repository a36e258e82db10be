// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>

#include "command_line.hpp"

namespace microslip::program {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds patience{2};
constexpr Seconds between{0.2};

/// "1 h 02 min", "3 min 20 s", "12 s"
std::string duration(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole >= 3600) return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
  if (whole >= 60) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} s", whole);
}

/// A line on a terminal that is rewritten again and again, and ends with the object.
class ProgressLine {
 public:
  explicit ProgressLine(std::string name) : name_(std::move(name)), start_(Clock::now()) {}
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() {
    if (shown_) std::cerr << std::endl;
  }

  void tell(std::size_t done, std::size_t total) {
    const auto now = Clock::now();
    if (!first_) first_ = {now, done};
    if (now - start_ < patience || (shown_ && now - *shown_ < between && done != total)) return;
    shown_ = now;
    std::cerr << '\r' << name_ << ": " << line(done, total, now) << "\x1b[K" << std::flush;
  }

 private:
  struct Mark {
    Clock::time_point time;
    std::size_t done;
  };

  std::string line(std::size_t done, std::size_t total, Clock::time_point now) const {
    const std::string taken = duration(Seconds(now - start_).count());
    if (total == unknown_total) return taken + " so far";
    if (done == total) return fmt::format("{} of {} in {}", done, total, taken);
    const double seconds = Seconds(now - first_->time).count();
    const double rate = static_cast<double>(done - first_->done) / seconds;
    if (!(seconds > 0 && rate > 0)) return fmt::format("{} of {}", done, total);
    return fmt::format("{} of {}, {} a second, {} left", done, total,
                       rate < 100 ? fmt::format("{:.2g}", rate) : fmt::format("{:.0f}", rate),
                       duration(static_cast<double>(total - done) / rate));
  }

  std::string name_;
  Clock::time_point start_;
  std::optional<Mark> first_;
  std::optional<Clock::time_point> shown_;
};

}  // namespace

Progress progress_on_terminal(const std::string& name, bool quiet) {
  if (quiet || isatty(STDERR_FILENO) == 0) return [](std::size_t, std::size_t) {};
  return [line = std::make_shared<ProgressLine>(name)](std::size_t done, std::size_t total) {
    line->tell(done, total);
  };
}

}  // namespace microslip::program
