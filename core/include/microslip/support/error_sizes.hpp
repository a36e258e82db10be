// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace microslip {

/// The sizes of errors, and their statistics, which are nan without any.
class ErrorSizes {
 public:
  void add(double error);
  std::size_t count() const { return sizes_.size(); }

  /// The root of the mean square.
  double rms() const;

  /// The size that a share of the errors does not exceed; 1 gives the largest.
  double part(double share) const;

 private:
  std::vector<double> sizes_;
};

}  // namespace microslip
