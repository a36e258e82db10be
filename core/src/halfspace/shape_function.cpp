// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/shape_function.hpp"

#include <algorithm>
#include <utility>

namespace microslip {

namespace {

double polynomial(const ShapeFunction::Piece& piece, double s) {
  return piece.c[0] + s * (piece.c[1] + s * piece.c[2]);
}

/// The midpoint value plus the second-derivative term are exact for degree <= 3.
double integral_within(const ShapeFunction::Piece& piece, double middle, double length) {
  return length * (polynomial(piece, middle) + piece.c[2] * length * length / 12);
}

}  // namespace

ShapeFunction::ShapeFunction(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {
  for (const Piece& piece : pieces_) {
    breakpoints_.push_back(piece.begin);
    breakpoints_.push_back(piece.end);
  }
  const auto repeats = std::unique(breakpoints_.begin(), breakpoints_.end());
  breakpoints_.erase(repeats, breakpoints_.end());
}

double ShapeFunction::value(double s) const {
  for (const Piece& piece : pieces_) {
    if (s >= piece.begin && s < piece.end) return polynomial(piece, s);
  }
  return 0;
}

double ShapeFunction::integral(double from, double length) const {
  const double to = from + length;
  double sum = 0;
  for (const Piece& piece : pieces_) {
    if (from >= piece.begin && to <= piece.end) {
      return integral_within(piece, from + length / 2, length);
    }
    const double begin = std::max(from, piece.begin);
    const double end = std::min(to, piece.end);
    if (begin < end) sum += integral_within(piece, begin + (end - begin) / 2, end - begin);
  }
  return sum;
}

const ShapeFunction::Piece* ShapeFunction::piece_over(double from, double to) const {
  for (const Piece& piece : pieces_) {
    if (from >= piece.begin && to <= piece.end) return &piece;
  }
  return nullptr;
}

ShapeFunction ShapeFunction::about(double origin) const {
  std::vector<Piece> moved = pieces_;
  for (Piece& piece : moved) {
    const double slope = piece.c[1] + 2 * piece.c[2] * origin;
    piece = {
        piece.begin - origin, piece.end - origin, {polynomial(piece, origin), slope, piece.c[2]}};
  }
  return ShapeFunction(std::move(moved));
}

double ShapeFunction::weight() const {
  return integral(breakpoints_.front(), breakpoints_.back() - breakpoints_.front());
}

bool ShapeFunction::is_even() const {
  const auto mirrored = [](const Piece& piece, const Piece& other) {
    return piece.begin == -other.end && piece.end == -other.begin && piece.c[0] == other.c[0] &&
           piece.c[1] == -other.c[1] && piece.c[2] == other.c[2];
  };
  return std::equal(pieces_.begin(), pieces_.end(), pieces_.rbegin(), mirrored);
}

ShapeFunction constant_shape() { return ShapeFunction({{-0.5, 0.5, {1, 0, 0}}}); }

ShapeFunction linear_shape() { return ShapeFunction({{-1, 0, {1, 1, 0}}, {0, 1, {1, -1, 0}}}); }

}  // namespace microslip
