// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "microslip/friction/sliding_field.hpp"
#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/kernel.hpp"
#include "slip_side.hpp"

namespace microslip {

/// A place by its distance from a row of a bound, so that a distance from that row keeps its
/// digits.
struct RowPlace {
  std::size_t row;
  double from;  ///< distance from the row, > 0 ahead of it  [mm]
};

/// A bound between its rows: the rows of a table, or the two edges of a smooth bound. Rows where
/// the bound is zero on their outer side are left out, so that the first and the last row are the
/// ends of the loaded contact.
class BoundRows {
 public:
  explicit BoundRows(const TractionBound& bound);

  std::size_t size() const { return x_.size(); }
  double x(std::size_t row) const { return x_[row]; }          ///< [mm]
  double value(std::size_t row) const { return value_[row]; }  ///< [N/mm^2]
  bool smooth() const { return edges_.has_value(); }
  double half_width() const { return half_width_; }

  double position(const RowPlace& place) const { return x_[place.row] + place.from; }
  RowPlace place_of(double x) const;

  /// The signed distance of b ahead of a  [mm]
  double distance(const RowPlace& a, const RowPlace& b) const {
    return (x_[b.row] - x_[a.row]) + (b.from - a.from);
  }

  /// g in the piece ahead of a row.
  /// \param behind, ahead  distances from the two ends of the piece  [mm]
  double between(std::size_t row, double behind, double ahead) const;

  double bound(const RowPlace& place) const;

  /// Returns the row behind the piece that holds a place, or behind the nearest piece.
  std::size_t piece_of(const RowPlace& place) const;

  /// Whether the bound is zero in the piece ahead of a row.
  bool is_gap(std::size_t row) const {
    return !smooth() && value_[row] == 0 && value_[row + 1] == 0;
  }

  double slope(std::size_t row) const { return slope_[row]; }  ///< of the piece ahead of a row

  /// The principal value of the integral of g(t)/(x - t), in a table.
  double sliding_transform(const RowPlace& place) const;

  /// The integral of g(t) ln|x - t|, in a table.
  double sliding_potential(double x) const;

 private:
  struct Edges {
    SidedBound trailing, leading;
  };

  double half_width_;
  std::vector<double> x_, value_, slope_;
  std::optional<Edges> edges_;
};

}  // namespace microslip
