// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols, the constants of the leading edge and the Fourier inverse.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "digits/reference_kernel.hpp"
#include "microslip/halfspace/basis.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/halfspace/leading_edge.hpp"
#include "microslip/thesis/fourier_inverse.hpp"
#include "microslip/thesis/symbol.hpp"

namespace microslip::spectrum_test {

using namespace test;

constexpr double nu = 0.28;

/// A complex number in many digits, without a library's overloads for complex<double> in the way
struct Pair {
  Digits50 real = 0, imaginary = 0;

  Pair& add(const Digits50& factor, const Digits50& angle) {
    real += factor * cos(angle);
    imaginary += factor * sin(angle);
    return *this;
  }
};

Pair product(const Pair& a, const Pair& b) {
  return {a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real};
}

Pair quotient(const Pair& a, const Pair& b) {
  const Digits50 square = b.real * b.real + b.imaginary * b.imaginary;
  const Pair p = product(a, {b.real, -b.imaginary});
  return {p.real / square, p.imaginary / square};
}

/// Symbols of (A - A')/c for G = 1 and dx = 1.
class ExactSymbol {
 public:
  ExactSymbol(const ShapeFunction& shape, double step_ratio)
      : shape_(shape),
        step_ratio_(step_ratio),
        first_(static_cast<int>(std::ceil(step_ratio)) + 3) {
    const ReferenceInfluence<Digits100> influence({nu, 0}, shape);
    for (int k = 1 - first_; k < first_; ++k) {
      near_.emplace_back((influence(k) - influence(Digits100(k) + step_ratio)) / step_ratio);
    }
  }

  /// Coefficients next to the node as they are; farther ones are Laplace transforms, as the decay
  /// 1/z is that of 1, and so geometric series under the integral.
  Pair of_plane(double theta) const {
    Pair sum;
    for (std::size_t i = 0; i < near_.size(); ++i) {
      sum.add(near_[i], (first_ - 1 - static_cast<int>(i)) * Digits50(theta));
    }
    const Digits50 half = sin(Digits50(theta) / 2), sine = sin(Digits50(theta));
    Digits50 begin = 0, end = Digits50(theta) / 2;
    Pair ahead, behind;
    for (; begin < 80; begin = std::exchange(end, Digits50(2 * end))) {
      for_each_point(begin, end, [&](const Digits50& t, const Digits50& weight) {
        // 1 / (1 - exp(-t -+ i theta))
        const Digits50 decay = exp(-t), fall = -expm1(-t), twice = 2 * half * half * decay;
        const Digits50 scaled = weight / (fall * fall + 2 * twice);
        for (const int sign : {1, -1}) {
          const Digits50 factor = scaled * transformed_coefficient(sign, t);
          Pair& side = sign > 0 ? ahead : behind;
          side.real += factor * (twice + fall);
          side.imaginary -= sign * factor * decay * sine;
        }
      });
    }
    const Digits50 turn = first_ * Digits50(theta);
    const Pair all[] = {product(ahead, {cos(turn), -sin(turn)}),
                        product(behind, {cos(turn), sin(turn)})};
    const Digits50 factor = 2 * (1 - Digits50(nu)) / boost::math::constants::pi<Digits50>();
    return {sum.real + factor * (all[0].real + all[1].real),
            sum.imaginary + factor * (all[0].imaginary + all[1].imaginary)};
  }

  /// Sum over aliases of the kernels' transforms, which differ by Bessel's K_0 and its integral.
  Pair of_strip_less_plane(double theta, double width) const {
    const Digits50 pi = boost::math::constants::pi<Digits50>(), b = Digits50(width) / 2;
    Pair sum;
    for (int m = 0; Digits50(2 * pi * (std::abs(m) - 1)) * b<70; m = m> 0 ? -m : 1 - m) {
      const Digits50 xi = theta + 2 * pi * m;
      const Digits50 x = b * abs(xi);
      Digits50 bessel = 0, integral = 0;
      const Digits50 step("0.125");  // exact to exp(-pi^2/step)
      for (int k = 0;; ++k) {
        const Digits50 hyperbolic = cosh(k * step);
        if (x * hyperbolic > 80) break;
        const Digits50 value = (k == 0 ? step / 2 : step) * exp(-x * hyperbolic);
        bessel += value;
        integral += value / hyperbolic;
      }
      const Digits50 kernel =
          2 / pi * (-(1 - Digits50(nu)) * 2 / abs(xi) * integral + nu * 2 * b * bessel);
      const Digits50 shape_transform = even_transform(xi);
      const Digits50 factor = kernel * shape_transform / step_ratio_, turn = xi * step_ratio_;
      const Digits50 half = sin(turn / 2);
      sum.real += factor * 2 * half * half;
      sum.imaginary -= factor * sin(turn);
    }
    return sum;
  }

  Digits50 largest_coefficient() const {
    Digits50 largest = 0;
    for (const Digits50& value : near_) largest = std::max(largest, Digits50(abs(value)));
    return largest;
  }

 private:
  template <class Visit>
  static void for_each_point(const Digits50& begin, const Digits50& end, const Visit& visit) {
    using Gauss = boost::math::quadrature::gauss<Digits50, 20>;
    const Digits50 half = (end - begin) / 2, middle = (end + begin) / 2;
    for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i) {
      const Digits50 away = half * Gauss::abscissa()[i], weight = half * Gauss::weights()[i];
      visit(middle - away, weight);
      visit(middle + away, weight);
    }
  }

  /// Ahead of the node and behind it: the shape's integral times exp(+-t s), and the mean over the
  /// step, from first_ on
  Digits50 transformed_coefficient(int sign, const Digits50& t) const {
    const Digits50 st = sign * t, ct = st * step_ratio_;
    Digits50 sum = 0;
    for (const auto& [begin, end, c] : shape_.pieces()) {
      const auto at = [&](const Digits50& s) {
        return Digits50(exp(st * s - first_ * t) * ((c[0] + c[1] * s) / st - c[1] / (st * st)));
      };
      sum += at(end) - at(begin);
    }
    return -sign * sum * expm1(-ct) / ct;
  }

  /// The shapes are even: their transforms are real.
  Digits50 even_transform(const Digits50& xi) const {
    const Digits50 sinc = sin(xi / 2) / (xi / 2);
    return shape_.pieces().size() == 1 ? sinc : Digits50(sinc * sinc);
  }

  ShapeFunction shape_;
  double step_ratio_;
  int first_;
  std::vector<Digits50> near_;
};

double size_of(const Pair& p) {
  return static_cast<double>(Digits50(sqrt(p.real * p.real + p.imaginary * p.imaginary)));
}

struct SymbolCase : Stated {
  bool influence;
  ShapeFunction shape;
};

class SymbolDigits : public testing::TestWithParam<SymbolCase> {};

// Where the sum over the coefficients of a strain vanishes, as at theta = 0 in a strip, and for
// steps of whole waves, errors are held against the largest of them.
TEST_P(SymbolDigits, AgreesWith25Digits) {
  const SymbolCase& c = GetParam();
  WorstCase worst;
  for (const double step_ratio :
       c.influence ? std::vector{1.0} : std::vector{1e-12, 0.3, 1.0, 6.0}) {
    const ExactSymbol exact_symbol(c.shape, step_ratio);
    const auto largest = static_cast<double>(exact_symbol.largest_coefficient());
    std::vector<std::pair<double, Symbol>> symbols;
    for (const double width : {0.0, 0.1, 1.0, 40.0, 1e4}) {
      const Kernel kernel = kernel_of({1, nu}, width);
      symbols.emplace_back(width, c.influence ? Symbol::of_influence(kernel, c.shape, 1)
                                              : Symbol::of_strain(kernel, c.shape, 1, step_ratio));
    }
    for (const double theta :
         {c.influence ? 1e-3 : 1e-6, std::numbers::pi / 64, 1.0, std::numbers::pi}) {
      const Pair plane = exact_symbol.of_plane(theta);
      for (const auto& [width, symbol] : symbols) {
        Pair exact = plane;
        if (width > 0) {
          const Pair besides = exact_symbol.of_strip_less_plane(theta, width);
          exact = {plane.real + besides.real, plane.imaginary + besides.imaginary};
        }
        if (c.influence) {
          const Digits50 half = sin(Digits50(theta) / 2);
          exact = quotient(exact, {2 * half * half, -sin(Digits50(theta))});
        }
        const std::complex<double> value = symbol(theta);
        const double error = size_of({value.real() - exact.real, value.imag() - exact.imaginary});
        const double scale = c.influence ? size_of(exact) : std::max(size_of(exact), largest);
        worst.meet(error / scale, place({{"theta", theta}, {"c", step_ratio}, {"width", width}}));
      }
    }
  }
  expect_as_stated(c, worst);
  EXPECT_LE(worst.error(), c.influence ? 1e-13 : 5e-13);
}

INSTANTIATE_TEST_SUITE_P(
    Digits, SymbolDigits,
    testing::Values(
        SymbolCase{
            {"strain_constant", 4e-13, "theta_1em6_c_6_width_10000"}, false, constant_shape()},
        SymbolCase{{"strain_linear", 4e-13, "theta_1em6_c_6_width_10000"}, false, linear_shape()},
        SymbolCase{
            {"influence_constant", 2e-14, "theta_3p14159_c_1_width_0"}, true, constant_shape()},
        SymbolCase{{"influence_linear", 4e-14, "theta_0p001_c_1_width_0p1"}, true, linear_shape()}),
    case_name);

// ------------------------------------------------------------------------------- leading edge

/// b of the symbol, its lattice sum by Euler and Maclaurin from the 20th alias on.
Digits50 exact_b(int degree, const Digits50& theta) {
  using boost::math::constants::pi;
  constexpr int first = 20;
  const int power = degree + 2;
  // sum over m >= first of (+-1)^(m (degree + 1)) (2 pi m + x)^-power: two steps at once, of one
  // sign
  const auto tail = [&](const Digits50& x) {
    const auto half = [&](int start, int stride) {
      // Euler-Maclaurin of (d n + e)^-power over n >= 0
      const Digits50 d = 2 * pi<Digits50>() * stride;
      const Digits50 e = 2 * pi<Digits50>() * start + x;
      const std::array<int, 10> numerators = {1, -1, 1, -1, 5, -691, 7, -3617, 43867, -174611};
      const std::array<int, 10> denominators = {6, 30, 42, 30, 66, 2730, 6, 510, 798, 330};
      Digits50 sum = pow(e, 1 - power) / (d * (power - 1)) + pow(e, -power) / 2;
      Digits50 factor = pow(e, -power) * power * d / e;  // minus the first derivative
      Digits50 factorial = 2;
      for (int k = 1; k <= 10; ++k) {
        const auto i = static_cast<std::size_t>(k - 1);
        sum += Digits50(numerators[i]) / denominators[i] * factor / factorial;
        factor *= Digits50(power + 2 * k - 1) * (power + 2 * k) * (d / e) * (d / e);
        factorial *= Digits50(2 * k + 1) * (2 * k + 2);
      }
      return sum;
    };
    return degree == 1 ? half(first, 1) : Digits50(half(first, 2) - half(first + 1, 2));
  };
  Digits50 sum = tail(theta) + tail(-theta) * (degree == 0 ? -1 : 1);
  const auto sine_over = [&](const Digits50& xi) {
    return Digits50(pow(2 / abs(xi), degree + 1) / abs(xi));
  };
  Digits50 near = 0;
  for (int m = 1 - first; m < first; ++m) {
    const Digits50 xi = theta + 2 * pi<Digits50>() * m;
    const int sign = degree == 0 ? (m % 2 == 0 ? 1 : -1) * (xi < 0 ? -1 : 1) : 1;
    near += sign * sine_over(xi);
  }
  near += sum * pow(Digits50(2), degree + 1);
  return 2 * sin(theta / 2) * near * pow(sin(theta / 2), degree + 1);
}

struct EdgeCase : Stated {
  int degree;
};

class LeadingEdgeDigits : public testing::TestWithParam<EdgeCase> {};

TEST_P(LeadingEdgeDigits, AgreesWith30Digits) {
  const int degree = GetParam().degree;
  using boost::math::constants::pi;
  const auto mean = [&](const std::function<Digits50(const Digits50&)>& factor) {
    const auto integrand = [&](const Digits50& theta) {
      return Digits50(log(exact_b(degree, theta)) * factor(theta));
    };
    const Digits50 half = pi<Digits50>() / 2;
    using Gauss = boost::math::quadrature::gauss<Digits50, 30>;
    return Digits50((Gauss::integrate(integrand, Digits50(0), half) +
                     Gauss::integrate(integrand, half, pi<Digits50>())) /
                    pi<Digits50>());
  };
  const auto edge = leading_edge_constants(degree == 0 ? constant_basis() : linear_basis());
  const Digits50 offset =
      Digits50(3) / 4 - mean([](const Digits50& theta) {
                          return Digits50(1 / (sin(theta / 2) * sin(theta / 2)));
                        }) / 4;
  const Digits50 compliance = exp(mean([](const Digits50&) { return Digits50(1); }));
  WorstCase worst;
  worst.meet(relative_error(edge.offset, offset), "offset");
  worst.meet(relative_error(edge.compliance, compliance), "compliance");
  // (1 - z)^(-3/2) exp(-sum of f_k z^k), the exponential as a power series of its argument
  constexpr int count = 8;
  using Series = std::array<Digits50, count>;
  const auto times = [](const Series& a, const Series& b) {
    Series c{};
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; i + j < count; ++j) c[i + j] += a[i] * b[j];
    }
    return c;
  };
  Series exponent{}, term{1}, layer{}, growth{1};
  for (std::size_t k = 1; k < count; ++k) {
    exponent[k] =
        -mean([&](const Digits50& theta) { return Digits50(cos(static_cast<int>(k) * theta)); });
    growth[k] = growth[k - 1] * (2 * static_cast<int>(k) + 1) / (2 * static_cast<int>(k));
  }
  for (int n = 1; n <= count; ++n) {
    for (std::size_t k = 0; k < count; ++k) layer[k] += term[k];
    term = times(term, exponent);
    for (Digits50& t : term) t /= n;
  }
  layer = times(layer, growth);
  for (std::size_t k = 0; k < count; ++k) {
    const Digits50 root =
        sqrt(static_cast<int>(k) + offset) * sqrt(compliance) * 2 / sqrt(pi<Digits50>());
    worst.meet(relative_error(edge.layer[k], Digits50(layer[k] / root)),
               "layer_" + std::to_string(k));
  }
  expect_as_stated(GetParam(), worst);
  EXPECT_LE(worst.error(), 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Digits, LeadingEdgeDigits,
                         testing::Values(EdgeCase{{"constant", 3e-16, "layer_7"}, 0},
                                         EdgeCase{{"linear", 2e-16, "layer_4"}, 1}),
                         case_name);

// ---------------------------------------------------------------------------- Fourier inverse

struct InverseCase : Stated {};

class FourierInverseDigits : public testing::TestWithParam<InverseCase> {};

// The inverse is of A - A' as it is in double precision, by sums. Its error is held against the
// column's largest entry times the ratio of the largest coefficient to the least one, by which a
// rounding of A - A' is amplified.
TEST_P(FourierInverseDigits, AgreesWith50Digits) {
  const Digits50 two_pi = 2 * boost::math::constants::pi<Digits50>();
  WorstCase worst;
  for (const int n : {2, 7, 64}) {
    std::vector<Pair> turns;
    for (int k = 0; k < n; ++k) turns.push_back(Pair().add(1, two_pi * k / n));
    for (const double c : {1e-12, 1e-3, 0.7, 1.0, 30.0}) {
      const Toeplitz matrix =
          influence_difference_toeplitz(StripKernel({1, nu}, 3), constant_shape(), 1, n, c);
      const Eigen::VectorXd column = diagonal_first(middle_column(matrix));
      std::vector<Pair> inverse;
      Digits50 most = 0, least = 1e300;
      for (int m = 0; m < n; ++m) {
        Pair sum;
        for (int k = 0; k < n; ++k) {
          const Pair& turn = turns[static_cast<std::size_t>(k * m % n)];
          sum.real += column[k] * turn.real;
          sum.imaginary -= column[k] * turn.imaginary;
        }
        const Digits50 size = sqrt(sum.real * sum.real + sum.imaginary * sum.imaginary);
        most = std::max(most, size);
        least = std::min(least, size);
        inverse.push_back(quotient({1, 0}, sum));
      }
      std::vector<Digits50> exact;
      Digits50 largest = 0;
      for (int k = 0; k < n; ++k) {
        Digits50 sum = 0;
        for (int m = 0; m < n; ++m) {
          const Pair& turn = turns[static_cast<std::size_t>(k * m % n)];
          sum += product(inverse[static_cast<std::size_t>(m)], turn).real / n;
        }
        exact.push_back(sum);
        largest = std::max(largest, Digits50(abs(sum)));
      }
      const Eigen::VectorXd found = diagonal_first(approximate_inverse_column(matrix));
      for (int k = 0; k < n; ++k) {
        worst.meet(relative_error(found[k], exact[static_cast<std::size_t>(k)],
                                  Digits50(largest * most / least)),
                   place({{"n", double(n)}, {"c", c}, {"k", double(k)}}));
      }
    }
  }
  expect_as_stated(GetParam(), worst);
  EXPECT_LE(worst.error(), 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Digits, FourierInverseDigits,
                         testing::Values(InverseCase{{"column", 2e-16, "n_2_c_0p001_k_1"}}),
                         case_name);

}  // namespace microslip::spectrum_test
