// SPDX-License-Identifier: GPL-3.0-or-later
// Ellipses whose slip turns about a pole among cells that slip.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "microslip/patch/patch_grid.hpp"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/patch/steady_patch.hpp"
#include "microslip/reference/full_sliding.hpp"
#include "patch_slopes.hpp"

namespace microslip::turning_slip_test {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double full = 2 * pi / 3;

SteadyPatch ellipse(double ratio, double cells) {
  const EllipticBound bound(std::sqrt(ratio), 1 / std::sqrt(ratio), 1);
  const PatchGrid grid = fitting_grid(PatchBound(bound).shape(), cells);
  return {.material = {1, 0.28}, .bound = bound, .rows = grid.rows, .elements = grid.elements};
}

/// The motion that turns about a place.
Vector3d turning(double spin, double x, double y) { return {spin * y, -spin * x, spin}; }

/// Over full sliding, and over full sliding by the size.
Vector3d forces(SteadyPatchSolver& solver, const Vector3d& motion) {
  return solver.solve(rolling_by(motion)).resultants / full;
}

class Places {
 public:
  explicit Places(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }

 private:
  std::mt19937 engine_;
};

// The whole contact slides, and elastic slip is nothing: the forces are integrals in closed form.
TEST(TurningSlip, HasTheForcesOfFullSlidingAboutAPole) {
  Places places(5);
  for (const double ratio : {0.7, 1.0, 1.8}) {
    double squares[2] = {0, 0};
    int solver = 0;
    std::vector<Vector3d> motions;
    for (int i = 0; i < 8; ++i) {
      motions.push_back(turning(i % 2 == 0 ? 1e6 : -1e6,
                                places.uniform(-0.6, 0.6) * std::sqrt(ratio),
                                places.uniform(-0.6, 0.6) / std::sqrt(ratio)));
    }
    for (const double cells : {9.0, 18.0}) {
      SteadyPatchSolver patch(ellipse(ratio, cells), false);
      for (const Vector3d& motion : motions) {
        const Vector3d error = forces(patch, motion) - full_sliding(ratio, motion);
        squares[solver] += error.squaredNorm();
        EXPECT_LT(error.norm(), 0.7 / cells / cells) << ratio << ' ' << motion.transpose();
      }
      ++solver;
    }
    EXPECT_GT(std::log2(squares[0] / squares[1]) / 2, 1.8) << ratio;
  }
}

// With directions at centres, forces jump by up to 6 % here as the pole passes a cell.
TEST(TurningSlip, ChangesEvenlyAsThePoleMovesOverCells) {
  for (const double spin : {6.0, 30.0}) {
    SteadyPatchSolver patch(ellipse(1, 10), false);
    Vector3d last, before;
    double bend = 0;
    constexpr int steps = 240;
    for (int i = 0; i <= steps; ++i) {
      const double at = 0.7 * (2.0 * i / steps - 1);
      const Vector3d now = forces(patch, turning(spin, 0.3 * at, at));
      if (i >= 2) bend = std::max(bend, (now - 2 * last + before).norm());
      before = last;
      last = now;
    }
    EXPECT_LT(bend, 1e-3) << spin;
  }
}

TEST(TurningSlip, HasTheJacobianOfItsForces) {
  Places places(7);
  int turns = 0;
  for (const double ratio : {0.8, 1.5}) {
    SteadyPatchSolver patch(ellipse(ratio, 9), false);
    for (int i = 0; i < 8; ++i) {
      const double spin = std::copysign(places.uniform(3, 20), places.uniform(-1, 1));
      const Vector3d motion =
          turning(spin, places.uniform(-0.6, 0.6) * std::sqrt(ratio), places.uniform(-0.6, 0.6));
      patch.solve(rolling_by(motion));
      const Matrix3d jacobian = patch.jacobian();
      const auto found = slopes_of(patch, motion, 1e-5);
      if (!found) continue;
      ++turns;
      EXPECT_LT((*found - jacobian).norm(), 1e-5 * jacobian.norm())
          << ratio << ' ' << motion.transpose();
    }
  }
  EXPECT_GT(turns, 12);
}

// With directions at centres, forces were off by up to 2.5 % of full sliding in the short steps here,
// and by up to 14 % in the long ones, as slip had its mean direction on the way of a step.
TEST(TurningSlip, IsSteadyInTheEndOfStepsOfAnyLength) {
  for (const double spin : {6.0, 30.0}) {
    for (const auto& [x, y] : {std::pair{0.05, 0.0}, {0.3, 0.2}, {-0.4, 0.5}}) {
      SteadyPatch patch = ellipse(1, 10);
      patch.load = rolling_by(turning(spin, x, y));
      const Vector3d steady = solve_steady(patch).resultants;
      for (const auto& [step, most] : {std::pair{0.1, 2e-3}, {0.25, 1.5e-2}, {0.5, 4e-3}}) {
        PatchRolling steps(patch);
        for (double q = 0; q < 6; q += step) steps.roll(step, patch.load);
        EXPECT_LT((steps.resultants() - steady).norm() / full, most)
            << spin << ' ' << x << ' ' << y << ", steps of " << step;
      }
    }
  }
}

// Newton's method alternated between two states in one of these steps.
TEST(TurningSlip, RollsOnAsAStickZoneAboutThePoleEnds) {
  SteadyPatch patch = ellipse(1, 10);
  const PatchLoad load = rolling_by(turning(2, -0.4, 0.5));
  PatchRolling steps(patch);
  for (int i = 0; i < 60; ++i) ASSERT_NO_THROW(steps.roll(0.03, load)) << i;
}

}  // namespace microslip::turning_slip_test
