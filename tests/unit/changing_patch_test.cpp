// SPDX-License-Identifier: GPL-3.0-or-later
// A patch that grows and shrinks while it rolls, its energy, Jacobian, copies and saved states.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>

#include "microslip/linalg/lu_factors.hpp"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/patch/rectangles.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip::changing_patch_test {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr double full = 2 * pi / 3;

SteadyPatch circle(Index rows, Index elements, double peak = 1) {
  return {.material = {1, 0.28},
          .bound = EllipticBound(1, 1, peak),
          .rows = rows,
          .elements = elements};
}

PatchLoad motion(double creepage, double lateral_creepage, double spin) {
  return {{{false, creepage}, {false, lateral_creepage}, {false, spin}}};
}

/// Rolls by equal steps, while the contact follows a function of the distance.
void roll_to(PatchRolling& rolling, double distance, double step, const PatchLoad& load,
             const std::function<ContactScale(double)>& contact) {
  while (rolling.distance() < distance - 1e-9) {
    const double dq = std::min(step, distance - rolling.distance());
    rolling.set_contact(contact(rolling.distance() + dq));
    rolling.roll(dq, load);
  }
}

ContactScale waves(double distance) {
  return {.half_width = 1 + 0.1 * std::sin(2 * distance),
          .bound = 1 + 0.2 * std::sin(1.3 * distance)};
}

// Long after the contact has changed, only a cell at the threshold of slip may remember what it was.
TEST(ChangingPatch, ForgetsTheContactBefore) {
  const PatchLoad load = motion(0.1, -0.2, 0.3);
  PatchRolling rolling(circle(8, 12));
  roll_to(rolling, 5, 0.1, load, [](double distance) {
    const double part = std::min(1.0, distance / 3);
    return ContactScale{.half_width = 1 - 0.3 * part, .bound = 1 + 0.5 * part};
  });
  const SteadyPatch problem{.material = {1, 0.28},
                            .bound = EllipticBound(0.7, 0.7, 1.5),
                            .rows = 8,
                            .elements = 12,
                            .load = load};
  PatchRolling other(problem);
  for (PatchRolling* one : {&rolling, &other}) {
    for (int i = 0; i < 200; ++i) one->roll(0.1, load);
  }
  const double scale = other.full_sliding();
  EXPECT_NEAR(rolling.full_sliding(), scale, 1e-12);
  EXPECT_LT((rolling.resultants() - other.resultants()).cwiseAbs().maxCoeff(), 3e-4 * scale);
  EXPECT_LT((rolling.bound() - other.bound()).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((rolling.x() - other.x()).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(rolling.elastic_energy() / other.elastic_energy(), 1, 5e-3);
  EXPECT_NEAR(rolling.areas().sum(), pi * 0.49, 1e-3);
  EXPECT_LT((other.resultants() - solve_steady(problem).resultants).cwiseAbs().maxCoeff(),
            5e-4 * scale);
}

TEST(ChangingPatch, DoesNotDependOnTheStep) {
  const auto by = [](double step, double distance) {
    PatchRolling rolling(circle(6, 9));
    roll_to(rolling, distance, step, motion(0.15, 0.1, 0.3), waves);
    return Vector3d(rolling.resultants() / full);
  };
  for (const double distance : {0.8, 2.2}) {
    const Vector3d small = by(0.02, distance);
    for (const double step : {0.16, 0.08}) {
      EXPECT_LT((by(step, distance) - small).cwiseAbs().maxCoeff(), 1e-3 + 0.1 * step * step)
          << distance << ' ' << step;
    }
  }
}

/// A circle in which all sticks rolls by squares of constant tractions, with a step of a square: its
/// radius changes. nu = 0, along the rolling.
VectorXd forces_by_squares(Index across, const std::function<double(double)>& radius, int steps) {
  const double largest = 1.3, side = 2 * largest / static_cast<double>(across);
  const Rectangles box(side, side, Rectangles::Mask::Constant(across, across, true));
  const Index n = box.size();
  const auto displacements = [&](double ahead) {
    const RectangleInfluence influence(box, 0, {{1, ahead}});
    MatrixXd matrix(n, n);
    VectorXd unit = VectorXd::Zero(2 * n), values;
    for (Index i = 0; i < n; ++i) {
      unit[i] = 1;
      influence.apply(unit, values);
      matrix.col(i) = values.head(n);
      unit[i] = 0;
    }
    return matrix;
  };
  const MatrixXd here = displacements(0), ahead = displacements(1);
  VectorXd tractions = VectorXd::Zero(n), forces(steps);
  for (int s = 0; s < steps; ++s) {
    const double now = radius((s + 1) * side);
    std::vector<Index> within;
    for (Index i = 0; i < n; ++i) {
      if (std::hypot(box.x(i), box.y(i)) < now) within.push_back(i);
    }
    const VectorXd right = (ahead * tractions - VectorXd::Constant(n, side))(within);
    const VectorXd solved = LuFactors(here(within, within)).solve(right);
    tractions.setZero();
    tractions(within) = solved;
    forces[s] = solved.sum() * box.area();
  }
  return forces;
}

// Squares are of first order: the force of a constant circle is 4 % too large on 26 of them. Ratios to it are compared.
TEST(LongRunsOfChangingPatch, HaveTheForcesOfSquaresOfConstantTractions) {
  const auto grows = [](double distance) { return 1 + 0.1 * std::sin(1.2 * distance); };
  const auto stays = [](double) { return 1.0; };
  constexpr Index across = 20;
  constexpr int steps = 24;
  const VectorXd expected = forces_by_squares(across, grows, steps)
                                .cwiseQuotient(forces_by_squares(across, stays, steps));
  SteadyPatch problem{
      .material = {1, 0}, .bound = EllipticBound(1, 1, 1e4), .rows = 10, .elements = 12};
  const double step = 2.6 / across;
  const auto force_at = [&](int count, const std::function<double(double)>& radius) {
    PatchRolling rolling(problem);
    roll_to(rolling, count * step, step, motion(1, 0, 0), [&](double distance) {
      return ContactScale{.half_width = radius(distance), .bound = 1};
    });
    return rolling.resultants()[0];
  };
  for (const int count : {5, 10, 16, 24}) {
    EXPECT_NEAR(force_at(count, grows) / force_at(count, stays), expected[count - 1], 0.02)
        << count;
  }
}

TEST(ChangingPatch, RefusesBadContacts) {
  PatchRolling rolling(circle(4, 5));
  EXPECT_THROW(rolling.set_contact({.half_width = 1e-5, .bound = 1}), std::invalid_argument);
  EXPECT_THROW(rolling.set_contact({.half_width = 1, .bound = -1}), std::invalid_argument);
  EXPECT_THROW(rolling.set_contact({.half_width = 1, .bound = std::nan("")}),
               std::invalid_argument);
  rolling.set_contact({.half_width = 1.1, .bound = 1});
  EXPECT_THROW(rolling.shift(motion(0.1, 0, 0)), std::invalid_argument);
  rolling.set_contact({.half_width = 1, .bound = 0.5});
  rolling.shift(motion(10, 0, 0));
  EXPECT_NEAR(rolling.resultants()[0], -full / 2, 2e-2);
}

// Sudden changes of the size, faster than it rolls.
TEST(ChangingPatch, SolvesSuddenChanges) {
  PatchRolling rolling(circle(7, 8));
  for (const double size : {1.0, 1.5, 0.6, 0.62, 2.0, 0.3, 1.0}) {
    rolling.set_contact({.half_width = size, .bound = 1});
    ASSERT_NO_THROW(rolling.roll(0.05, motion(0.1, 0.1, 0.2))) << size;
    ASSERT_LT(rolling.resultants().head<2>().norm(), (1 + 1e-6) * rolling.full_sliding());
    ASSERT_TRUE(rolling.tractions().allFinite());
  }
}

// Steady rolling dissipates the power of the motion; from rest, less by what is stored.
TEST(PatchEnergy, BalancesInRolling) {
  const PatchLoad load = motion(0.1, -0.2, 0.3);
  PatchRolling rolling(circle(10, 14));
  double work = 0, lost = 0;
  while (rolling.distance() < 6 - 1e-9) {
    const Vector3d before = rolling.resultants();
    rolling.roll(0.1, load);
    work -= 0.1 * (before + rolling.resultants()).dot(rolling.motion()) / 2;
    lost += 0.1 * rolling.dissipation();
    EXPECT_GE(rolling.dissipation(), 0);
  }
  EXPECT_NEAR(work - lost, rolling.elastic_energy(), 1e-9);
  for (int i = 0; i < 150; ++i) rolling.roll(0.1, load);
  EXPECT_NEAR(rolling.dissipation() / -rolling.resultants().dot(rolling.motion()), 1, 1e-6);
  EXPECT_NEAR(rolling.evidence().dissipated / rolling.dissipation(), 1, 0.1);
}

// The work of the force is that of many small shifts.
TEST(PatchEnergy, OfAShiftIsTheWorkLessWhatIsStored) {
  PatchRolling one(circle(10, 12)), many(circle(10, 12));
  constexpr double force = 0.7 * full;
  one.shift({{{true, -force}, {}, {}}});
  double work = 0, lost = 0;
  constexpr int shifts = 40;
  for (int i = 0; i < shifts; ++i) {
    const double before = many.resultants()[0];
    many.shift({{{true, -force * (i + 1) / shifts}, {}, {}}});
    work -= (before + many.resultants()[0]) / 2 * many.motion()[0];
    lost += many.dissipation();
  }
  EXPECT_NEAR(one.dissipation() / (work - many.elastic_energy()), 1, 0.04);
  EXPECT_NEAR(lost / one.dissipation(), 1, 0.04);
}

TEST(PatchJacobian, IsTheLimitOfDifferences) {
  for (const PatchLoad& load : {motion(0.1, -0.2, 0.3), motion(1e-4, 2e-4, 1e-4)}) {
    PatchRolling rolling(circle(7, 9));
    for (int i = 0; i < 4; ++i) rolling.roll(0.15, load);
    PatchRolling last = rolling;
    last.roll(0.15, load);
    const Matrix3d jacobian = last.jacobian();
    for (std::size_t j = 0; j < 3; ++j) {
      const double change = 1e-6 * std::abs(load[0].value);
      PatchLoad more = load, less = load;
      more[j].value += change;
      less[j].value -= change;
      PatchRolling up = rolling, down = rolling;
      up.roll(0.15, more);
      down.roll(0.15, less);
      const Vector3d slope = (up.resultants() - down.resultants()) / (2 * change);
      EXPECT_LT((slope - jacobian.col(static_cast<Index>(j))).norm(), 1e-4 * jacobian.norm()) << j;
    }
  }
  EXPECT_THROW(PatchRolling(circle(4, 5)).jacobian(), std::logic_error);
}

TEST(PatchState, CopiesAndSavedOnesContinueWithTheSameBits) {
  PatchRolling rolling(circle(6, 8));
  rolling.shift({{{true, -0.3 * full}, {}, {}}});
  roll_to(rolling, 1, 0.13, motion(0.1, 0.05, 0.2), waves);
  const std::string text = rolling.save();
  PatchRolling copy = rolling, restored(circle(6, 8));
  restored.restore({text});
  EXPECT_EQ(restored.save(), text);
  EXPECT_EQ(restored.resultants(), rolling.resultants());
  EXPECT_EQ(restored.dissipation(), rolling.dissipation());
  EXPECT_EQ(distance_of({text}, circle(6, 8)), rolling.distance());
  for (PatchRolling* one : {&rolling, &copy, &restored}) {
    roll_to(*one, 2, 0.13, motion(-0.1, 0.05, 0.2), waves);
  }
  EXPECT_EQ(copy.resultants(), rolling.resultants());
  EXPECT_EQ(restored.resultants(), rolling.resultants());
  EXPECT_EQ(restored.jacobian(), rolling.jacobian());
}

// Steps that follow earlier ones in which the same cells slip take no new factors.
TEST(PatchState, SavedOnesFollowAsTheOriginalDoes) {
  PatchRolling rolling(circle(6, 8)), restored(circle(6, 8));
  const PatchLoad load = motion(0.1, 0.05, 0.2);
  for (int i = 0; i < 60; ++i) rolling.roll(0.1, load);
  restored.restore({rolling.save()});
  for (int i = 0; i < 3; ++i) {
    rolling.roll(0.1, load);
    restored.roll(0.1, load);
    EXPECT_EQ(restored.save(), rolling.save());
  }
}

// A force and a moment that friction carries each on its own, but not together.
TEST(PatchState, IsThatBeforeAStepThatThrows) {
  PatchRolling rolling(circle(5, 6));
  for (int i = 0; i < 8; ++i) rolling.roll(0.1, motion(0.1, 0.05, 0.2));
  const PatchRolling before = rolling;
  EXPECT_THROW(rolling.roll(0.1, {{{true, 0.98 * full}, {}, {true, 1.2}}}), NotConverged);
  EXPECT_EQ(rolling.dissipation(), before.dissipation());
  EXPECT_EQ(rolling.elastic_energy(), before.elastic_energy());
  EXPECT_EQ(rolling.resultants(), before.resultants());
  EXPECT_EQ(rolling.jacobian(), before.jacobian());
  EXPECT_EQ(rolling.distance(), before.distance());
}

TEST(PatchState, RefusesOtherTexts) {
  PatchRolling rolling(circle(4, 5)), other(circle(4, 6));
  rolling.roll(0.1, motion(0.1, 0, 0));
  std::string text = rolling.save();
  EXPECT_THROW(other.restore({text}), std::invalid_argument);
  EXPECT_THROW(rolling.restore({""}), std::invalid_argument);
  EXPECT_THROW(rolling.restore({"microslip state 3\n"}), std::invalid_argument);
  text[text.size() / 2] = text[text.size() / 2] == '1' ? '2' : '1';
  EXPECT_THROW(rolling.restore({text}), std::invalid_argument);
  EXPECT_EQ(rolling.distance(), 0.1);
}

}  // namespace microslip::changing_patch_test
