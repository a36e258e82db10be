// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>

#include "command_line.hpp"
#include "progress_line.hpp"

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

}  // namespace

ProgressLine::ProgressLine(std::string name, bool quiet)
    : name_(std::move(name)), start_(Clock::now()), off_(quiet || isatty(STDERR_FILENO) == 0) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::cerr << std::endl;
}

bool ProgressLine::wants_one() const {
  const auto now = Clock::now();
  return !off_ && now - start_ >= patience && !(shown_ && now - *shown_ < between);
}

void ProgressLine::tell(double done, std::size_t total, const std::string& behind) {
  if (off_) return;
  const auto now = Clock::now();
  if (!first_) first_ = {now, done};
  const bool is_last = done == static_cast<double>(total);
  if (!wants_one() && (!is_last || now - start_ < patience)) return;
  shown_ = now;
  std::cerr << '\r' << name_ << ": " << line(done, total, now) << behind << "\x1b[K" << std::flush;
}

std::string ProgressLine::line(double done, std::size_t total, Clock::time_point now) const {
  const std::string taken = duration(Seconds(now - start_).count());
  if (total == unknown_total) return taken + " so far";
  const auto whole = static_cast<std::size_t>(done);
  if (whole == total) return fmt::format("{} of {} in {}", whole, total, taken);
  const double seconds = Seconds(now - first_->time).count();
  const double rate = (done - first_->done) / seconds;
  if (!(seconds > 0 && rate > 0)) return fmt::format("{} of {}", whole, total);
  return fmt::format("{} of {}, {} a second, {} left", whole, total,
                     rate < 100 ? fmt::format("{:.2g}", rate) : fmt::format("{:.0f}", rate),
                     duration((static_cast<double>(total) - done) / rate));
}

Progress progress_on_terminal(const std::string& name, bool quiet) {
  return [line = std::make_shared<ProgressLine>(name, quiet)](std::size_t done, std::size_t total) {
    line->tell(static_cast<double>(done), total);
  };
}

}  // namespace microslip::program
