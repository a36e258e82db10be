// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the allocations in a loop of steps.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cstdlib>
#include <memory>
#include <string>

#include "counted_malloc.hpp"
#include "microslip/linalg/real_fft.hpp"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/rolling/transient.hpp"
#include "stick_zones.hpp"

namespace microslip::transient_allocation_test {

template <class Work>
long allocations_in(const Work& work) {
  const long before = allocations();
  work();
  return allocations() - before;
}

TEST(Allocations, AreCountedWhoeverMakesThem) {
  std::unique_ptr<int> number;
  Eigen::VectorXd vector;
  void* volatile array = nullptr;  // or a compiler leaves out what nothing is done with
  EXPECT_EQ(allocations_in([&] { number = std::make_unique<int>(1); }), 1);
  EXPECT_EQ(allocations_in([&] { vector.resize(5); }), 1);
  EXPECT_EQ(allocations_in([&] { array = std::aligned_alloc(64, 128); }), 1);
  EXPECT_GE(allocations_in([] { RealFft(5000); }), 2);
  EXPECT_EQ(allocations_in([&] { vector.setZero(5); }), 0);
  std::free(array);
}

/// From the end of the first of some steps to the end of the last.
long allocations_between_steps(TransientRolling& rolling, int steps, double length,
                               const Load& load) {
  long before = -1;
  rolling.roll(steps * length, {length}, load, [&](const TransientState&) {
    if (before < 0) before = allocations();
  });
  return allocations() - before;
}

struct Case {
  std::string name;
  AdvectionScheme scheme;
  double step_ratio;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

class AllocationsOfAScheme : public testing::TestWithParam<Case> {
 protected:
  /// In 50 steps long after the start, under a force and under the creepage that goes with it.
  static void expect_none(const TractionBound& bound, Solver::Type solver, int zones) {
    const auto& [name, scheme, step_ratio] = GetParam();
    constexpr Eigen::Index n = 151;
    const PrescribedForce force{-0.5 * full_sliding_force(bound)};
    TransientRolling rolling({.contact = {PlaneKernel({1, 0.28}, 200), bound},
                              .grid = Grid({.half_width = 1, .elements = n}),
                              .basis = constant_basis(),
                              .scheme = scheme,
                              .solver = {.type = solver}},
                             CattaneoShift{force.value});
    const double length = step_ratio * 2 / static_cast<double>(n);
    const int warm_up = static_cast<int>(4 * n / step_ratio);
    EXPECT_GT(allocations_between_steps(rolling, warm_up, length, force), 0);
    EXPECT_EQ(allocations_between_steps(rolling, 50, length, force), 0);
    EXPECT_EQ(stick_zones(rolling.state().zones), zones);
    const PrescribedCreepage creepage{rolling.state().creepage};
    allocations_between_steps(rolling, warm_up, length, creepage);
    EXPECT_EQ(allocations_between_steps(rolling, 50, length, creepage), 0);
  }
};

TEST_P(AllocationsOfAScheme, AreNoneInStepsThatRepeat) {
  for (const Solver::Type solver : {Solver::Type::dense, Solver::Type::fft}) {
    expect_none(HertzBound(1, 1), solver, 1);
    expect_none(PolynomialBound(1, 1, Eigen::Vector3d(0.2, 0, 2)), solver, 2);
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, AllocationsOfAScheme,
                         testing::Values(Case{"direct", Direct{}, 1},
                                         Case{"direct, c = 0.7", Direct{}, 0.7},
                                         Case{"relaxed", Relaxed{1}, 0.3},
                                         Case{"relaxed_traction", RelaxedTraction{1}, 0.3},
                                         Case{"remembered", Remembered{}, 1},
                                         Case{"remembered, c = 0.3", Remembered{}, 0.3},
                                         Case{"remembered, c = 0.1", Remembered{}, 0.1},
                                         Case{"remembered, c = 2.5", Remembered{}, 2.5}));

/// An ellipse that has rolled.
PatchRolling rolled_ellipse() {
  PatchRolling rolling(
      {.material = {82000, 0.28}, .bound = EllipticBound(6, 4, 300), .rows = 6, .elements = 8});
  for (int i = 0; i < 30; ++i) rolling.roll(1, {{{false, 8e-4}, {false, 4e-4}, {false, 1e-4}}});
  return rolling;
}

TEST(Allocations, AreNoneWhereAnEllipseIsAssigned) {
  const PatchRolling rolling = rolled_ellipse();
  PatchRolling other = rolling;
  other.roll(1, {{{false, 2e-3}, {false, 0}, {false, 0}}});
  EXPECT_EQ(allocations_in([&] { other = rolling; }), 0);
  EXPECT_EQ(other.resultants(), rolling.resultants());
  EXPECT_EQ(other.distance(), rolling.distance());
}

TEST(Allocations, AreNoneInStepsOfAnEllipseThatRepeat) {
  PatchRolling rolling = rolled_ellipse();
  const PatchLoad load{{{false, 8e-4}, {false, 4e-4}, {false, 1e-4}}};
  EXPECT_EQ(allocations_in([&] {
              for (int i = 0; i < 20; ++i) rolling.roll(1, load);
            }),
            0);
}

}  // namespace microslip::transient_allocation_test
