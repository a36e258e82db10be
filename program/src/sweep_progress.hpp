// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <string>

#include "microslip/support/progress.hpp"
#include "progress_line.hpp"

namespace microslip::program {

/// How far a sweep is, on a terminal: cases that are done, those without a solution, and how far
/// those are that run. For several threads at once.
class SweepProgress {
 public:
  /// \param done, failed, total  cases at the start; failed cases are done, too
  SweepProgress(const std::string& name, bool quiet, std::size_t done, std::size_t failed,
                std::size_t total);

  /// Returns the progress that a case reports to from its begin on.
  /// \param number  of the case, from 1
  Progress begin(std::size_t number);

  /// \param has_solution  of a case that has begun
  void end(std::size_t number, bool has_solution);

 private:
  void tell();

  ProgressLine line_;
  std::size_t done_, failed_, total_;
  std::map<std::size_t, double> running_;  ///< parts that are done, by the numbers of cases
  std::mutex mutex_;
};

}  // namespace microslip::program
