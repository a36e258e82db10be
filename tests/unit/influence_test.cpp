// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/influence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "microslip/halfspace/basis.hpp"
#include "reference_influence.hpp"

namespace microslip {
namespace {

using test::Digits50;

struct Case {
  std::string name;
  ShapeFunction shape;
  double nu;
  double width;  ///< Dy/dx; 0 for plane strain
};

std::vector<Case> cases() {
  std::vector<Case> all;
  const Basis quadratic = quadratic_basis();
  for (const auto& [name, shape] :
       {std::pair("constant", constant_shape()), std::pair("linear", linear_shape()),
        std::pair("quadratic bubble", quadratic.shapes()[0]),
        std::pair("quadratic vertex", quadratic.shapes()[1]),
        std::pair("trimmed linear", trimmed_linear_basis(0.4).shapes()[1]),
        std::pair("edge constant", edge_constant_basis().shapes()[1])}) {
    for (const double width : {1e-2, 0.1, 1.0, 40.0, 1e6, 0.0}) {
      for (const double nu : {0.0, 0.28, 0.5}) all.push_back({name, shape, nu, width});
    }
  }
  return all;
}

std::string describe(const Case& c, double offset, double shift) {
  return c.name + ", Dy/dx = " + std::to_string(c.width) + ", nu = " + std::to_string(c.nu) +
         ", offset " + std::to_string(offset) + ", shift " + std::to_string(shift);
}

Kernel kernel_of(const Case& c) {
  const Material material{1, c.nu};
  if (c.width == 0) return PlaneKernel(material, 1);
  return StripKernel(material, c.width);
}

test::ReferenceInfluence reference_of(const Case& c) {
  return {.nu = c.nu, .width = c.width, .shape = test::reference_pieces(c.shape)};
}

double relative_error(double value, const Digits50& exact, const Digits50& scale) {
  return static_cast<double>(abs(value - exact) / abs(scale));
}

// Worst met: 1.0e-15 (constant, plane strain, nu = 0, offset 1).
TEST(Influence, AgreesWithFiftyDigitsAtAllDistances) {
  for (const Case& c : cases()) {
    const auto reference = reference_of(c);
    const Kernel kernel = kernel_of(c);
    for (const double offset : {0.0, 1.0, -2.0, 7.0, 0.3, 0.5, -0.77, 100.0, -1e6}) {
      const double value = influence(kernel, c.shape, 1, offset);
      const Digits50 exact = reference(offset);
      EXPECT_LT(relative_error(value, exact, exact), 1e-14) << describe(c, offset, 0);
    }
  }
}

// The diagonal entry vanishes like c^2 and, for c = -2 offset, an entry vanishes by symmetry: those
// are held against the largest entry of the row.
// Worst met, relative: 1.8e-13 (quadratic vertex, Dy = 0.1 dx, nu = 0.5, c = 0.77, offset -2: the
// function changes sign); of the row's largest: 2.2e-14 (quadratic vertex, Dy = 0.01 dx, nu = 0, c
// = 2).
TEST(InfluenceDifference, AgreesWithFiftyDigitsAtAllDistancesAndShifts) {
  for (const Case& c : cases()) {
    const auto reference = reference_of(c);
    const Kernel kernel = kernel_of(c);
    for (const double shift : {1e-10, 1e-3, 0.3, 0.5, 0.77, 1.0, 2.0}) {
      const auto exact_at = [&](double offset) {
        return Digits50(reference(offset) - reference(Digits50(offset) + Digits50(shift)));
      };
      const Digits50 largest = std::max(abs(exact_at(0)), abs(exact_at(-1)));
      for (const double offset : {0.0, 1.0, -1.0, 2.0, -2.0, -7.0, 100.0, 1e6, -1e6}) {
        const double value = influence_difference(kernel, c.shape, 1, offset, shift);
        const Digits50 exact = exact_at(offset);
        const bool small = offset == 0 || shift == -2 * offset;
        EXPECT_LT(relative_error(value, exact, small ? largest : exact), 4e-13)
            << describe(c, offset, shift);
      }
    }
  }
}

TEST(Influence, AgreesWithQuadratureOfKernelTimesShape) {
  boost::math::quadrature::tanh_sinh<double> integrator;
  const double dx = 0.25;
  for (const Kernel& kernel :
       {Kernel(StripKernel({2, 0.3}, 1.5)), Kernel(PlaneKernel({2, 0.3}, 10))}) {
    for (const char* name : {"constant", "linear"}) {
      const ShapeFunction shape = make_basis(name).shapes().front();
      for (const double offset : {0.0, 1.0, 3.0}) {
        double sum = 0;
        for (std::size_t i = 1; i < shape.breakpoints().size(); ++i) {
          const double begin = shape.breakpoints()[i - 1];
          const double end = shape.breakpoints()[i];
          const auto integrand = [&](double s) {
            return std::visit(
                [&](const auto& k) {
                  return k.displacement(dx * std::abs(offset - s)) * shape.value(s);
                },
                kernel);
          };
          const double split = std::clamp(offset, begin, end);  // the kernel's logarithm
          if (split > begin) sum += integrator.integrate(integrand, begin, split);
          if (split < end) sum += integrator.integrate(integrand, split, end);
        }
        EXPECT_NEAR(influence(kernel, shape, dx, offset), dx * sum, 1e-9 * std::abs(dx * sum))
            << name << ", offset " << offset;
      }
    }
  }
}

TEST(Influence, ScalesWithSpacing) {
  const ShapeFunction shape = linear_shape();
  const StripKernel small({1, 0.28}, 4);
  const StripKernel large({1, 0.28}, 400);
  EXPECT_NEAR(influence(large, shape, 100, 3) / influence(small, shape, 1, 3), 100, 1e-11);
  EXPECT_NEAR(influence_difference(large, shape, 100, 3, 0.1) /
                  influence_difference(small, shape, 1, 3, 0.1),
              100, 1e-11);
}

TEST(InfluenceMatrix, DifferenceIsTheDifference) {
  const StripKernel kernel({1, 0.28}, 3);
  const Basis basis = constant_basis();
  const Eigen::MatrixXd a = influence_matrix(kernel, basis, 0.1, 6);
  const Eigen::MatrixXd d = influence_difference_matrix(kernel, basis, 0.1, 6, 0.7);
  EXPECT_EQ(a, a.transpose());
  for (Eigen::Index i = 0; i < 6; ++i) {
    for (Eigen::Index j = 0; j < 6; ++j) {
      const double shifted =
          influence(kernel, constant_shape(), 0.1, static_cast<double>(i - j) + 0.7);
      EXPECT_NEAR(d(i, j), a(i, j) - shifted, 1e-15);
    }
  }
}

// Computed independently for c = 1, plane strain, in units of 2 (1 - nu) dx / G.
TEST(InfluenceMatrix, SignsNextToTheDiagonal) {
  const Material material{1, 0.28};
  const Toeplitz m =
      influence_difference_toeplitz(PlaneKernel(material, 1), constant_shape(), 1, 3, 1);
  EXPECT_NEAR(m(0, 0) / compliance(material), 0.5245, 5e-5);
  EXPECT_NEAR(m(1, 0) / compliance(material), 0.2317, 5e-5);
  EXPECT_NEAR(m(0, 1) / compliance(material), -0.5245, 5e-5);
}

TEST(InfluenceMatrix, RejectsAStepThatIsNotPositive) {
  for (const double step : {0.0, -1.0, 1e-320, std::nan("")}) {
    EXPECT_THROW(
        influence_difference_matrix(PlaneKernel({1, 0.28}, 1), constant_basis(), 1, 3, step),
        std::invalid_argument);
  }
}

}  // namespace
}  // namespace microslip
