// SPDX-License-Identifier: GPL-3.0-or-later
// Orders of calibrated elements in steady rolling. In plane strain with Hertz's bound they are
// exact by construction, so they are judged on other bounds and on strips, against Chebyshev
// collocation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "microslip/rolling/calibrated_rolling.hpp"
#include "microslip/rolling/chebyshev_rolling.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/support/convergence.hpp"

namespace microslip {
namespace {

const Material material{1.44, 0.28};  // compliance 1
const std::vector<double> sizes = {15, 30, 60, 120, 240, 480};

PolynomialBound bound_of(std::initializer_list<double> h) {
  return {1, 1, Eigen::Map<const Eigen::VectorXd>(h.begin(), static_cast<Eigen::Index>(h.size()))};
}

struct Errors {
  std::vector<double> force;     ///< relative
  std::vector<double> traction;  ///< largest, away from the ends of the stick zone
};

Errors errors_of(const ChebyshevRolling& reference, std::vector<CalibratedRolling>& rolling,
                 double stick_ratio) {
  const double stick_edge = 1 - 2 * stick_ratio;
  const PrescribedCreepage load{reference.at(stick_edge).creepage};
  const ChebyshevSolution exact = reference.solve(load);
  Errors errors;
  for (CalibratedRolling& one : rolling) {
    const CalibratedSolution solution = one.solve(load);
    errors.force.push_back(std::abs(solution.force() / exact.force() - 1));
    double worst = 0;
    for (int i = 0; i <= 50; ++i) {
      const double x = stick_edge + 2 * stick_ratio * (0.2 + 0.6 * i / 50);
      worst = std::max(worst, std::abs(solution.traction(x) - exact.traction(x)));
    }
    errors.traction.push_back(worst);
  }
  return errors;
}

std::vector<CalibratedRolling> for_all_sizes(const Kernel& kernel, const TractionBound& bound,
                                             const Basis& basis) {
  std::vector<CalibratedRolling> rolling;
  for (const double n : sizes) {
    const bool odd = basis.name() == "quadratic" && static_cast<Eigen::Index>(n) % 2 == 0;
    rolling.emplace_back(kernel, bound, basis, static_cast<Eigen::Index>(n) + (odd ? 1 : 0));
  }
  return rolling;
}

// 50 parts of adhesion from 0.05 to 0.98. The alignment of the grid has no role.
TEST(CalibratedOrder, ForceIsSecondOrderForAnyAdhesion) {
  for (const PolynomialBound& bound : {bound_of({1, 0.3, 0.2}), bound_of({1, -0.5, 0.3, 0.2})}) {
    const PlaneKernel kernel(material, 1);
    const ChebyshevRolling reference(kernel, bound);
    auto rolling = for_all_sizes(kernel, bound, constant_basis());
    std::mt19937 random(1);
    std::uniform_real_distribution<double> stick_ratios(0.05, 0.98);
    for (int i = 0; i < 50; ++i) {
      const double stick_ratio = stick_ratios(random);
      const Errors errors = errors_of(reference, rolling, stick_ratio);
      EXPECT_NEAR(fitted_order(sizes, errors.force), 2, 0.1) << stick_ratio;
      for (std::size_t k = 1; k < sizes.size(); ++k) {
        EXPECT_GT(errors.force[k - 1] / errors.force[k], 3) << stick_ratio;
      }
      EXPECT_LT(errors.force[4], 1e-5) << stick_ratio;  // N = 240
    }
  }
}

TEST(CalibratedOrder, TractionIsSecondOrderInAdhesion) {
  const PolynomialBound bound = bound_of({1, 0.3, 0.2});
  const PlaneKernel kernel(material, 1);
  const ChebyshevRolling reference(kernel, bound);
  auto rolling = for_all_sizes(kernel, bound, constant_basis());
  for (const double stick_ratio : {0.05, 0.2, 0.4, 0.6, 0.8, 0.98}) {
    const Errors errors = errors_of(reference, rolling, stick_ratio);
    EXPECT_NEAR(fitted_order(sizes, errors.traction), 2, 0.1) << stick_ratio;
  }
}

TEST(CalibratedOrder, SoItIsForOtherFunctionsAndStrips) {
  const PolynomialBound bound = bound_of({1, 0.3, 0.2});
  for (const Kernel& kernel :
       {Kernel(PlaneKernel(material, 1)), Kernel(StripKernel(material, 1.5))}) {
    const ChebyshevRolling reference(kernel, bound);
    for (const Basis& basis : {constant_basis(), linear_basis(), quadratic_basis()}) {
      auto rolling = for_all_sizes(kernel, bound, basis);
      for (const double stick_ratio : {0.1, 0.6, 0.95}) {
        const Errors errors = errors_of(reference, rolling, stick_ratio);
        EXPECT_NEAR(fitted_order(sizes, errors.force), 2, 0.1) << basis.name() << stick_ratio;
      }
    }
  }
}

// Hertz's bound on a strip is not Carter's problem.
TEST(CalibratedOrder, SoItIsForHertzOnAStrip) {
  const HertzBound bound(1, 1);
  const StripKernel kernel(material, 1);
  const ChebyshevRolling reference(kernel, bound);
  auto rolling = for_all_sizes(kernel, bound, constant_basis());
  for (const double stick_ratio : {0.2, 0.6, 0.9}) {
    const Errors errors = errors_of(reference, rolling, stick_ratio);
    EXPECT_NEAR(fitted_order(sizes, errors.force), 2, 0.1) << stick_ratio;
  }
}

}  // namespace
}  // namespace microslip
