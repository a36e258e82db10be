// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "microslip/patch/patch_response.hpp"

namespace microslip {

/// Divides the matrices of a patch that is its own mirror image in y. Tractions of one part have
/// longitudinal components that are even in y and lateral ones that are odd; those of the other part
/// are the other way round. Each part has half of the unknowns, so that both are inverted in a
/// quarter of the time. A vector of 2n values has the longitudinal parts of n cells, then the
/// lateral ones.
class MirrorParts {
 public:
  explicit MirrorParts(const JoinedRows& rows);

  /// Tells whether a 2n x 2n matrix is its own mirror image but for rounding: it maps the tractions
  /// of each part to slip of the same part.
  bool apply_to(const Eigen::MatrixXd& matrix) const;

  /// Makes the matrix of one part, in an orthonormal basis.
  /// \param part  0 or 1
  Eigen::MatrixXd part_of(const Eigen::MatrixXd& matrix, std::size_t part) const;

  /// Makes the 2n x 2n matrix of which these are the parts.
  PatchResponse::Matrix joined(const std::array<Eigen::MatrixXd, 2>& parts) const;

 private:
  /// A cell's component and its image, which has the same value times a sign. A cell of the middle
  /// row is its own image.
  struct Unknown {
    Eigen::Index here, image;
    double sign;

    bool is_own_image() const { return here == image; }
  };

  std::array<std::vector<Unknown>, 2> unknowns_;
  Eigen::Index size_;
  std::vector<Eigen::Index> images_;  ///< of all components of cells
};

}  // namespace microslip
