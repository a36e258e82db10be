// SPDX-License-Identifier: GPL-3.0-or-later
// Patches that lose contact or friction, and touch anew: a start at rest in the same place, the
// similarity of contacts that grow from nothing, mirror images, and contacts that are next to nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "microslip/patch/patch_rolling.hpp"
#include "microslip/support/require.hpp"

namespace microslip::lost_patch_test {

using Eigen::Vector3d;

constexpr ContactScale none{.half_width = 0, .bound = 0};

SteadyPatch ellipse() {
  return {.material = {1, 0.28}, .bound = EllipticBound(1.3, 0.8, 1), .rows = 7, .elements = 10};
}

PatchLoad motion(double creepage, double lateral_creepage, double spin) {
  return {{{false, creepage}, {false, lateral_creepage}, {false, spin}}};
}

double part_of(const Vector3d& difference, const PatchRolling& rolling) {
  return difference.cwiseAbs().maxCoeff() / rolling.full_sliding();
}

double difference(const PatchRolling& one, const PatchRolling& other) {
  return part_of(one.resultants() - other.resultants(), other);
}

/// Hertz's contact under a load over the problem's.
ContactScale loaded(double load) { return hertz_point_scale(load); }

/// Lets the load grow from nothing to that of the problem, in steps of equal length.
void grow(PatchRolling& rolling, double distance, int steps, const PatchLoad& load) {
  for (int i = 1; i <= steps; ++i) {
    rolling.set_contact(loaded(static_cast<double>(i) / steps));
    rolling.roll(distance / steps, load);
  }
}

PatchRolling rolled() {
  PatchRolling rolling(ellipse());
  for (int i = 0; i < 5; ++i) rolling.roll(0.3, motion(0.5, -0.3, 0.2));
  return rolling;
}

TEST(LostPatch, HasNoTractionsAndNoResultants) {
  PatchRolling rolling = rolled();
  const Vector3d before = rolling.resultants();
  const double stored = rolling.elastic_energy();
  const Vector3d motions(0.5, -0.3, 0.2);
  rolling.set_contact(none);
  rolling.roll(0.2, motion(0.5, -0.3, 0.2));
  EXPECT_EQ(rolling.resultants(), Vector3d(0, 0, 0));
  EXPECT_EQ(rolling.motion(), motions);
  EXPECT_EQ(rolling.tractions().cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(rolling.areas().sum(), 0);
  EXPECT_EQ(rolling.bound().maxCoeff(), 0);
  EXPECT_EQ(rolling.full_sliding(), 0);
  EXPECT_EQ(rolling.elastic_energy(), 0);
  EXPECT_NEAR(rolling.dissipation(), stored / 0.2 - before.dot(motions) / 2, 1e-12);
  EXPECT_EQ(rolling.jacobian(), Eigen::Matrix3d::Zero());
  EXPECT_EQ(rolling.evidence().violation(), 0);
  rolling.roll(3, motion(0.1, 0, 0));
  EXPECT_EQ(rolling.dissipation(), 0);
  EXPECT_NEAR(rolling.distance(), 4.7, 1e-14);
}

TEST(LostPatch, CarriesNoForceWhereBodiesDoNotTouch) {
  PatchRolling rolling = rolled();
  rolling.set_contact(none);
  const Vector3d before = rolling.resultants();
  try {
    rolling.roll(0.2, {{{true, -0.1}, {false, 0}, {false, 0}}});
    FAIL();
  } catch (const BadParameter& error) {
    EXPECT_EQ(std::string(error.what()),
              "force = -0.1: expected 0 where bodies do not touch, or have no friction");
  }
  EXPECT_EQ(rolling.resultants(), before);
  rolling.roll(0.2, {{{true, 0}, {false, 0.1}, {true, 0}}});
  EXPECT_EQ(rolling.motion(), Vector3d(0, 0.1, 0));
}

TEST(LostPatch, BeginsAtRestWhereItReturns) {
  const PatchLoad load = motion(0.4, 0.2, -0.3);
  for (const ContactScale& lost : {none, ContactScale{.half_width = 0, .bound = 1},
                                   ContactScale{.half_width = 0.7, .bound = 0}}) {
    PatchRolling rolling = rolled();
    rolling.set_contact(lost);
    for (const double dq : {0.3, 2.0, -0.6}) rolling.roll(dq, load);
    PatchRolling fresh(ellipse(), lost);
    for (PatchRolling* one : {&rolling, &fresh}) grow(*one, 1, 5, load);
    EXPECT_LT((rolling.tractions() - fresh.tractions()).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_NEAR(rolling.dissipation(), fresh.dissipation(), 1e-9);
    EXPECT_NEAR(rolling.distance(), 1.5 + 1.7 + 1, 1e-13);
  }
}

// How little nothing is has no influence.
TEST(LostPatch, BeginsLikeATinyContact) {
  for (const bool holds : {false, true}) {
    PatchLoad load = motion(0.4, 0.2, -0.3);
    const double held = -0.5 * largest_resultants(ellipse().bound, {})[0];
    if (holds) load[0] = {true, held};
    PatchRolling from_nothing(ellipse(), none), from_little(ellipse(), {1e-3, 1e-3});
    for (PatchRolling* one : {&from_nothing, &from_little}) {
      for (const double part : {0.25, 1.0}) {
        if (holds) load[0].value = part * held;
        one->set_contact(loaded(part));
        one->roll(0.6, load);
      }
    }
    EXPECT_LT(difference(from_nothing, from_little), 2e-3) << holds;
    EXPECT_LT((from_nothing.motion() - from_little.motion()).norm(),
              4e-3 * from_little.motion().norm());
  }
}

// A contact that grows in proportion to the distance rolled, under the same bound and motion, is
// similar to itself: steps of any length have the same force over the square of the size. Many small
// ones take in material at the trailing edge as a leading edge does, which is of first order.
TEST(LostPatch, IsSimilarToItselfWhereItGrowsEvenly) {
  for (const double distance : {0.3, 1.3, 3.0, 20.0}) {
    for (const double creepage : {1e-3, 0.3}) {
      std::vector<Vector3d> found;
      for (const int steps : {1, 2, 4, 16}) {
        PatchRolling rolling(ellipse(), none);
        for (int i = 1; i <= steps; ++i) {
          rolling.set_contact({.half_width = static_cast<double>(i) / steps, .bound = 1});
          rolling.roll(distance / steps, motion(creepage, creepage / 3, 0));
        }
        found.emplace_back(rolling.resultants());
      }
      const double most = found.front().head<2>().norm();
      for (const Vector3d& one : found) {
        const double change = (one - found.front()).cwiseAbs().maxCoeff() / most;
        EXPECT_LT(change, &one == &found.back() ? 0.06 : 0.02) << distance << ' ' << creepage;
      }
    }
  }
}

// Force and normal load rise together next to standstill, in a ratio below the friction coefficient:
// all sticks, and the shift is the integral of dF over the stiffness, which is as the size. With
// F ~ a^3 that is 3/2 of the shift of the whole contact (Mindlin and Deresiewicz).
TEST(LostPatch, TouchesAnewUnderAnObliqueLoad) {
  const SteadyPatch circle{
      .material = {1, 0.28}, .bound = EllipticBound(1, 1, 1), .rows = 8, .elements = 10};
  PatchRolling constant(circle);
  const double force = -0.3 * constant.full_sliding(), little = 0.03 * force;
  constant.shift({{{true, little}, {true, 0}, {true, 0}}});
  const double exact = 1.5 * constant.motion()[0] / little * force;
  const auto error = [&](int steps) {
    PatchRolling rolling(circle, none);
    double shift = 0;
    for (int i = 1; i <= steps; ++i) {
      const double part = static_cast<double>(i) / steps, dq = 1e-4 / steps;
      rolling.set_contact(loaded(part));
      rolling.roll(dq, {{{true, part * force}, {true, 0}, {true, 0}}});
      shift += dq * rolling.motion()[0];
    }
    return std::abs(shift / exact - 1);
  };
  const double coarse = error(8), fine = error(32);
  EXPECT_LT(fine, 0.04);
  EXPECT_LT(fine, 0.45 * coarse);
}

// The size grows with an infinite rate at first, so that steps which touch anew are of first order.
TEST(LostPatch, IsOfFirstOrderAfterItHasReturned) {
  const auto by = [](int steps) {
    PatchRolling rolling = rolled();
    rolling.set_contact(none);
    rolling.roll(0.2, motion(0, 0, 0));
    grow(rolling, 2, steps, motion(0.2, 0.1, 0.1));
    return Vector3d(rolling.resultants());
  };
  const Vector3d finest = by(64);
  const double scale = finest.norm();
  const double coarse = (by(4) - finest).norm() / scale, fine = (by(8) - finest).norm() / scale;
  EXPECT_LT(coarse, 0.06);
  EXPECT_LT(fine, 0.65 * coarse);
}

TEST(LostPatch, HasMirrorImages) {
  const auto run = [](double lateral_creepage, double spin, double direction) {
    PatchRolling rolling(ellipse());
    const PatchLoad load = motion(0.4, lateral_creepage, spin);
    for (int i = 0; i < 3; ++i) rolling.roll(direction * 0.4, load);
    rolling.set_contact(none);
    rolling.roll(direction * 0.2, load);
    rolling.roll(direction * 0.7, load);
    for (const double part : {0.3, 0.6, 1.0}) {
      rolling.set_contact(loaded(part));
      rolling.roll(direction * 0.3, load);
    }
    return rolling;
  };
  const PatchRolling one = run(0.2, 0.3, 1), across = run(-0.2, -0.3, 1), back = run(-0.2, 0.3, -1);
  EXPECT_GT(one.resultants().norm(), 0.1);
  const Vector3d mirrored = across.resultants().cwiseProduct(Vector3d(1, -1, -1));
  EXPECT_LT(part_of(mirrored - one.resultants(), one), 1e-8);
  const Vector3d turned = back.resultants().cwiseProduct(Vector3d(-1, 1, -1));
  EXPECT_LT(part_of(turned - one.resultants(), one), 1e-8);
  EXPECT_NEAR(back.distance(), -one.distance(), 1e-12);
}

TEST(LostPatch, IsLostAndReturnsWhileItStands) {
  PatchRolling rolling = rolled();
  const double stored = rolling.elastic_energy();
  const Vector3d before = rolling.resultants(), shift(0.3, 0.1, 0);
  rolling.set_contact(none);
  rolling.shift(motion(shift[0], shift[1], shift[2]));
  EXPECT_EQ(rolling.resultants(), Vector3d(0, 0, 0));
  EXPECT_NEAR(rolling.dissipation(), stored - before.dot(shift) / 2, 1e-12);
  PatchRolling held = rolling;
  rolling.set_contact({});
  rolling.shift(motion(0.1, 0, 0));
  EXPECT_EQ(rolling.motion(), Vector3d(0.1, 0, 0));
  EXPECT_LT(rolling.resultants().norm(), 1e-12);
  PatchRolling fresh(ellipse());
  const double force = -0.4 * fresh.full_sliding();
  const PatchLoad load{{{true, force}, {false, 0}, {false, 0}}};
  held.set_contact({});
  for (PatchRolling* one : {&held, &fresh}) one->shift(load);
  EXPECT_NEAR(held.resultants()[0], force, 1e-9);
  for (PatchRolling* one : {&held, &fresh}) one->roll(0.4, motion(0.2, 0, 0.1));
  EXPECT_LT(difference(held, fresh), 1e-9);
  EXPECT_NEAR(held.distance(), 1.9, 1e-13);
}

TEST(LostPatch, GoesOnFromASavedStateWithTheSameBits) {
  PatchRolling rolling = rolled();
  for (const double dq : {0.3, -0.2}) {
    rolling.set_contact(none);
    rolling.roll(dq, motion(0.1, 0, 0));
    PatchRolling restored(ellipse());
    restored.restore({rolling.save()});
    EXPECT_EQ(restored.contact(), none);
    for (PatchRolling* one : {&rolling, &restored}) grow(*one, 0.5, 3, motion(0.4, 0.2, -0.3));
    EXPECT_EQ(restored.resultants(), rolling.resultants());
    EXPECT_EQ(restored.tractions(), rolling.tractions());
    EXPECT_EQ(restored.save(), rolling.save());
  }
}

TEST(LostPatch, RefusesOtherSizes) {
  PatchRolling rolling(ellipse());
  for (const double bad : {-1.0, 1e-5, 1e3}) {
    EXPECT_THROW(rolling.set_contact({.half_width = bad, .bound = 1}), std::invalid_argument);
  }
  EXPECT_THROW(rolling.set_contact({.half_width = 1, .bound = -1}), std::invalid_argument);
  PatchRolling lost(ellipse(), none);
  EXPECT_THROW(lost.start_from(Eigen::MatrixX2d::Ones(70, 2)), std::invalid_argument);
  EXPECT_NO_THROW(lost.start_from(Eigen::MatrixX2d::Zero(70, 2)));
}

}  // namespace microslip::lost_patch_test
