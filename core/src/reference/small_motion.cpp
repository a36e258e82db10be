// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/small_motion.hpp"

#include <algorithm>
#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "microslip/rolling/frequency_response.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using std::numbers::pi;
using Complex = std::complex<double>;

namespace {

/// The sum of c_n/z^n in Hankel's series for the Bessel functions of the given order, at |z| >= 40.
Complex hankel_series(int order, Complex z) {
  constexpr int terms = 16;
  Complex term = 1, sum = 1;
  for (int n = 1; n <= terms; ++n) {
    const double odd = 2 * n - 1;
    term *= (4 * order * order - odd * odd) / (8.0 * n * z);
    sum += term;
  }
  return sum;
}

/// The fraction (n0 + n1 e)/(d0 + d1 e) with e = exp(-2 s), expanded in powers of e.
struct Delays {
  Complex n0, n1, d0, d1;

  Complex power(int m) const {
    if (m == 0) return n0 / d0;
    return (n1 - n0 * d1 / d0) / d0 * std::pow(-d1 / d0, m - 1);
  }
};

/// The Bessel functions far from s = 0 in the upper half-plane, over exp(s)/(2 pi s)^1/2. They are
/// I0 = a + e b and I0 + I1 = c + e d.
struct Hankel {
  Complex a, b, c, d;

  explicit Hankel(Complex s)
      : a(hankel_series(0, -s)),
        b(Complex(0, 1) * hankel_series(0, s)),
        c(a + hankel_series(1, -s)),
        d(b - Complex(0, 1) * hankel_series(1, s)) {}
};

/// The inverse transform of F(s)/s, F(0) = 1.
/// \param far      distance from s = 0 at which the delays take over
/// \param panels   number of panels per unit length of the imaginary axis, for the oscillations of
///                 F
/// \param on_axis  F(i omega)
/// \param delays   F(s) as Delays
template <class OnAxis, class Delayed>
double inverse(double distance, double far, double panels, const OnAxis& on_axis,
               const Delayed& delays) {
  const auto along_axis = [&](double omega) {
    return std::real((on_axis(omega) - 1.0) / Complex(0, omega) *
                     std::polar(1.0, omega * distance));
  };
  const auto add = [&](double from, double to) {
    return boost::math::quadrature::gauss<double, 20>::integrate(along_axis, from, to);
  };
  const int count = static_cast<int>(std::ceil(far * (panels + distance / 8)));
  const double width = far / count;
  double sum = 0;
  for (int k = 1; k < count; ++k) sum += add(k * width, (k + 1) * width);
  // For a large lambda, F changes over the length 1/lambda next to zero.
  constexpr int halvings = 10;
  for (int k = 0; k < halvings; ++k) sum += add(std::ldexp(width, -k - 1), std::ldexp(width, -k));
  sum += add(0, std::ldexp(width, -halvings));
  constexpr int powers = 8;
  boost::math::quadrature::exp_sinh<double> to_infinity;
  for (int m = 0; m < powers; ++m) {
    const double late = distance - 2 * m;
    const double direction = late > 0 ? -1 : 1;  // direction in which exp(s late) decays
    const auto beyond = [&](double t) {
      const Complex s = far * Complex(direction * t, 1);
      const Complex part = delays(s).power(m) - (m == 0 ? 1.0 : 0.0);
      const Complex wave = std::polar(std::exp(-std::abs(late) * far * t), far * late);
      return std::imag(part / s * wave * direction);
    };
    sum += far * to_infinity.integrate(beyond, 1e-12);
  }
  return 1 + sum / pi;
}

void require_distance(double distance) {
  require(distance >= 1e-3 && distance <= 1e3, "distance", distance, "a number in [0.001, 1000]");
}

}  // namespace

double force_after_creepage_step(double distance, double lambda) {
  require_distance(distance);
  require(lambda >= 0.2 && lambda <= 100, "lambda", lambda, "a number in [0.2, 100]");
  const auto on_axis = [&](double omega) {
    return 1.0 / (adhesion_ratio(omega) + Complex(0, omega * lambda));
  };
  const auto delays = [&](Complex s) {
    const Hankel of(s);
    return Delays{of.c, of.d, of.a + lambda * s * of.c, of.b + lambda * s * of.d};
  };
  // For a small lambda the bodies nearly yield, and F has sharp resonances.
  return inverse(distance, std::max(40.0, 20 / lambda), std::max(1.0, 1 / lambda), on_axis, delays);
}

double creepage_after_force_step(double distance) {
  require_distance(distance);
  if (distance == 2) return std::numeric_limits<double>::infinity();
  const auto delays = [](Complex s) {
    const Hankel of(s);
    return Delays{of.a, of.b, of.c, of.d};
  };
  return inverse(distance, 40, 1, adhesion_ratio, delays);
}

}  // namespace microslip
