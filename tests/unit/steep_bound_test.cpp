// SPDX-License-Identifier: GPL-3.0-or-later
// Steady rolling under bounds that are steep within the contact or at its edges.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "microslip/friction/sliding_field.hpp"
#include "microslip/rolling/chebyshev_rolling.hpp"
#include "microslip/rolling/inverted_rolling.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::steep_bound_test {

using Eigen::VectorXd;

const Material steel{82000, 0.28};
constexpr double half_width = 5;

TabulatedBound table(std::initializer_list<double> x, std::initializer_list<double> bound) {
  const auto n = static_cast<Eigen::Index>(x.size());
  return {half_width, Eigen::Map<const VectorXd>(x.begin(), n),
          Eigen::Map<const VectorXd>(bound.begin(), n)};
}

SteadySolution solve(const TractionBound& bound, double creepage, Eigen::Index n,
                     const SteadyMethod& method, const Kernel& kernel = StripKernel(steel, 10)) {
  return solve_steady({.contact = {kernel, bound},
                       .grid = Grid({.half_width = half_width, .elements = n}),
                       .basis = constant_basis(),
                       .method = method,
                       .load = PrescribedCreepage{creepage}});
}

// Where the bound is not zero at the leading edge, full sliding has an infinite creepage.
TEST(SteepBound, MayEndAtTheEdges) {
  for (const TabulatedBound& bound :
       {table({-5, 0, 5}, {0, 100, 50}), table({-5, 0, 5}, {50, 100, 0}),
        table({-5, 0, 5}, {50, 100, 50}), table({-5, 5}, {80, 80})}) {
    for (const double creepage : {1e-5, 1e-4, 5e-4, 1e-3, 2e-3, -1e-3}) {
      const double force = solve(bound, creepage, 100, Inversion{}).force;
      const double coarse = solve(bound, creepage, 400, Differences{}).force;
      const double fine = solve(bound, creepage, 800, Differences{}).force;
      EXPECT_NEAR(force / (2 * fine - coarse), 1, 0.01) << creepage;
    }
    for (const double creepage : {0.1, 1.0, 100.0}) {
      EXPECT_NEAR(solve(bound, creepage, 100, Inversion{}).force, -bound.total(),
                  0.01 * bound.total())
          << creepage;
    }
  }
}

// Differences over 1e-6 mm must keep their digits: noise of the strain once left no root.
TEST(LongRunsOfSteepBounds, HaveNoNoiseWhereTheyAreSteep) {
  const TabulatedBound bound = table({-5, -2.9, -2.899999, 5}, {0, 100, 20, 0});
  for (const Eigen::Index n : {20, 50, 100}) {
    for (const double creepage : {1e-5, 1.3e-5, 1.5e-5, 1.62e-5, 2e-5, 1e-4, 1.6e-4}) {
      for (const Kernel& kernel : {Kernel(StripKernel(steel, 10)), Kernel(PlaneKernel(steel, 10)),
                                   Kernel(StripKernel(steel, 1))}) {
        EXPECT_NO_THROW(solve(bound, creepage, n, Inversion{}, kernel)) << n << ' ' << creepage;
      }
    }
  }
}

// From adhesion everywhere the search found no way to it.
TEST(KnownEdge, SlidesFullyUnderALargeCreepage) {
  const HertzBound bound(half_width, 300);
  for (const Eigen::Index n : {40, 100, 250}) {
    for (const double creepage : {0.006, 0.01, 0.1, -0.1}) {
      const double edge = ChebyshevRolling(StripKernel(steel, 10), bound)
                              .solve(PrescribedCreepage{creepage})
                              .displacement(half_width);
      const SteadySolution s =
          solve(bound, creepage, n, Differences{.step_ratio = 1, .edge_displacement = edge});
      EXPECT_EQ(s.adhesion_elements(), 0) << n << ' ' << creepage;
      EXPECT_NEAR(s.force, creepage > 0 ? -bound.total() : bound.total(), 0.01 * bound.total());
    }
  }
}

}  // namespace microslip::steep_bound_test
