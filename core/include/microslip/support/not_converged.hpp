// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace microslip {

/// Error of a solve that failed; executables report it and return 2.
class NotConverged : public std::runtime_error {
 public:
  /// \param what        what failed; with its own numbers if there were no iterations
  /// \param iterations  number of them; from 1 on, the message names it and the residual
  /// \param residual    largest violation of the contact conditions, relative to the largest bound
  ///                    or slip
  NotConverged(const std::string& what, int iterations, double residual);

  int iterations() const { return iterations_; }
  double residual() const { return residual_; }

 private:
  int iterations_;
  double residual_;
};

}  // namespace microslip
