// SPDX-License-Identifier: GPL-3.0-or-later
// Steps that begin under given tractions, and tables of such tractions.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "microslip/patch/patch_rolling.hpp"
#include "microslip/patch/standard_patch.hpp"
#include "microslip/patch/steady_patch.hpp"
#include "microslip/patch/traction_table.hpp"

namespace microslip::patch_start_test {

using Eigen::Index;
using Eigen::MatrixX2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

SteadyPatch circle(Index size) {
  return {.material = {1, 0.28},
          .bound = EllipticBound(1, 1, 1),
          .rows = size,
          .elements = size,
          .load = {}};
}

PatchLoad load_of(double along, double across, double spin, bool by_force) {
  return {{{by_force, along}, {by_force, across}, {false, spin}}};
}

double largest_difference(const MatrixX2d& one, const MatrixX2d& other) {
  return (one - other).rowwise().norm().maxCoeff();
}

// After a shift from rest the material remembers what its displacements are by the tractions alone:
// where it sticks they are the shift, and where it slipped they are recorded. Only values between cells
// differ, by 1.3e-3 of full sliding at most.
TEST(PatchStart, RollsOnAsAfterTheShiftThatMadeItsTractions) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int sample = 0; sample < 6; ++sample) {
    const PatchLoad load =
        load_of(0.5 * uniform(random), 0.5 * uniform(random), 0.3 * uniform(random), false);
    PatchRolling shifted(circle(10)), started(circle(10));
    const double full = started.full_sliding();
    const PatchLoad shift =
        load_of(0.6 * full * uniform(random), 0.6 * full * uniform(random), 0, true);
    shifted.shift(shift);
    started.start_from(shifted.tractions());
    EXPECT_LT((started.resultants() - shifted.resultants()).norm(), 1e-8);
    EXPECT_LT(largest_difference(started.tractions(), shifted.tractions()), 1e-8);
    EXPECT_NEAR(started.elastic_energy(), shifted.elastic_energy(), 1e-9);
    for (int i = 0; i < 5; ++i) {
      shifted.roll(0.13, load);
      started.roll(0.13, load);
      EXPECT_LT((started.resultants() - shifted.resultants()).norm(), 2e-3 * full) << i;
    }
  }
}

// A contact of another size than the problem's is the problem of that size.
TEST(PatchStart, IsThatOfAProblemOfTheSameSize) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int sample = 0; sample < 5; ++sample) {
    const ContactScale contact{.half_width = 1 + 0.5 * uniform(random),
                               .bound = 1 + 0.5 * uniform(random)};
    SteadyPatch of_size = circle(8);
    of_size.bound = EllipticBound(contact.half_width, contact.half_width, contact.bound);
    PatchRolling one(circle(8), contact), other(of_size);
    const double full = one.full_sliding();
    MatrixX2d tractions(64, 2);
    tractions << 0.6 * uniform(random) * other.bound(), 0.6 * uniform(random) * other.bound();
    for (PatchRolling* rolling : {&one, &other}) rolling->start_from(tractions);
    EXPECT_LT((one.resultants() - other.resultants()).norm(), 1e-12 * full);
    for (int i = 0; i < 3; ++i) {
      for (PatchRolling* rolling : {&one, &other})
        rolling->roll(0.2, load_of(0.3, -0.2, 0.1, false));
      EXPECT_LT((one.resultants() - other.resultants()).norm(), 1e-7 * full);
    }
  }
}

// The direct scheme knows nothing but its tractions.
TEST(PatchStart, OfRectanglesRollsOnToTheLastDigits) {
  const StandardPatch problem{
      .material = {1, 0.28}, .bound = EllipticBound(1, 1, 1), .elements = 12, .rows = 12};
  RectangleRolling one(problem), other(problem);
  one.shift(load_of(0.5, -0.4, 0, true));
  for (int i = 0; i < 3; ++i) one.roll(0.1, load_of(0.2, 0.1, 0.3, false));
  other.start_from(one.tractions());
  EXPECT_LT((other.resultants() - one.resultants()).norm(), 1e-12);
  EXPECT_EQ(other.motion(), Vector3d(0, 0, 0));
  EXPECT_EQ(other.slip().norm(), 0);
  for (int i = 0; i < 3; ++i) {
    for (RectangleRolling* rolling : {&one, &other}) {
      rolling->roll(0.1, load_of(0.2, 0.1, 0.3, false));
    }
    EXPECT_LT(largest_difference(other.tractions(), one.tractions()), 1e-7);
  }
}

TEST(PatchStart, StaysInTheTractionsOfSteadyRolling) {
  SteadyPatch problem = circle(12);
  problem.load = load_of(0.35, 0.2, 0.2, false);
  const SteadyPatchSolution steady = solve_steady(problem);
  PatchRolling rolling(problem);
  rolling.start_from(steady.traction);
  const double full = rolling.full_sliding();
  for (int i = 0; i < 20; ++i) {
    rolling.roll(0.1, problem.load);
    EXPECT_LT((rolling.resultants() - steady.resultants).norm(), 1e-3 * full) << i;
  }
}

TEST(PatchStart, BeginsAnewInAContactOfAnotherSize) {
  PatchRolling rolling(circle(6), {.half_width = 1.5, .bound = 2});
  rolling.roll(0.3, load_of(0.1, 0, 0, false));
  rolling.set_contact({.half_width = 2, .bound = 0.5});
  MatrixX2d tractions(36, 2);
  tractions << PatchRolling(circle(6), {.half_width = 2, .bound = 0.5}).bound(), VectorXd::Zero(36);
  rolling.start_from(tractions);
  EXPECT_EQ(rolling.distance(), 0);
  EXPECT_NEAR(rolling.resultants()[0], rolling.full_sliding(), 2e-2 * rolling.full_sliding());
  EXPECT_THROW(rolling.start_from(1.001 * tractions), std::invalid_argument);
  EXPECT_THROW(rolling.start_from(tractions.topRows(35)), std::invalid_argument);
  EXPECT_NEAR(rolling.resultants()[0], rolling.full_sliding(), 2e-2 * rolling.full_sliding());
}

/// A grid of points of an ellipse with the half-widths 2 and 1, and the same number in each row.
struct Points {
  VectorXd x, y, bound;

  explicit Points(Index rows, Index columns, const PatchBound& of)
      : x(rows * columns), y(x), bound(x) {
    for (Index k = 0; k < rows; ++k) {
      const double at = -1 + (2 * static_cast<double>(k) + 1) / static_cast<double>(rows);
      for (Index i = 0; i < columns; ++i) {
        const double s = -1 + (2 * static_cast<double>(i) + 1) / static_cast<double>(columns);
        x[k * columns + i] = 2 * s * std::sqrt(1 - at * at);
        y[k * columns + i] = at;
        bound[k * columns + i] = of(0, std::asin(at), std::acos(s));
      }
    }
  }
};

// A part of the bound that is bilinear in s and y over 1 + s is the table's own function.
TEST(TractionTable, HasBilinearPartsOfTheBound) {
  const PatchBound bound = EllipticBound(2, 1, 3);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int sample = 0; sample < 20; ++sample) {
    Eigen::Matrix<double, 2, 4> of;
    for (double& value : of.reshaped()) value = 0.03 * uniform(random);
    const auto part = [&](double x, double y) -> Vector2d {
      const double s = x / (2 * std::sqrt(1 - y * y));
      return of * Eigen::Vector4d(1, s, y, s * y) / (1 + s);
    };
    const Points points(5 + sample % 3, 4 + sample % 5, bound);
    MatrixX2d tractions(points.x.size(), 2);
    for (Index i = 0; i < points.x.size(); ++i) {
      tractions.row(i) = points.bound[i] * part(points.x[i], points.y[i]);
    }
    const TractionTable table(bound, points.x, points.y, tractions);
    EXPECT_EQ(table.left_out(), 0);
    for (int probe = 0; probe < 20; ++probe) {
      const double y = 0.7 * uniform(random), s = 0.7 * uniform(random);
      const double x = 2 * s * std::sqrt(1 - y * y);
      EXPECT_LT((table(x, y) - part(x, y)).norm(), 1e-14) << x << ' ' << y;
    }
    for (Index i = 0; i < points.x.size(); ++i) {
      EXPECT_LT((table(points.x[i], points.y[i]) - part(points.x[i], points.y[i])).norm(), 1e-14);
    }
  }
}

// Rolling without slip has tractions that rise steeply over the bound towards the trailing edge.
TEST(TractionTable, KeepsForcesOnOtherRowsAndElements) {
  const auto steady = [](Index rows, Index elements) {
    return SteadyPatch{.material = {1, 0.28},
                       .bound = EllipticBound(1, 1, 1),
                       .rows = rows,
                       .elements = elements,
                       .load = load_of(0.02, 0.03, 0.02, false)};
  };
  const SteadyPatchSolution found = solve_steady(steady(12, 12));
  for (const auto& [rows, elements] : {std::pair<Index, Index>{9, 11}, {20, 18}}) {
    const SteadyPatch other = steady(rows, elements);
    PatchRolling rolling(other);
    const TractionTable table(other.bound, found.x, found.y, found.traction);
    MatrixX2d tractions(rolling.x().size(), 2);
    for (Index i = 0; i < tractions.rows(); ++i) {
      tractions.row(i) = rolling.bound()[i] * table(rolling.x()[i], rolling.y()[i]);
    }
    rolling.start_from(tractions);
    const Vector2d force = found.resultants.head<2>();
    EXPECT_LT((rolling.resultants().head<2>() - force).norm(), 0.015 * force.norm()) << rows;
  }
}

TEST(TractionTable, TakesWhatIsALittleAboveTheBoundAsTheBound) {
  const PatchBound bound = EllipticBound(2, 1, 3);
  const Points points(5, 5, bound);
  MatrixX2d tractions(25, 2);
  tractions << 1.005 * points.bound, VectorXd::Zero(25);
  EXPECT_EQ(TractionTable(bound, points.x, points.y, tractions)(0, 0), Vector2d(1, 0));
  tractions(12, 0) *= 1.02;
  EXPECT_THROW(TractionTable(bound, points.x, points.y, tractions), std::invalid_argument);
  EXPECT_EQ(TractionTable(bound, points.x, points.y, 0 * tractions)(1, 0.5), Vector2d(0, 0));
}

TEST(TractionTable, RefusesBadTables) {
  const PatchBound bound = EllipticBound(2, 1, 3);
  const Points points(4, 4, bound);
  const MatrixX2d none = MatrixX2d::Zero(16, 2);
  const auto message = [&](const VectorXd& x, const VectorXd& y, const MatrixX2d& tractions) {
    try {
      TractionTable(bound, x, y, tractions);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message(points.x, points.y, none), "");
  EXPECT_EQ(message(points.x, points.y, none.topRows(3)).find("number of rows = 16"), 0U);
  MatrixX2d bad = none;
  bad(6, 1) = std::nan("");
  EXPECT_EQ(message(points.x, points.y, bad).find("row 7: traction_y = nan"), 0U);
  bad(6, 1) = -4;
  EXPECT_EQ(message(points.x, points.y, bad).find("row 7: traction = 4: expected at most"), 0U);
  EXPECT_EQ(message(points.x.head(8), points.y.head(8), none.topRows(8))
                .find("number of y with tractions = 2: expected three or more"),
            0U);
  EXPECT_EQ(message(points.x * 9, points.y, none).find("number of "), 0U);
  VectorXd same = points.x;
  same[1] = same[0];
  EXPECT_NE(message(same, points.y, none).find("a point that is in no other row"),
            std::string::npos);
}

}  // namespace microslip::patch_start_test
