// SPDX-License-Identifier: GPL-3.0-or-later
// Hertz's contact under a normal load that oscillates a little, with a constant creepage about
// Carter's solution, a'/a = alpha. In plane strain, with Bessel functions of K a' and
//   Z = iK a'/R,  R = J0/(J0 + i J1),  Lam = ln(2 L0/a),  Lam' = ln(2 L0/a'),
// the force follows as dF/(mu dP) = -(1 - (alpha + Z Lam)/(1 + Z Lam')).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "measured_order.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::changing_contact_test {

using std::numbers::pi;
using Complex = std::complex<double>;

const Material material{1.44, 0.28};  // k = 1/pi
constexpr double length = 10;
constexpr double creepage = 0.4;  // Carter's for alpha = 0.6 with a = 1 and the peak 1

Complex exact_response(double wavelength, double alpha) {
  const double wave = 2 * pi / wavelength;
  const double j0 = boost::math::cyl_bessel_j(0, wave * alpha);
  const double j1 = boost::math::cyl_bessel_j(1, wave * alpha);
  const Complex r = j0 / Complex(j0, j1);
  const Complex z = Complex(0, wave * alpha) / r;
  const double whole = std::log(2 * length), stuck = std::log(2 * length / alpha);
  return -(1.0 - (alpha + z * whole) / (1.0 + z * stuck));
}

TransientRolling rolling_on(Eigen::Index n) {
  return TransientRolling({.contact = {PlaneKernel(material, length), HertzBound(1, 1)},
                           .grid = Grid({.half_width = 1, .elements = n}),
                           .basis = constant_basis(),
                           .scheme = Remembered{}});
}

/// By Fourier's integral over whole wavelengths, after 24 half-widths under the load's mean. The
/// mean of two amplitudes of either sign is linear.
Complex response(Eigen::Index n, double wavelength, double step_ratio) {
  const double wave = 2 * pi / wavelength, amplitude = 1e-3;
  const auto steps =
      static_cast<int>(std::lround(wavelength * static_cast<double>(n) / (2 * step_ratio)));
  const double step = wavelength / steps;
  TransientRolling steady = rolling_on(n);
  steady.roll(24, {2.0 / static_cast<double>(n)}, PrescribedCreepage{creepage},
              [](const TransientState&) {});
  Complex sum = 0;
  for (const double sign : {1.0, -1.0}) {
    TransientRolling rolling(steady);
    const int waves = std::max(2, static_cast<int>(std::ceil(25 / wavelength)));
    for (int i = 1; i <= waves * steps; ++i) {
      const double q = i * step;
      rolling.set_contact(hertz_scale(1 + sign * amplitude * std::sin(wave * q)));
      rolling.step(step, PrescribedCreepage{creepage});
      if (i <= (waves - 1) * steps) continue;
      sum += sign * rolling.state().force * std::polar(1.0, -wave * q) / double(steps);
    }
  }
  return sum * Complex(0, 1) / amplitude / (pi / 2);
}

TEST(ChangingContact, ResponseIsThatOfTheLinearTheory) {
  EXPECT_NEAR(std::abs(exact_response(5, 0.6) - Complex(-0.1429511793, 0.0961156072)), 0, 1e-10);
  for (const double step_ratio : {1.0, 0.3}) {
    for (const double wavelength : {1.0, 5.0, 40.0}) {
      const Complex exact = exact_response(wavelength, 1 - creepage);
      constexpr std::array<double, 2> sizes = {25, 100};
      std::array<double, 2> errors{};
      for (std::size_t i = 0; i < sizes.size(); ++i) {
        for (const Eigen::Index more :
             {0, 1, 2}) {  // the stick-slip point is anywhere in an element
          const Eigen::Index n = static_cast<Eigen::Index>(sizes[i]) + more;
          errors[i] = std::max(
              errors[i], std::abs(response(n, wavelength, step_ratio) - exact) / std::abs(exact));
        }
      }
      const std::string problem =
          fmt::format("wavelength {:g} a, c = {:g}", wavelength, step_ratio);
      EXPECT_LE(errors[1], 4e-4) << problem;
      EXPECT_GE(measured_order(problem, sizes, errors), 1.7) << problem;
    }
  }
}

}  // namespace microslip::changing_contact_test
