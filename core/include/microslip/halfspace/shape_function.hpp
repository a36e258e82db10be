// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

namespace microslip {

/// A traction function of unit size: a piecewise polynomial of degree <= 2 around its node, with
/// compact support. All lengths are in units of the grid spacing dx and relative to the node.
class ShapeFunction {
 public:
  /// c[0] + c[1] s + c[2] s^2 on [begin, end]
  struct Piece {
    double begin;
    double end;
    std::array<double, 3> c;

    bool operator==(const Piece&) const = default;
  };

  /// \param pieces  in ascending order; gaps between them count as zero
  explicit ShapeFunction(std::vector<Piece> pieces);

  std::span<const Piece> pieces() const { return pieces_; }

  /// Ends of the pieces, ascending, without repeats.
  std::span<const double> breakpoints() const { return breakpoints_; }

  bool operator==(const ShapeFunction&) const = default;

  /// Value at s; at a jump, the value of the piece to the right.
  double value(double s) const;

  /// Integral over [from, from + length], length >= 0: exact, and without cancellation for small
  /// lengths.
  double integral(double from, double length) const;

  /// The piece that covers [from, to]; null if there is none.
  const Piece* piece_over(double from, double to) const;

  /// The same function with positions counted from `origin`, so that positions and small values
  /// next to the origin keep their digits.
  ShapeFunction about(double origin) const;

  /// Integral over the whole support.
  double weight() const;

  /// Whether value(-s) = value(s), except at jumps.
  bool is_even() const;

 private:
  std::vector<Piece> pieces_;
  std::vector<double> breakpoints_;
};

/// 1 on one element around the node: thesis 2.7.
ShapeFunction constant_shape();

/// The hat over two elements: thesis (6.4).
ShapeFunction linear_shape();

}  // namespace microslip
