// SPDX-License-Identifier: GPL-3.0-or-later
// Traction bounds up to their edges, and their means over elements of any width.
#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "digits/worst_case.hpp"
#include "microslip/friction/traction_bound.hpp"

namespace microslip::bound_test {

using namespace test;

/// A bound with its integral from the trailing edge in many digits, in [-a, a], and what errors of
/// values and of integrals are held against.
struct ExactBound {
  TractionBound bound;
  std::function<Digits50(const Digits50&)> value, integral;
  std::function<Digits50(const Digits50&)> value_scale;  ///< the value itself if empty
  double part_of_scale = 0;  ///< of integrals: the integral itself, and this part of Hertz's
};

std::vector<double> half_widths() { return {1e-12, 1, 3.3, 1e12}; }

Digits50 hertz_integral(const Digits50& a, const Digits50& x) {
  const Digits50 r = x / a;
  return a / 2 *
         (r * sqrt((1 - r) * (1 + r)) + asin(r) + boost::math::constants::half_pi<Digits50>());
}

ExactBound hertz(double a) {
  const double peak = 0.7 / a;
  return {HertzBound(a, peak),
          [=](const Digits50& x) { return Digits50(peak * sqrt((1 - x / a) * (1 + x / a))); },
          [=](const Digits50& x) { return Digits50(peak * hertz_integral(a, x)); },
          {}};
}

/// As the coefficients stand, and by quadrature over the angle.
ExactBound polynomial(double a, const Eigen::VectorXd& c) {
  const double peak = 0.7 / a;
  const auto h = [=](const Digits50& t) {
    Digits50 sum = 0;
    for (Eigen::Index k = c.size() - 1; k >= 0; --k) sum = sum * t + c[k];
    return sum;
  };
  const double size = c.lpNorm<1>();
  return {
      PolynomialBound(a, peak, c),
      [=](const Digits50& x) {
        return Digits50(peak * sqrt((1 - x / a) * (1 + x / a)) * h(x / a));
      },
      [=](const Digits50& x) {
        static boost::math::quadrature::tanh_sinh<Digits50> integrator;
        const Digits50 end = acos(Digits50(-x / a));
        if (end == 0) return Digits50(0);
        const auto integrand = [&](const Digits50& angle) {
          const Digits50 s = sin(angle);
          return Digits50(s * s * h(-cos(angle)));
        };
        return Digits50(a * peak * integrator.integrate(integrand, Digits50(0), end));
      },
      [=](const Digits50& x) { return Digits50(size * peak * sqrt((1 - x / a) * (1 + x / a))); },
      size};
}

ExactBound table(double a) {
  const Eigen::Vector4d x(-a, -a * (1 - 1e-9), 0.3 * a, 0.9 * a), g(0.2, 1, 0.4, 3);
  const auto integral_to = [=](const Digits50& end) {
    Digits50 sum = 0;
    for (int i = 1; i <= 4; ++i) {
      const Digits50 left = x[i - 1], right = i < 4 ? x[i] : a;
      const Digits50 last = i < 4 ? g[i] : 0;
      if (end <= left) break;
      const Digits50 to = std::min(end, right), slope = (last - g[i - 1]) / (right - left);
      sum += (to - left) * (g[i - 1] + slope * (to - left) / 2);
    }
    return sum;
  };
  const auto value = [=](const Digits50& at) {
    for (int i = 1; i <= 4; ++i) {
      const Digits50 left = x[i - 1], right = i < 4 ? x[i] : a;
      const Digits50 last = i < 4 ? g[i] : 0;
      if (at < right || i == 4) {
        return Digits50(g[i - 1] + (last - g[i - 1]) * ((at - left) / (right - left)));
      }
    }
    return Digits50(0);
  };
  return {TabulatedBound(a, x, g), value, integral_to, {}};
}

ExactBound bound_named(const std::string& name, double a) {
  if (name == "hertz") return hertz(a);
  if (name == "table") return table(a);
  if (name == "quadratic") return polynomial(a, Eigen::Vector3d(1, 0.3, -0.2));
  Eigen::VectorXd c = Eigen::VectorXd::Zero(33);
  c[0] = 0.5;
  c[31] = -0.3;
  c[32] = 1;
  return polynomial(a, c);
}

struct BoundCase : Stated {
  double documented;
};

std::vector<double> positions(double a) {
  std::vector<double> all = {-a, -0.7 * a, 0, 0.3 * a, 0.95 * a, a};
  for (const double inwards : {1e-15, 1e-12, 1e-6, 1e-3}) {
    all.push_back(a * (inwards - 1));
    all.push_back(a * (1 - inwards));
  }
  return all;
}

class BoundValue : public testing::TestWithParam<BoundCase> {};
class BoundIntegral : public testing::TestWithParam<BoundCase> {};
class BoundMean : public testing::TestWithParam<BoundCase> {};

TEST_P(BoundValue, AgreesWith50Digits) {
  WorstCase worst;
  for (const double a : half_widths()) {
    const ExactBound e = bound_named(GetParam().subject, a);
    for (const double x : positions(a)) {
      const double value = bound_at(e.bound, Eigen::VectorXd::Constant(1, x))[0];
      const Digits50 exact = e.value(x);
      worst.meet(relative_error(value, exact, e.value_scale ? e.value_scale(x) : exact),
                 place({{"x", x / a}, {"a", a}}));
    }
  }
  expect_as_stated(GetParam(), worst);
  EXPECT_LE(worst.error(), GetParam().documented);
}

// The error for polynomials is relative to the whole.
TEST_P(BoundIntegral, AgreesWith50Digits) {
  WorstCase worst;
  for (const double a : half_widths()) {
    const ExactBound e = bound_named(GetParam().subject, a);
    for (const double x : positions(a)) {
      const double value = std::visit([&](const auto& b) { return b.integral(x); }, e.bound);
      const Digits50 exact = e.integral(x);
      worst.meet(relative_error(value, exact, e.part_of_scale > 0 ? e.integral(a) : exact),
                 place({{"x", x / a}, {"a", a}}));
    }
  }
  expect_as_stated(GetParam(), worst);
  EXPECT_LE(worst.error(), GetParam().documented);
}

// The error for polynomials is relative to the mean of Hertz's bound times the sum of the
// coefficients' sizes.
TEST_P(BoundMean, AgreesWith50Digits) {
  WorstCase worst;
  for (const double a : half_widths()) {
    const ExactBound e = bound_named(GetParam().subject, a);
    for (const double x : positions(a)) {
      for (const double part : {1e-15, 1e-12, 1e-6, 1e-3, 0.1, 1.0, 3.0}) {
        const double width = part * a;
        const Digits50 begin = std::max(Digits50(-a), Digits50(x) - Digits50(width) / 2);
        const Digits50 end = std::min(Digits50(a), Digits50(x) + Digits50(width) / 2);
        const double value = mean_bound_around(e.bound, Eigen::VectorXd::Constant(1, x), width)[0];
        const Digits50 exact = (e.integral(end) - e.integral(begin)) / width;
        const Digits50 of_hertz = (hertz_integral(a, end) - hertz_integral(a, begin)) / width;
        worst.meet(relative_error(
                       value, exact,
                       Digits50(e.part_of_scale > 0 ? Digits50(e.part_of_scale * 0.7 / a * of_hertz)
                                                    : exact)),
                   place({{"x", x / a}, {"width", part}, {"a", a}}));
      }
    }
  }
  expect_as_stated(GetParam(), worst);
  EXPECT_LE(worst.error(), GetParam().documented);
}

INSTANTIATE_TEST_SUITE_P(
    Digits, BoundValue,
    testing::Values(BoundCase{{"hertz", 2e-16, "x_m0p999_a_1e12"}, 1e-15},
                    BoundCase{{"quadratic", 3e-16, "x_0p999999_a_1em12"}, 2e-15},
                    BoundCase{{"degree_32", 1e-14, "x_0p999999_a_1em12"}, 3e-14},
                    BoundCase{{"table", 3e-16, "x_0_a_1em12"}, 1e-15}),
    case_name);
INSTANTIATE_TEST_SUITE_P(Digits, BoundIntegral,
                         testing::Values(BoundCase{{"hertz", 3e-16, "x_0p999999_a_1"}, 1e-15},
                                         BoundCase{{"quadratic", 3e-16, "x_m0p999_a_1em12"}, 2e-15},
                                         BoundCase{{"degree_32", 5e-16, "x_m0p999_a_1em12"}, 3e-14},
                                         BoundCase{{"table", 3e-16, "x_0p3_a_1"}, 1e-15}),
                         case_name);
INSTANTIATE_TEST_SUITE_P(
    Digits, BoundMean,
    testing::Values(BoundCase{{"hertz", 4e-16, "x_0p3_width_1em6_a_1"}, 1e-15},
                    BoundCase{{"quadratic", 5e-16, "x_1_width_0p001_a_1"}, 2e-15},
                    BoundCase{{"degree_32", 1e-14, "x_1_width_1em15_a_1em12"}, 3e-14},
                    BoundCase{{"table", 4e-16, "x_m0p7_width_1em15_a_1em12"}, 1e-15}),
    case_name);

}  // namespace microslip::bound_test
