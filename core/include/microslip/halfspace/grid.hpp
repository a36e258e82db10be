// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>

namespace microslip {

/// Uniform nodes x_1 < ... < x_N in a contact [-a, a]; the leading edge is x = +a. The edges lie
/// trailing_offset dx beyond the first node and leading_offset dx beyond the last one, so that the
/// spacing is dx = 2a / (N - 1 + trailing_offset + leading_offset). With both offsets 1/2, the
/// nodes are the centres of N elements that fill the contact.
class Grid {
 public:
  /// Width, number of nodes and offsets.
  struct Parameters {
    double half_width;             ///< a, in (0, inf)  [mm]
    Eigen::Index elements;         ///< N, in [1, 4e6]
    double leading_offset = 0.5;   ///< last node to leading edge, in [0, 1]  [dx]
    double trailing_offset = 0.5;  ///< trailing edge to first node, in [0, 1]  [dx]
  };

  /// More elements would take several GB, even by FFT.
  static constexpr Eigen::Index max_elements = 4000000;

  /// \throws std::invalid_argument outside the ranges, or if the only node lies on both edges
  explicit Grid(const Parameters& parameters);

  Eigen::Index size() const { return parameters_.elements; }
  double half_width() const { return parameters_.half_width; }
  double spacing() const { return spacing_; }
  double leading_offset() const { return parameters_.leading_offset; }
  double trailing_offset() const { return parameters_.trailing_offset; }

  /// The same contact and offsets with another number of nodes.
  Grid with_elements(Eigen::Index elements) const;

  /// Positions of the nodes, ascending  [mm].
  Eigen::VectorXd nodes() const;

 private:
  Parameters parameters_;
  double spacing_;
};

/// \param fewest  the least number of elements
/// \param where   for the message: the name of the scheme that requires elements that fill the
///                contact
/// \throws std::invalid_argument for offsets other than 1/2, or fewer elements
void require_filling(const Grid& grid, Eigen::Index fewest, const std::string& where);

}  // namespace microslip
