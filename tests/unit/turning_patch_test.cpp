// SPDX-License-Identifier: GPL-3.0-or-later
// Patches that roll forth and back: mirror images, the standard scheme, shifts, and steady rolling.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "microslip/patch/patch_rolling.hpp"
#include "microslip/patch/standard_patch.hpp"

namespace microslip::turning_patch_test {

using Eigen::Index;
using Eigen::MatrixX2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

SteadyPatch patch(const PatchBound& bound, Index rows, Index elements) {
  return {.material = {1, 0.28}, .bound = bound, .rows = rows, .elements = elements};
}

SteadyPatch ellipse(Index rows, Index elements) {
  return patch(EllipticBound(1.3, 0.8, 1), rows, elements);
}

/// A patch whose edges differ, or its mirror image.
SteadyPatch skew(bool is_mirrored) {
  const VectorXd y = VectorXd::LinSpaced(9, -0.8, 0.9);
  VectorXd trailing(9), leading(9);
  for (Index i = 0; i < 9; ++i) {
    const double t = (y[i] - 0.05) / 0.85, half = std::sqrt(std::max(0.0, 1 - t * t));
    const double middle = 0.3 * t - 0.2 * t * t;
    trailing[i] = middle - half;
    leading[i] = middle + half;
  }
  const PatchShape shape({is_mirrored ? Lobe(y, -leading, -trailing) : Lobe(y, trailing, leading)});
  return patch(PatchBound(shape, 1), 7, 8);
}

/// An ellipse with a bound that is higher in front, or its mirror image.
SteadyPatch uneven(bool is_mirrored) {
  const PatchShape shape = PatchShape::ellipse(1, 1);
  std::vector<Eigen::Vector3d> points;
  for (double y = -0.9; y < 0.91; y += 0.1) {
    for (double x = -0.95; x < 0.96; x += 0.1) {
      const double square = 1 - x * x - y * y;
      if (square > 0.02) points.emplace_back(x, y, std::sqrt(square) * (1 + 0.4 * x));
    }
  }
  VectorXd x(points.size()), y(points.size()), values(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto k = static_cast<Index>(i);
    x[k] = is_mirrored ? -points[i][0] : points[i][0];
    y[k] = points[i][1];
    values[k] = points[i][2];
  }
  return patch(PatchBound(shape, BoundTable(shape, x, y, values)), 6, 8);
}

PatchLoad motion(double creepage, double lateral_creepage, double spin) {
  return {{{false, creepage}, {false, lateral_creepage}, {false, spin}}};
}

/// The load in the mirror, x' = -x.
PatchLoad mirrored(PatchLoad load, bool rolls) {
  const Vector3d motions = rolls ? Vector3d(1, -1, 1) : Vector3d(-1, 1, -1);
  const Vector3d resultants(-1, 1, -1);
  for (std::size_t j = 0; j < 3; ++j) {
    load[j].value *= (load[j].by_resultant ? resultants : motions)[static_cast<Index>(j)];
  }
  return load;
}

/// The same cells in the mirror.
VectorXd mirrored(const VectorXd& of_cells, Index elements) {
  VectorXd seen = of_cells;
  for (Index i = 0; i < seen.size(); i += elements)
    std::reverse(seen.data() + i, seen.data() + i + elements);
  return seen;
}

double largest(const Eigen::MatrixXd& difference) { return difference.cwiseAbs().maxCoeff(); }
double mean_of(const Eigen::MatrixXd& difference) { return difference.cwiseAbs().mean(); }

void expect_mirror_images(const SteadyPatch& one, const SteadyPatch& other, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  PatchRolling forth(one), back(other);
  const double full = forth.full_sliding();
  const Index n = one.elements;
  PatchLoad load;
  double sign = 1;
  for (int i = 0; i < 14; ++i) {
    if (i % 3 == 0) {
      for (PatchComponent& component : load) {
        component = {.by_resultant = uniform(0, 1) < 0.25, .value = uniform(-0.5, 0.5)};
        if (component.by_resultant) component.value *= 0.4 * full;
      }
    }
    if (i % 4 == 3) sign = -sign;
    if (i % 6 == 5) {
      PatchLoad shift = load;
      for (PatchComponent& component : shift) {
        if (!component.by_resultant) component.value *= 0.1;
      }
      forth.shift(shift);
      back.shift(mirrored(shift, false));
      ASSERT_LT(largest(forth.motion() - back.motion().cwiseProduct(Vector3d(-1, 1, -1))), 1e-6);
    } else {
      const double dq = sign * std::exp(uniform(-4, -1));
      forth.roll(dq, load);
      back.roll(-dq, mirrored(load, true));
      ASSERT_LT(largest(forth.motion() - back.motion().cwiseProduct(Vector3d(1, -1, 1))), 1e-6);
      ASSERT_LT(largest(forth.slip().col(0) - mirrored(back.slip().col(0), n)), 1e-5) << i;
      ASSERT_LT(largest(forth.slip().col(1) + mirrored(back.slip().col(1), n)), 1e-5) << i;
    }
    ASSERT_LT(largest(forth.resultants() - back.resultants().cwiseProduct(Vector3d(-1, 1, -1))),
              1e-7 * full)
        << i;
    ASSERT_LT(largest(forth.tractions().col(0) + mirrored(back.tractions().col(0), n)), 1e-6) << i;
    ASSERT_LT(largest(forth.tractions().col(1) - mirrored(back.tractions().col(1), n)), 1e-6) << i;
    ASSERT_NEAR(forth.distance(), -back.distance(), 1e-14);
    ASSERT_NEAR(forth.dissipation(), back.dissipation(), 1e-6 * full) << i;
    ASSERT_NEAR(forth.elastic_energy(), back.elastic_energy(), 1e-7 * full) << i;
  }
  EXPECT_LT(largest(forth.x() + mirrored(back.x(), n)), 1e-14);
  EXPECT_LT(largest(forth.y() - back.y()), 1e-14);
  EXPECT_LT(largest(forth.bound() - mirrored(back.bound(), n)), 1e-12);
}

TEST(TurningPatch, HasMirrorImages) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    expect_mirror_images(ellipse(6, 8), ellipse(6, 8), seed);
    expect_mirror_images(skew(false), skew(true), seed);
    expect_mirror_images(uneven(false), uneven(true), seed);
  }
}

/// Rolls forth, to partial slip.
PatchRolling rolled_forth(const SteadyPatch& problem) {
  PatchRolling rolling(problem);
  for (int i = 0; i < 12; ++i) rolling.roll(0.1, motion(0.35, 0.2, 0.3));
  return rolling;
}

TEST(TurningPatch, ChangesNextToNothingOnTheSpot) {
  std::vector<double> once, twice;
  for (const Index n : {8, 12, 16}) {
    PatchRolling rolling = rolled_forth(ellipse(n, n));
    const MatrixX2d before = rolling.tractions();
    const Vector3d resultants = rolling.resultants();
    rolling.roll(-1e-5, motion(0, 0, 0));
    once.push_back(mean_of(rolling.tractions() - before));
    EXPECT_LT(largest(rolling.resultants() - resultants) / rolling.full_sliding(), 1e-3) << n;
    rolling.roll(1e-5, motion(0, 0, 0));
    twice.push_back(mean_of(rolling.tractions() - before));
  }
  EXPECT_LT(once[0], 4e-4);
  EXPECT_LT(once[2], 2e-4);
  EXPECT_LT(twice[0], 8e-4);
  EXPECT_LT(twice[2], 4e-4);
}

/// The standard scheme rolls forth, and its mirror image forth again: back, that is.
std::vector<Vector3d> by_rectangles(Index elements) {
  const StandardPatch problem{.material = {1, 0.28},
                              .bound = EllipticBound(1.3, 0.8, 1),
                              .elements = elements,
                              .rows = elements,
                              .pressure = StandardPatch::Pressure::hertz};
  RectangleRolling forth(problem), back(problem);
  const int count = static_cast<int>(std::lround(1.3 / forth.element()));
  for (int i = 0; i < count; ++i) forth.roll(1.3 / count, motion(0.35, 0.2, 0.3));
  const MatrixX2d tractions = forth.tractions();
  MatrixX2d seen(tractions.rows(), 2);
  for (Index i = 0; i < seen.rows(); ++i) {
    for (Index j = 0; j < seen.rows(); ++j) {
      if (std::abs(forth.x()[i] + forth.x()[j]) > 1e-9) continue;
      if (std::abs(forth.y()[i] - forth.y()[j]) > 1e-9) continue;
      seen.row(j) << -tractions(i, 0), tractions(i, 1);
    }
  }
  back.start_from(seen);
  std::vector<Vector3d> found{forth.resultants()};
  for (int half = 0; half < 2; ++half) {
    for (int i = 0; i < count / 2; ++i) {
      back.roll(1.3 / count, mirrored(motion(0.3, -0.25, 0.4), true));
    }
    found.push_back(back.resultants().cwiseProduct(Vector3d(-1, 1, -1)));
  }
  return found;
}

// The standard scheme is of first order: 12 and 24 elements are extrapolated.
TEST(TurningPatch, HasTheLimitOfTheStandardScheme) {
  const auto coarse = by_rectangles(12), fine = by_rectangles(24);
  for (const Index n : {10, 14}) {
    PatchRolling rolling(ellipse(n, n));
    std::vector<Vector3d> found;
    for (int i = 0; i < 20; ++i) rolling.roll(0.065, motion(0.35, 0.2, 0.3));
    found.push_back(rolling.resultants());
    for (int half = 0; half < 2; ++half) {
      for (int i = 0; i < 10; ++i) rolling.roll(-0.065, motion(0.3, -0.25, 0.4));
      found.push_back(rolling.resultants());
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Vector3d limit = 2 * fine[i] - coarse[i];
      // The extrapolation is uncertain by a fraction of what it adds to the forces and the moment.
      EXPECT_LT(largest(found[i] - limit), 0.011 * rolling.full_sliding()) << n << ' ' << i;
      EXPECT_LT((found[i] - limit).norm(), 0.75 * (fine[i] - limit).norm()) << n << ' ' << i;
    }
  }
}

// A shift is the limit of short steps forth and back.
TEST(TurningPatch, TendsToShifts) {
  PatchRolling rolling = rolled_forth(ellipse(8, 10)), shifted = rolling;
  const double full = rolling.full_sliding();
  constexpr double dq = 1e-4;
  double sign = 1;
  for (int i = 0; i < 6; ++i) {
    sign = -sign;
    const Vector3d shift = 0.02 * Vector3d(i < 3 ? -1 : 1, 0.5, -0.3);
    const Vector3d creepage = shift / (sign * dq);
    rolling.roll(sign * dq, motion(creepage[0], creepage[1], creepage[2]));
    shifted.shift(motion(shift[0], shift[1], shift[2]));
    EXPECT_LT(largest(rolling.resultants() - shifted.resultants()) / full, 1e-3) << i;
    EXPECT_LT(mean_of(rolling.tractions() - shifted.tractions()), 0.01) << i;
  }
}

TEST(TurningPatch, TendsToSteadyRollingBackward) {
  SteadyPatch problem = skew(false);
  PatchRolling rolling = rolled_forth(problem);
  const PatchLoad load = motion(0.2, -0.1, 0.3);
  for (int i = 0; i < 150; ++i) rolling.roll(-0.1, load);
  SteadyPatch seen = skew(true);
  seen.load = mirrored(load, true);
  const SteadyPatchSolution steady = solve_steady(seen);
  PatchRolling forth(seen);
  for (int i = 0; i < 150; ++i) forth.roll(0.1, seen.load);
  const double full = rolling.full_sliding();
  const Vector3d signs(-1, 1, -1);
  EXPECT_LT(largest(rolling.resultants() - forth.resultants().cwiseProduct(signs)), 1e-6 * full);
  EXPECT_LT(largest(rolling.resultants() - steady.resultants.cwiseProduct(signs)), 1e-3 * full);
  EXPECT_NEAR(rolling.dissipation() / forth.dissipation(), 1, 1e-5);
  EXPECT_GT(rolling.resultants()[0], 0);  // bodies that roll forth have a force below 0
}

TEST(TurningPatch, HasDerivatives) {
  for (const bool shifts : {false, true}) {
    PatchRolling rolling = rolled_forth(skew(false));
    rolling.roll(-0.2, motion(0.1, 0.1, 0.1));
    const auto taken = [&](const Vector3d& of) {
      PatchRolling one = rolling;
      const PatchLoad load = motion(of[0], of[1], of[2]);
      shifts ? one.shift(load) : one.roll(-0.2, load);
      return one;
    };
    const Vector3d at = shifts ? Vector3d(0.02, 0.03, -0.02) : Vector3d(0.15, -0.2, 0.1);
    const Eigen::Matrix3d slopes = taken(at).jacobian();
    for (Index j = 0; j < 3; ++j) {
      const Vector3d change = 1e-6 * Vector3d::Unit(j);
      const Vector3d found =
          (taken(at + change).resultants() - taken(at - change).resultants()) / 2e-6;
      EXPECT_LT(largest(found - slopes.col(j)), 1e-4 * largest(slopes)) << shifts << j;
    }
  }
}

TEST(TurningPatch, GoesOnFromASavedStateToTheBit) {
  for (const SteadyPatch& problem : {ellipse(5, 6), skew(false), uneven(false)}) {
    PatchRolling rolling = rolled_forth(problem);
    rolling.roll(-0.2, motion(0.1, 0.2, 0));
    rolling.shift(motion(0.01, 0, 0));
    rolling.roll(-0.1, motion(0.1, 0.2, 0));
    const SavedState saved{rolling.save()};
    PatchRolling other(problem);
    other.restore(saved);
    EXPECT_EQ(other.save(), saved.text);
    EXPECT_EQ(distance_of(saved, problem), rolling.distance());
    EXPECT_NEAR(rolling.distance(), 0.9, 1e-12);
    for (const double dq : {-0.1, -0.1, 0.2, 0.1, -0.3}) {
      for (PatchRolling* one : {&rolling, &other}) one->roll(dq, motion(0.2, -0.1, 0.1));
      EXPECT_EQ(other.tractions(), rolling.tractions());
      EXPECT_EQ(other.slip(), rolling.slip());
      EXPECT_EQ(other.slips(), rolling.slips());
    }
    PatchRolling copy = rolling;
    copy.roll(0.1, motion(0, 0, 0));
    EXPECT_NE(copy.tractions(), rolling.tractions());
    copy = rolling;
    EXPECT_EQ(copy.tractions(), rolling.tractions());
    EXPECT_THROW(copy.roll(-0.1, motion(0, 1e9, 0)), std::invalid_argument);
    EXPECT_EQ(copy.tractions(), rolling.tractions());
  }
}

// Energy is lost over a cycle of forces on bodies that roll forth and back.
TEST(TurningPatch, LosesEnergyOverAClosedCycle) {
  for (const Index n : {8, 12}) {
    PatchRolling rolling(ellipse(n, n));
    const double full = rolling.full_sliding();
    double work = 0, lost = 0, before = 0;
    constexpr int steps = 16;
    for (int i = 0; i < 3 * steps; ++i) {
      if (i == 2 * steps) before = rolling.elastic_energy(), work = lost = 0;
      const double phase = 2 * pi * (i + 1) / steps, dq = i % steps < steps / 2 ? 0.1 : -0.1;
      const Vector3d from = rolling.resultants();
      rolling.roll(
          dq,
          {{{true, 0.5 * full * std::sin(phase)}, {true, 0.2 * full * std::sin(2 * phase)}, {}}});
      work -= dq * (from + rolling.resultants()).dot(rolling.motion()) / 2;
      lost += std::abs(dq) * rolling.dissipation();
      EXPECT_GT(rolling.dissipation(), -2e-3 * full) << i;
    }
    const double stored = rolling.elastic_energy() - before;
    EXPECT_LT(std::abs(work - lost - stored), 0.3 / static_cast<double>(n * n) * lost) << n;
  }
}

TEST(TurningPatch, NamesWhatIsPrescribed) {
  PatchRolling rolling(ellipse(5, 6));
  rolling.roll(-0.1, motion(0.1, 0, 0));
  const auto message = [&](const auto& action) -> std::string {
    try {
      action();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(
      message([&] { rolling.roll(-0.1, motion(0, 1e9, 0)); }).find("lateral_creepage = 1e+09"),
      std::string::npos);
  EXPECT_NE(message([&] { rolling.shift(motion(1e9, 0, 0)); }).find("creepage = 1e+09"),
            std::string::npos);
  EXPECT_NE(message([&] { rolling.roll(-1e9, motion(0, 0, 0)); }).find("dq = -1e+09: expected a "),
            std::string::npos);
}

}  // namespace microslip::turning_patch_test
