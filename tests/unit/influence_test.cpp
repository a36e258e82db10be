// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/influence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <stdexcept>

#include "microslip/halfspace/basis.hpp"

namespace microslip::influence_test {

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
            return kernel.displacement(dx * std::abs(offset - s)) * shape.value(s);
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

}  // namespace microslip::influence_test
