// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/patch/patch_bound.hpp"

namespace microslip {

/// Tractions that are known at points of a patch, as a part of the bound.
///
/// Points of one y are a row, with s = (x - middle)/half-length. Within a row, 1 + s times the
/// tractions over the bound is linear, as it is where all slips, and nearly so where all sticks in
/// rolling. From row to row the tractions over the bound are linear along lines of equal s. Beyond the
/// outermost points and rows these functions stay as they are there. Order: 2 in the distance of points.
class TractionTable {
 public:
  /// \param x, y       coordinates, in any order; points outside the shape are left out  [mm]
  /// \param tractions  along and across. One above the bound is taken as the bound if it is above by
  ///                   1 % of the peak or less, as other grids have other bounds  [N/mm^2]
  /// \throws std::invalid_argument for tractions above the bound, and as BoundTable for points; the
  ///         message names the row, from 1 on, or the place
  TractionTable(const PatchBound& bound, const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                const Eigen::MatrixX2d& tractions);

  /// The traction over the bound at a place; one outside the shape has that of the next one inside.
  Eigen::Vector2d operator()(double x, double y) const;

  /// Points outside the shape, with tractions.
  Eigen::Index left_out() const { return left_out_; }

 private:
  struct Row {
    double y;
    std::vector<double> places;  ///< s, rising
    std::vector<Eigen::Vector2d> values;
  };

  static Eigen::Vector2d within(const Row& row, double s);
  Eigen::Vector2d in_lobe(std::size_t lobe, double s, double y) const;

  PatchShape shape_;
  std::vector<std::vector<Row>> lobes_;
  Eigen::Index left_out_ = 0;
};

}  // namespace microslip
