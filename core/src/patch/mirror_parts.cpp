// SPDX-License-Identifier: GPL-3.0-or-later
#include "mirror_parts.hpp"

#include <cmath>
#include <numbers>

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;

MirrorParts::MirrorParts(const JoinedRows& rows)
    : size_(2 * rows.cells()), images_(static_cast<std::size_t>(size_)) {
  for (std::size_t part = 0; part < 2; ++part) {
    for (std::size_t component = 0; component < 2; ++component) {
      const double sign = part == component ? 1 : -1;
      const Index first = static_cast<Index>(component) * rows.cells();
      const Index last = rows.rows() - 1;
      for (Index k = 0; 2 * k < last + (sign > 0 ? 1 : 0); ++k) {  // an odd middle row is zero
        for (Index i = 0; i < rows.elements(); ++i) {
          const Index here = first + rows.cell(i, k), image = first + rows.cell(i, last - k);
          unknowns_[part].push_back({here, image, sign});
          images_[static_cast<std::size_t>(here)] = image;
          images_[static_cast<std::size_t>(image)] = here;
        }
      }
    }
  }
}

bool MirrorParts::apply_to(const MatrixXd& matrix) const {
  constexpr double rounding = 1e-11;
  const double most = rounding * matrix.cwiseAbs().maxCoeff();
  const Index n = size_ / 2;
  for (Index from = 0; from < size_; ++from) {
    const Index image = images_[static_cast<std::size_t>(from)];
    for (Index to = 0; to < size_; ++to) {
      const double sign = (to < n) == (from < n) ? 1 : -1;
      const double other = sign * matrix(images_[static_cast<std::size_t>(to)], image);
      if (!(std::abs(matrix(to, from) - other) <= most)) return false;
    }
  }
  return true;
}

MatrixXd MirrorParts::part_of(const MatrixXd& matrix, std::size_t part) const {
  const std::vector<Unknown>& all = unknowns_[part];
  const auto n = static_cast<Index>(all.size());
  MatrixXd found(n, n);
  for (Index j = 0; j < n; ++j) {
    const Unknown& from = all[static_cast<std::size_t>(j)];
    for (Index i = 0; i < n; ++i) {
      const Unknown& to = all[static_cast<std::size_t>(i)];
      double value = matrix(to.here, from.here);
      if (!from.is_own_image()) value += from.sign * matrix(to.here, from.image);
      if (to.is_own_image() != from.is_own_image()) {
        value *= to.is_own_image() ? 1 / std::numbers::sqrt2 : std::numbers::sqrt2;
      }
      found(i, j) = value;
    }
  }
  return found;
}

PatchResponse::Matrix MirrorParts::joined(const std::array<MatrixXd, 2>& parts) const {
  PatchResponse::Matrix whole = PatchResponse::Matrix::Zero(size_, size_);
  for (std::size_t part = 0; part < 2; ++part) {
    const std::vector<Unknown>& all = unknowns_[part];
    const auto size_of = [](const Unknown& one) {
      return one.is_own_image() ? 1 : 1 / std::numbers::sqrt2;
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = 0; j < all.size(); ++j) {
        const Unknown &to = all[i], &from = all[j];
        const double value =
            size_of(to) * size_of(from) * parts[part](static_cast<Index>(i), static_cast<Index>(j));
        whole(to.here, from.here) += value;
        if (!from.is_own_image()) whole(to.here, from.image) += from.sign * value;
        if (to.is_own_image()) continue;
        whole(to.image, from.here) += to.sign * value;
        if (!from.is_own_image()) whole(to.image, from.image) += to.sign * from.sign * value;
      }
    }
  }
  return whole;
}

}  // namespace microslip
