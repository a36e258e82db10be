// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/work.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "microslip/linalg/linear_operator.hpp"
#include "microslip/linalg/real_fft.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::work_test {

TEST(Work, CountsFromWhereItWasMade) {
  count_work(100);
  const WorkCount count;
  EXPECT_EQ(count.operations(), 0);
  count_work(7);
  count_work(2.0 / 3);  // rounded
  EXPECT_EQ(count.operations(), 8);
}

TEST(Work, ThreadsCountForThemselves) {
  const WorkCount count;
  std::thread([] { count_work(1000); }).join();
  EXPECT_EQ(count.operations(), 0);
}

TEST(Work, IsWatched) {
  std::vector<double> seen;
  {
    const WorkWatch watch([&](double operations) { seen.push_back(operations); });
    for (int i = 0; i < 6; ++i) count_work(4);
    std::thread([] { count_work(1000); }).join();
  }
  count_work(1000);
  EXPECT_EQ(seen.back(), 24);
}

TEST(Work, IsWatchedWhileItGoesOn) {
  std::atomic<double> seen = 0;
  const WorkWatch watch([&](double operations) { seen = operations; });
  count_work(5);
  while (seen != 5) std::this_thread::yield();
}

TEST(Work, OfATransformAndOfADenseProduct) {
  RealFft fft(1024);
  const WorkCount transform;
  fft.forward();
  EXPECT_EQ(transform.operations(), 2.5 * 1024 * 10);
  const LinearOperator matrix(Eigen::MatrixXd::Identity(30, 30));
  const WorkCount product;
  EXPECT_EQ((matrix * Eigen::VectorXd::Ones(30)).sum(), 30);
  EXPECT_EQ(product.operations(), 2 * 30 * 30);
}

double steady_work(Eigen::Index elements, Solver::Type type) {
  const WorkCount count;
  solve_steady({.contact = {PlaneKernel({1.44, 0.28}, 200), HertzBound(1, 1)},
                .grid = Grid({.half_width = 1, .elements = elements}),
                .method = Differences{},
                .load = PrescribedForce{1},
                .solver = {.type = type}});
  return count.operations();
}

// Factors of dense matrices grow as N^3 as long as the number of rounds does not change much; by
// FFT, N log N goes up and down with rounds and iterations.
TEST(Work, OfSteadyRollingGrowsAsItsSolver) {
  EXPECT_EQ(steady_work(100, Solver::Type::dense), steady_work(100, Solver::Type::dense));
  const double dense =
      steady_work(400, Solver::Type::dense) / steady_work(200, Solver::Type::dense);
  EXPECT_GT(dense, 5);
  EXPECT_LT(dense, 11);
  const double fft = steady_work(16000, Solver::Type::fft) / steady_work(1000, Solver::Type::fft);
  EXPECT_GT(fft, 10);
  EXPECT_LT(fft, 50);
}

double work_of_steps(double step_ratio) {
  const Eigen::Index n = 400;
  const double dx = 2.0 / static_cast<double>(n);
  TransientRolling rolling({.contact = {StripKernel({1.44, 0.28}, 2), HertzBound(1, 1)},
                            .grid = Grid({.half_width = 1, .elements = n}),
                            .basis = constant_basis(),
                            .scheme = Remembered{}},
                           CattaneoShift{-0.7});
  const WorkCount count;
  for (int k = 0; k < 200; ++k) rolling.step(step_ratio * dx, PrescribedForce{-0.7});
  return count.operations();
}

// 1.2e8. Factors of all entries, or inverses that serve one change only, would make it half or
// twice as many more.
TEST(Work, OfStepsOfLargeContactsIsThatOfFewInversesByFft) { EXPECT_LT(work_of_steps(0.3), 1.5e8); }

}  // namespace microslip::work_test
