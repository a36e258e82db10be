// SPDX-License-Identifier: GPL-3.0-or-later
// Influence coefficients from the thesis's closed forms in 50 digits: an independent path to the
// values that the library integrates in double precision.
#pragma once

#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include "microslip/halfspace/shape_function.hpp"

namespace microslip::test {

using Digits50 = boost::multiprecision::cpp_bin_float_50;

struct ReferencePiece {
  Digits50 begin;
  Digits50 end;
  std::array<Digits50, 3> c;  ///< c0 + c1 s + c2 s^2
};

/// All lengths in units of dx; dx = 1, G = 1.
struct ReferenceInfluence {
  Digits50 nu;
  Digits50 width;  ///< Dy; 0 for plane strain
  Digits50 length = 1;
  std::vector<ReferencePiece> shape;

  /// Integral of K(x - s) shape(s), thesis (6.28), (B.29) with z = x - s.
  Digits50 operator()(const Digits50& x) const {
    Digits50 sum = 0;
    for (const ReferencePiece& piece : shape) {
      const Digits50 a0 = piece.c[0] + piece.c[1] * x + piece.c[2] * x * x;
      const Digits50 a1 = -piece.c[1] - 2 * piece.c[2] * x;
      const auto at = [&](const Digits50& z) {
        return a0 * moment(0, z) + a1 * moment(1, z) + piece.c[2] * moment(2, z);
      };
      sum += at(x - piece.begin) - at(x - piece.end);
    }
    return sum;
  }

  /// Antiderivative of K(z) z^n: (6.20)-(6.23), (B.25), (B.28); the limit 0 where z = 0.
  Digits50 moment(int n, const Digits50& z) const {
    using boost::multiprecision::abs, boost::multiprecision::asinh, boost::multiprecision::log,
        boost::multiprecision::pow, boost::multiprecision::sqrt;
    const Digits50 factor = 2 / boost::math::constants::pi<Digits50>();
    if (width == 0) {
      if (z == 0) return 0;
      const Digits50 power = pow(z, n + 1) / (n + 1);
      return -factor * (1 - nu) * power * (log(abs(z) / length) - Digits50(1) / (n + 1));
    }
    const Digits50 b = width / 2;
    const Digits50 r = sqrt(z * z + b * b);
    const Digits50 along = z == 0 ? Digits50(0) : Digits50(asinh(b / abs(z)));
    const Digits50 across = asinh(z / b);
    const std::array<Digits50, 3> plain = {
        z * along + b * across, (z * z * along + b * r) / 2,
        (-b * b * b * across + 2 * z * z * z * along + z * b * r) / 6};
    const std::array<Digits50, 3> poisson = {b * across, b * r,
                                             (-b * b * b * across + z * b * r) / 2};
    const auto k = static_cast<std::size_t>(n);
    return factor * ((1 - nu) * plain[k] + nu * poisson[k]);
  }
};

inline std::vector<ReferencePiece> reference_pieces(const ShapeFunction& shape) {
  std::vector<ReferencePiece> pieces;
  for (const auto& [begin, end, c] : shape.pieces()) {
    pieces.push_back({begin, end, {c[0], c[1], c[2]}});
  }
  return pieces;
}

}  // namespace microslip::test
