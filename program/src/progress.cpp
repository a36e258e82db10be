// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

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
  std::ostringstream text;
  text << std::setfill('0');
  if (whole >= 3600) {
    text << whole / 3600 << " h " << std::setw(2) << whole % 3600 / 60 << " min";
  } else if (whole >= 60) {
    text << whole / 60 << " min " << std::setw(2) << whole % 60 << " s";
  } else {
    text << whole << " s";
  }
  return text.str();
}

/// A line on a terminal that is written again and again, and ends with its life.
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
    std::ostringstream text;
    const double seconds = Seconds(now - first_->time).count();
    const double rate = static_cast<double>(done - first_->done) / seconds;
    if (total == unknown_total) return duration(Seconds(now - start_).count()) + " so far";
    text << done << " of " << total;
    if (done == total) {
      text << " in " << duration(Seconds(now - start_).count());
    } else if (seconds > 0 && rate > 0) {
      text << ", " << (rate < 100 ? std::defaultfloat : std::fixed)
           << std::setprecision(rate < 100 ? 2 : 0) << rate << " a second, "
           << duration(static_cast<double>(total - done) / rate) << " left";
    }
    return text.str();
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
