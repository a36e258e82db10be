// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels, their moments and influence coefficients from the thesis's closed forms in many digits:
// an independent path to the values that the library integrates in double precision.
#pragma once

#include <array>
#include <boost/math/constants/constants.hpp>
#include <vector>

#include "digits/worst_case.hpp"
#include "microslip/halfspace/kernel.hpp"
#include "microslip/halfspace/shape_function.hpp"

namespace microslip::test {

template <class Digits>
struct ReferenceKernel {
  Digits nu;
  Digits width;  ///< Dy; 0 for plane strain
  Digits length = 1;
  Digits shear_modulus = 1;

  Digits log_factor() const { return factor() * (1 - nu); }

  /// Thesis (10.3), (10.4)
  Digits displacement(const Digits& z) const {
    if (width == 0) return -log_factor() * log(z / length);
    const Digits b = width / 2;
    return log_factor() * asinh(b / z) + factor() * nu * b / sqrt(z * z + b * b);
  }

  /// -dK/dz by differences, to 75 of 100 digits
  Digits decay(const Digits& z) const {
    const Digits h = z * Digits("1e-20");
    const auto rise = [&](int steps) {
      return Digits(displacement(z + steps * h) - displacement(z - steps * h));
    };
    return (rise(2) - 8 * rise(1)) / (12 * h);
  }

  /// Antiderivatives of K(z), K(z) z and K(z) z^2: (6.20)-(6.23), (B.25), (B.28), in units of 1/G;
  /// the limit where z = 0.
  std::array<Digits, 3> moments(const Digits& z) const {
    if (width == 0) {
      if (z == 0) return {0, 0, 0};
      const Digits logarithm = log(abs(z) / length);
      std::array<Digits, 3> all;
      Digits power = 1;
      for (int n = 0; n < 3; ++n) {
        power *= z;
        all[static_cast<std::size_t>(n)] =
            -log_factor() * power / (n + 1) * (logarithm - Digits(1) / (n + 1));
      }
      return all;
    }
    const Digits b = width / 2;
    const Digits r = sqrt(z * z + b * b);
    const Digits along = z == 0 ? Digits(0) : Digits(asinh(b / abs(z)));
    const Digits across = asinh(z / b);
    const std::array<Digits, 3> plain = {
        z * along + b * across, (z * z * along + b * r) / 2,
        (-b * b * b * across + 2 * z * z * z * along + z * b * r) / 6};
    const std::array<Digits, 3> poisson = {b * across, b * r,
                                           (-b * b * b * across + z * b * r) / 2};
    std::array<Digits, 3> all;
    for (std::size_t k = 0; k < 3; ++k) all[k] = factor() * ((1 - nu) * plain[k] + nu * poisson[k]);
    return all;
  }

 private:
  Digits factor() const { return 2 / (boost::math::constants::pi<Digits>() * shear_modulus); }
};

/// \param width, length  0 for the other kind
inline Kernel kernel_of(const Material& material, double width, double length = 1) {
  if (width == 0) return PlaneKernel(material, length);
  return StripKernel(material, width);
}

/// Influence coefficients of a function; all lengths in units of dx.
template <class Digits>
class ReferenceInfluence {
 public:
  ReferenceInfluence(const ReferenceKernel<Digits>& kernel, const ShapeFunction& shape)
      : kernel_(kernel), pieces_(shape.pieces().begin(), shape.pieces().end()) {}

  /// Integral of K(x - s) shape(s), thesis (6.28), (B.29) with z = x - s.
  Digits operator()(const Digits& x) const {
    Digits sum = 0;
    for (const auto& [begin, end, c] : pieces_) {
      const Digits a0 = c[0] + c[1] * x + c[2] * x * x;
      const Digits a1 = -c[1] - 2 * c[2] * x;
      const auto at = [&](const Digits& z) {
        const auto m = kernel_.moments(z);
        return Digits(a0 * m[0] + a1 * m[1] + c[2] * m[2]);
      };
      sum += at(x - begin) - at(x - end);
    }
    return sum;
  }

 private:
  ReferenceKernel<Digits> kernel_;
  std::vector<ShapeFunction::Piece> pieces_;
};

}  // namespace microslip::test
