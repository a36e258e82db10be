// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/error_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace microslip {

void ErrorSizes::add(double error) { sizes_.push_back(std::abs(error)); }

double ErrorSizes::rms() const {
  double squares = 0;
  for (const double size : sizes_) squares += size * size;
  return std::sqrt(squares / static_cast<double>(sizes_.size()));
}

double ErrorSizes::part(double share) const {
  if (sizes_.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> sorted = sizes_;
  const auto at = static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1));
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(at));
  return sorted[at];
}

}  // namespace microslip
