// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels by their symbol: closed forms that a table has to reproduce, and coefficients by
// quadrature of the symbol itself.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "microslip/halfspace/influence.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::symbol_kernel_test {

using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

const Material material{1.7, 0.3};

VectorXd log_spaced(double first, double last, Index count) {
  return VectorXd::LinSpaced(count, std::log(first), std::log(last)).array().exp();
}

SymbolKernel table_of(const VectorXd& wave_numbers, const auto& symbol) {
  return {wave_numbers, wave_numbers.unaryExpr(symbol)};
}

// From kappa_1 on, the symbol of plane strain; 1e-4 away, L0 is that of the first row.
TEST(SymbolKernel, OfAHalfSpaceAndALayerIsThatOfPlaneStrainAndALayer) {
  const double first = 1e-4, layer = 0.3;
  const PlaneKernel plane(material, std::exp(1 - std::numbers::egamma) / first);
  const LayeredKernel layered(plane, layer);
  const VectorXd wave_numbers = log_spaced(first, 30, 7);
  const SymbolKernel of_plane =
      table_of(wave_numbers, [](double k) { return compliance(material) / k; });
  const SymbolKernel of_layered =
      table_of(wave_numbers, [&](double k) { return compliance(material) / k + layer; });
  EXPECT_NEAR(of_plane.log_factor() / plane.log_factor(), 1, 1e-12);
  EXPECT_EQ(of_plane.layer_compliance(), 0);
  EXPECT_NEAR(of_layered.log_factor() / plane.log_factor(), 1, 1e-9);
  EXPECT_NEAR(of_layered.layer_compliance() / layer, 1, 1e-9);
  const double dx = 0.1;
  for (const Basis& basis : {constant_basis(), linear_basis()}) {
    const ShapeFunction& shape = basis.shapes().front();
    for (const double offset : {0.0, 1.0, -1.0, 3.0, 20.0, -20.0}) {
      const double unit = influence(plane, shape, dx, 0);
      EXPECT_NEAR(influence(of_plane, shape, dx, offset), influence(plane, shape, dx, offset),
                  1e-7 * unit);
      EXPECT_NEAR(influence(of_layered, shape, dx, offset), influence(layered, shape, dx, offset),
                  1e-7 * unit);
      for (const double shift : {1e-6, 0.3, 1.0, 2.5}) {
        EXPECT_NEAR(influence_difference(of_layered, shape, dx, offset, shift) /
                        influence_difference(layered, shape, dx, offset, shift),
                    1, 1e-4)
            << offset << " " << shift;
      }
    }
  }
}

// A strip's symbol is an integral of Bessel's function K0: that of 1/sqrt(z^2 + y^2) is 2 K0.
TEST(SymbolKernel, OfAStripIsThatOfTheStrip) {
  const double half = 1.5;
  const StripKernel strip(material, 2 * half);
  const auto symbol = [&](double k) {
    using boost::math::cyl_bessel_k;
    using boost::math::quadrature::gauss;
    double integral = 0;
    for (double end = half; end > 1e-12; end /= 2) {
      integral += gauss<double, 15>::integrate([&](double y) { return cyl_bessel_k(0, k * y); },
                                               end / 2, end);
    }
    return 2 * (compliance(material) / pi * integral + 2 * material.poisson_ratio /
                                                           (pi * material.shear_modulus) * half *
                                                           cyl_bessel_k(0, k * half));
  };
  const double dx = 0.1;
  const auto error = [&](Index rows) {
    const SymbolKernel table = table_of(log_spaced(1e-7, 40, rows), symbol);
    double largest = 0;
    for (const double offset : {0.0, 1.0, 7.0, 30.0}) {
      largest = std::max(largest, std::abs(influence(table, constant_shape(), dx, offset) -
                                           influence(strip, constant_shape(), dx, offset)));
    }
    return largest / influence(strip, constant_shape(), dx, 0);
  };
  const double coarse = error(100), fine = error(400);
  EXPECT_LT(fine, 1e-4);
  EXPECT_LT(fine, coarse / 8);
}

/// A table by its definition: wave number times symbol is linear between rows.
struct Meant {
  VectorXd wave_numbers, symbols;

  double operator()(double k) const {
    const Index n = wave_numbers.size();
    if (k <= wave_numbers[0]) return symbols[0];
    Index i = 1;
    while (i < n - 1 && wave_numbers[i] < k) ++i;
    const double left = wave_numbers[i - 1] * symbols[i - 1], right = wave_numbers[i] * symbols[i];
    return (left +
            (right - left) * (k - wave_numbers[i - 1]) / (wave_numbers[i] - wave_numbers[i - 1])) /
           k;
  }
};

// The displacement by a constant element at a distance is 1/pi times the integral of S 2
// sin(kappa dx/2)/kappa cos(kappa distance), of which a layer's part is C on the element.
TEST(SymbolKernel, HasTheCoefficientsOfItsSymbol) {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 6; ++trial) {
    const Index rows = 2 + static_cast<Index>(6 * uniform(random));
    Meant meant{VectorXd(rows), VectorXd(rows)};
    double k = 0.02 + uniform(random);
    for (Index i = 0; i < rows; ++i, k *= 1.2 + 3 * uniform(random)) {
      meant.wave_numbers[i] = k;
      meant.symbols[i] = 0.2 + uniform(random);
    }
    meant.symbols[rows - 1] = meant.symbols[rows - 2] * (0.6 + 0.39 * uniform(random));
    if (meant(1e9) <= 0) continue;
    const double layer = meant(1e12);
    const SymbolKernel kernel(meant.wave_numbers, meant.symbols);
    EXPECT_NEAR(kernel.layer_compliance(), layer, 1e-9);
    const double dx = 0.1 + uniform(random);
    for (const double offset : {0.0, 1.0, 2.5, 9.0}) {
      const auto integrand = [&](double wave) {
        return (meant(wave) - layer) * 2 * std::sin(wave * dx / 2) / wave *
               std::cos(wave * dx * offset);
      };
      double sum = 0;
      const double panel = 0.5 / (dx * (offset + 1));
      const double end = 4000 / dx;
      double begin = 0;
      for (const double row : meant.wave_numbers) {
        const double parts = std::ceil((row - begin) / panel);
        for (double i = 0; i < parts; ++i) {
          sum += boost::math::quadrature::gauss<double, 15>::integrate(
              integrand, begin + (row - begin) * i / parts,
              begin + (row - begin) * (i + 1) / parts);
        }
        begin = row;
      }
      for (; begin < end; begin += panel) {
        sum +=
            boost::math::quadrature::gauss<double, 15>::integrate(integrand, begin, begin + panel);
      }
      const double on_it = offset == 0 ? layer : 0;
      // Beyond the end, the half-space's part is at most this.
      const double left_out = 4 * kernel.log_factor() / (end * end * dx);
      EXPECT_NEAR(influence(kernel, constant_shape(), dx, offset), on_it + sum / pi,
                  2 * left_out + 1e-11)
          << trial << " " << offset;
    }
  }
}

TEST(SymbolKernel, InOtherUnitsOfLengthIsTheSame) {
  const SymbolKernel kernel(VectorXd{{0.1, 1, 5}}, VectorXd{{3, 1, 0.4}});
  const double length = 2.5, dx = 0.2;
  const Kernel other = kernel.in_units_of(length);
  for (const double offset : {0.0, 1.0, 4.0}) {
    EXPECT_NEAR(influence(other, constant_shape(), dx, offset) * length /
                    influence(kernel, constant_shape(), dx * length, offset),
                1, 1e-12);
  }
}

std::string refusal(const VectorXd& wave_numbers, const VectorXd& symbol) {
  try {
    const SymbolKernel kernel(wave_numbers, symbol);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(SymbolKernel, RefusesWhatIsNoPositiveSymbol) {
  const double inf = std::numeric_limits<double>::infinity();
  const VectorXd waves{{0.1, 1, 10}};
  EXPECT_EQ(refusal(waves, VectorXd{{3, 1, 0.5}}), "");
  EXPECT_EQ(refusal(VectorXd{{1}}, VectorXd{{1}}),
            "rows = 1: expected 2 to 1000 wave numbers, and a symbol for each");
  EXPECT_TRUE(refusal(waves, VectorXd{{3, -1, 0.5}}).starts_with("symbol = -1: expected"));
  EXPECT_TRUE(refusal(waves, VectorXd{{3, 0, 0.5}}).starts_with("symbol = 0: expected"));
  EXPECT_TRUE(refusal(waves, VectorXd{{inf, 1, 0.5}}).starts_with("symbol = inf: expected"));
  EXPECT_TRUE(refusal(VectorXd{{0, 1, 10}}, VectorXd{{3, 1, 0.5}}).starts_with("wave_number = 0"));
  EXPECT_EQ(refusal(VectorXd{{0.1, 10, 1}}, VectorXd{{3, 1, 0.5}}),
            "wave_number = 1: expected more than the one before");
  EXPECT_TRUE(refusal(waves, VectorXd{{3, 1, 0.01}})
                  .starts_with("symbol = 0.01: expected one that "
                               "falls no faster than"));
  EXPECT_TRUE(refusal(VectorXd{{1, 2}}, VectorXd{{1, 3}})
                  .starts_with("symbol = 3: expected one that rises "
                               "no faster than"));
}

// Where the last two rows would make one of them resist a load with the wrong sign, the other one
// is all there is.
TEST(SymbolKernel, GoesOnAsAHalfSpaceOrALayerAlone) {
  const SymbolKernel falling(VectorXd{{1, 2}}, VectorXd{{1, 0.48}});
  EXPECT_EQ(falling.layer_compliance(), 0);
  EXPECT_NEAR(falling.log_factor(), 2 * 0.48 / pi, 1e-15);
  EXPECT_NEAR(falling.symbol(200), 0.0048, 1e-15);
  const SymbolKernel rising(VectorXd{{1, 2}}, VectorXd{{1, 1.1}});
  EXPECT_EQ(rising.layer_compliance(), 1.1);
  EXPECT_EQ(rising.log_factor(), 0);
  EXPECT_EQ(rising.symbol(200), 1.1);
  const SymbolKernel both(VectorXd{{1, 2}}, VectorXd{{1, 0.51}});
  EXPECT_NEAR(both.layer_compliance(), 0.02, 1e-15);
}

TEST(SymbolKernel, RefusesWavesMuchShorterThanElements) {
  const SymbolKernel kernel(VectorXd{{0.1, 2000, 3000}}, VectorXd{{3, 1, 0.9}});
  EXPECT_NO_THROW(influence(kernel, constant_shape(), 0.1, 1));
  EXPECT_THROW(influence(kernel, constant_shape(), 1, 1), std::invalid_argument);
}

// A search of the partition begins on coarser elements, where these resolve the waves, too.
TEST(SymbolKernel, WavesHaveToBeResolvedByTheElementsAskedForAlone) {
  constexpr double first = 1e-3;
  const auto creepage = [&](double last) {
    const auto uneven = [](double k) {
      return compliance(material) / k * (1 + 0.1 * std::sin(std::log(k)));
    };
    return solve_steady(
               {.contact = {table_of(log_spaced(first, last, 40), uneven), HertzBound(1, 1)},
                .grid = Grid({.half_width = 1, .elements = 800}),
                .method = Calibrated{},
                .load = PrescribedForce{-0.8}})
        .creepage;
  };
  constexpr double longest_resolved = 1000 / (2.0 / 800);
  // The symbol goes on behind the last two rows, so that the row before the last has the last bend.
  EXPECT_NEAR(creepage(1.4 * longest_resolved) / creepage(0.2 * longest_resolved), 1, 1e-3);
  EXPECT_THROW(creepage(2 * longest_resolved), std::invalid_argument);
}

}  // namespace microslip::symbol_kernel_test
