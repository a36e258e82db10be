// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace microslip {

/// A view of indices for v(index_view(indices)); Eigen does not copy it.
inline auto index_view(const std::vector<Eigen::Index>& indices) {
  using Indices = Eigen::Array<Eigen::Index, Eigen::Dynamic, 1>;
  return Eigen::Map<const Indices>(indices.data(), static_cast<Eigen::Index>(indices.size()));
}

}  // namespace microslip
