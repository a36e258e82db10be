// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_progress.hpp"

#include <fmt/core.h>

#include <cmath>

namespace microslip::program {

namespace {

/// The largest number of running cases that fit on the line.
constexpr std::size_t most_shown = 2;

}  // namespace

SweepProgress::SweepProgress(const std::string& name, bool quiet, std::size_t done,
                             std::size_t failed, std::size_t total)
    : line_(name, quiet), done_(done), failed_(failed), total_(total) {
  tell();
}

Progress SweepProgress::begin(std::size_t number) {
  {
    const std::lock_guard lock(mutex_);
    running_[number] = 0;
  }
  return [this, number](std::size_t done, std::size_t total) {
    const std::lock_guard lock(mutex_);
    if (total == unknown_total || done >= total) return;
    running_[number] = static_cast<double>(done) / static_cast<double>(total);
    if (line_.wants_one()) tell();
  };
}

void SweepProgress::end(std::size_t number, bool has_solution) {
  const std::lock_guard lock(mutex_);
  running_.erase(number);
  ++done_;
  if (!has_solution) ++failed_;
  tell();
}

void SweepProgress::tell() {
  auto done = static_cast<double>(done_);
  std::string behind;
  if (failed_ > 0) behind += fmt::format("; {} without a solution", failed_);
  std::size_t shown = 0;
  for (const auto& [number, part] : running_) {
    done += part;
    if (shown++ >= most_shown) continue;
    behind += fmt::format("{}{} at {:.0f} %", shown == 1 ? "; case " : ", ", number,
                          std::floor(100 * part));
  }
  line_.tell(done, total_, behind);
}

}  // namespace microslip::program
