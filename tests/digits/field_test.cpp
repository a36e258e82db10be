// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the strains that tractions and bounds cause in the half-space: inside, next to their ends,
// and far away.
#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "digits/reference_kernel.hpp"
#include "microslip/friction/sliding_field.hpp"
#include "microslip/halfspace/chebyshev_field.hpp"

namespace microslip::field_test {

using namespace test;

constexpr double begin = -0.375, end = 1.125, centre = 0.375, half = 0.75;
constexpr double nu = 0.28;
constexpr double length = 7;

ChebyshevTraction some_traction() { return {begin, end, Eigen::Vector4d(0.7, -0.3, 0.2, 0.15)}; }

/// Displacement and strain by quadrature over the angle, y = centre + half cos(angle), where the
/// traction is a sum of sines: the strain is the integral of the kernel over its slope.
struct ExactField {
  ReferenceKernel<Digits50> kernel;

  Digits50 displacement(const Digits50& x) const { return integral(x, false); }
  Digits50 strain(const Digits50& x) const { return integral(x, true); }

  Digits50 integral(const Digits50& x, bool of_slope) const {
    using boost::math::constants::pi;
    static boost::math::quadrature::tanh_sinh<Digits50> integrator(9);
    const Digits50 t = (x - centre) / half;
    const auto weighted = [&](const Digits50& sine, const Digits50& cosine,
                              const Digits50& distance) {
      Digits50 value = 0, s = sine, c = cosine;
      const Eigen::VectorXd coefficients = some_traction().coefficients();
      for (int n = 0; n < 4; ++n) {
        value += coefficients[n] * (of_slope ? Digits50((n + 1) * c) : Digits50(half * s * sine));
        const Digits50 next = s * cosine + c * sine;
        c = c * cosine - s * sine;
        s = next;
      }
      return distance == 0 ? Digits50(0) : Digits50(value * kernel.displacement(distance));
    };
    const Digits50 tolerance("1e-20");  // then the error is about its square
    if (abs(t) > 1) {
      return integrator.integrate(
          [&](const Digits50& angle) {
            return weighted(sin(angle), cos(angle), abs(x - centre - half * cos(angle)));
          },
          Digits50(0), pi<Digits50>(), tolerance);
    }
    // From the angle of x to both sides: the distance keeps its digits there.
    const Digits50 middle = acos(t);
    const auto side = [&](int sign, const Digits50& range) {
      return integrator.integrate(
          [&](const Digits50& away) {
            const Digits50 angle = middle + sign * away;
            const Digits50 distance = 2 * half * abs(sin((angle + middle) / 2)) * sin(away / 2);
            return weighted(sin(angle), cos(angle), distance);
          },
          Digits50(0), range, tolerance);
    };
    return side(1, pi<Digits50>() - middle) + side(-1, middle);
  }
};

/// Per unit of the coefficients' sizes: a strain, and the logarithm of a displacement
double strain_scale() { return compliance({1, nu}) * 1.35; }
double displacement_scale(double width) {
  return strain_scale() * half *
         std::max(1.0, std::abs(std::log((width > 0 ? width : length) / half)));
}

std::vector<double> places() {
  std::vector<double> all = {-0.2, 0.3750001, end, 4, -1e6};
  for (const double away : {1e-15, 1e-9}) {
    all.push_back(begin * (1 + away));
    all.push_back(end * (1 - away));
    all.push_back(end * (1 + away));
  }
  return all;
}

struct FieldCase : Stated {
  std::vector<double> widths;  ///< 0 for plane strain
  double documented;
};

class FieldDigits : public testing::TestWithParam<FieldCase> {};

TEST_P(FieldDigits, AgreesWith50Digits) {
  WorstCase worst;
  const bool strain = GetParam().subject.find("strain") == 0;
  for (const double width : GetParam().widths) {
    const ChebyshevField field(kernel_of({1, nu}, width, length), some_traction());
    const ExactField exact{{nu, width, length, 1}};
    for (const double x : places()) {
      const double value = strain ? field.strain(x) : field.displacement(x);
      worst.meet(strain ? relative_error(value, exact.strain(x), Digits50(strain_scale()))
                        : relative_error(value, exact.displacement(x),
                                         Digits50(displacement_scale(width))),
                 place({{"x", x}, {"width", width}}));
    }
  }
  expect_as_stated(GetParam(), worst);
  EXPECT_LE(worst.error(), GetParam().documented);
}

INSTANTIATE_TEST_SUITE_P(
    Digits, FieldDigits,
    testing::Values(
        FieldCase{{"strain_plane", 3e-16, "x_m0p375_width_0"}, {0}, 2e-15},
        FieldCase{{"strain_strip", 9e-16, "x_m0p375_width_0p015"}, {0.015, 0.8, 1e8}, 2e-15},
        FieldCase{{"displacement_plane", 5e-16, "x_m1e6_width_0"}, {0}, 2e-15},
        FieldCase{{"displacement_strip", 8e-16, "x_m1e6_width_0p015"}, {0.015, 0.8, 1e8}, 2e-15}),
    case_name);

}  // namespace microslip::field_test
