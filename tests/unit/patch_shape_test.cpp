// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts by their edges: lobes, bounds at points, and steady rolling on them beside ellipses,
// shifted and mirrored contacts, and the line contact.
#include "microslip/patch/patch_shape.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "microslip/patch/steady_patch.hpp"
#include "microslip/rolling/steady.hpp"

namespace microslip::patch_shape_test {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

/// An egg by a table: rows of y, from -height to height about y0.
struct Egg {
  double length = 0.8, height = 1.2, wider = 0.3, bent = 0.2, x0 = 0, y0 = 0;
  double power = 2;  ///< of a superellipse

  Lobe lobe(int rows) const {
    VectorXd y(rows), trailing(rows), leading(rows);
    for (int j = 0; j < rows; ++j) {
      const double u = j == 0 ? -1 : j == rows - 1 ? 1 : -1 + 2.0 * j / (rows - 1);
      const double half = length *
                          std::pow(std::max(0.0, 1 - std::pow(std::abs(u), power)), 1 / power) *
                          (1 + wider * u);
      const double middle = x0 + bent * u * u;
      y[j] = y0 + height * u;
      trailing[j] = middle - half;
      leading[j] = middle + half;
    }
    return {y, trailing, leading};
  }
  PatchShape shape(int rows = 21) const { return PatchShape({lobe(rows)}); }
};

PatchLoad rolling(double creepage, double lateral, double spin) {
  return {{{false, creepage}, {false, lateral}, {false, spin}}};
}

SteadyPatch patch_of(const PatchBound& bound, const PatchLoad& load, Index rows = 8,
                     Index elements = 8) {
  return {.material = {1, 0.28}, .bound = bound, .rows = rows, .elements = elements, .load = load};
}

Vector3d resultants(const SteadyPatch& patch) { return solve_steady(patch).resultants; }

/// A table of a function of x, y, at equal distances.
BoundTable table_of(const PatchShape& shape, double spacing,
                    const std::function<double(double, double)>& of) {
  std::vector<double> x, y, g;
  for (double v = shape.low(); v <= shape.high(); v += spacing) {
    for (double u = shape.trailing(); u <= shape.leading(); u += spacing) {
      x.push_back(u);
      y.push_back(v);
      g.push_back(of(u, v));
    }
  }
  const auto size = static_cast<Index>(x.size());
  const auto all = [&](const std::vector<double>& values) {
    return VectorXd(Eigen::Map<const VectorXd>(values.data(), size));
  };
  return {shape, all(x), all(y), all(g)};
}

TEST(PatchShape, OfATableIsTheEllipse) {
  const Egg ellipse{.wider = 0, .bent = 0};
  const PatchShape shape = ellipse.shape(6);
  EXPECT_NEAR(shape.area(), pi * 0.96, 1e-13);
  EXPECT_NEAR(shape.size(), std::sqrt(0.96), 1e-13);
  EXPECT_NEAR(shape.ratio(), 0.8 / 1.2, 1e-13);
  EXPECT_FALSE(shape.is_ellipse());
  const PatchLoad load = rolling(0.3, 0.2, 0.4);
  const Vector3d found = resultants(patch_of(PatchBound(shape, 1), load));
  const Vector3d expected = resultants(patch_of(EllipticBound(0.8, 1.2, 1), load));
  EXPECT_LT((found - expected).norm(), 1e-12);
  const PatchBound bound(shape, 1);
  EXPECT_NEAR(bound.total(), EllipticBound(0.8, 1.2, 1).total(), 1e-12);
  EXPECT_NEAR(bound.turning_moment(), EllipticBound(0.8, 1.2, 1).turning_moment(), 2e-7);
}

TEST(PatchShape, IsExactWhereItWidensLinearly) {
  const Lobe lobe = Egg{}.lobe(6);
  for (const double psi : {-1.5, -1.3, -0.7, 0.2, 1.2, 1.5}) {
    EXPECT_NEAR(lobe.row(psi).half_length, 0.8 * std::cos(psi) * (1 + 0.3 * std::sin(psi)), 1e-13);
  }
}

// Tables of few rows differ from those of many, the less the more rows.
TEST(PatchShape, IsTheBetterKnownTheMoreRowsATableHas) {
  const Egg egg{.power = 2.5};
  const PatchLoad load = rolling(0.3, 0.2, 0.4);
  const auto found = [&](int rows) {
    return resultants(patch_of(PatchBound(egg.shape(rows), 1), load));
  };
  const Vector3d exact = found(801);
  const double of10 = (found(11) - exact).norm(), of40 = (found(41) - exact).norm();
  EXPECT_LT(of10, 1e-2 * exact.norm());
  EXPECT_LT(of40, of10 / 4);
}

TEST(PatchShape, MayLieAnywhere) {
  const Egg egg, shifted{.x0 = 0.5, .y0 = -0.7};
  const double xi = 0.2, eta = 0.1, phi = 0.3;
  const SteadyPatchSolution found =
      solve_steady(patch_of(PatchBound(shifted.shape(), 1), rolling(xi, eta, phi)));
  const SteadyPatchSolution same = solve_steady(
      patch_of(PatchBound(egg.shape(), 1), rolling(xi + 0.7 * phi, eta + 0.5 * phi, phi)));
  const Vector3d moved(same.resultants[0], same.resultants[1],
                       same.resultants[2] + 0.5 * same.resultants[1] + 0.7 * same.resultants[0]);
  EXPECT_LT((found.resultants - moved).norm(), 1e-9);
  EXPECT_NEAR(found.dissipation, same.dissipation, 1e-9);
}

TEST(PatchShape, IsMirroredInThePlaneOfRolling) {
  const Egg egg, mirrored{.wider = -0.3};
  const Vector3d one = resultants(patch_of(PatchBound(egg.shape(), 1), rolling(0.2, 0.1, 0.3)));
  const Vector3d other =
      resultants(patch_of(PatchBound(mirrored.shape(), 1), rolling(0.2, -0.1, -0.3)));
  EXPECT_LT((one - Vector3d(other[0], -other[1], -other[2])).norm(), 1e-9);
}

// Two lobes influence each other the less the farther apart they are.
TEST(PatchShape, HasLobesThatAreContactsOfTheirOwnFarApart) {
  const auto difference = [](double distance) {
    const Egg one{.y0 = -distance / 2}, other{.length = 0.5, .height = 0.7, .y0 = distance / 2};
    const PatchLoad load = rolling(0.3, 0.2, 0);
    const PatchShape both({one.lobe(21), other.lobe(21)});
    const PatchBound bound = PatchBound(both, 1);
    const double longest = 0.5 / 0.8;  // of the bound of the smaller lobe
    const Vector3d sum = resultants(patch_of(PatchBound(one.shape(), 1), load, 12, 8)) +
                         resultants(patch_of(PatchBound(other.shape(), longest), load, 7, 8));
    return (resultants(patch_of(bound, load, 19, 8)) - sum).head<2>().norm() / sum.norm();
  };
  const double near = difference(2.2), far = difference(220);
  EXPECT_GT(near, 5e-3);
  EXPECT_LT(far, 1e-7);
}

TEST(PatchShape, SharesRowsByHeights) {
  const Egg one{.y0 = -3}, other{.height = 0.4, .y0 = 3};
  const PatchShape both({one.lobe(9), other.lobe(9)});
  const auto rows_of_second = [&](Index rows) {
    const JoinedRows joined(both, rows, 2);
    Index count = 0;
    for (Index k = 0; k < rows; ++k) count += joined.lobe(k) == 1;
    return count;
  };
  EXPECT_EQ(rows_of_second(40), 10);
  EXPECT_EQ(rows_of_second(8), 3);
  EXPECT_EQ(rows_of_second(2), 1);
  EXPECT_THROW(JoinedRows(both, 1, 2), std::invalid_argument);
  EXPECT_NEAR(JoinedRows(both, 40, 5).areas().sum(), both.area(), 1e-12);
}

TEST(PatchShape, HasNoChangeOfOneRowInEachLobe) {
  const PatchShape both({Egg{.y0 = -3}.lobe(9), Egg{.y0 = 3}.lobe(9)});
  const PatchLoad load = rolling(0.3, 0.2, 0);
  EXPECT_EQ(solve_steady_with_change(patch_of({both, 1}, load, 2, 4)).evidence.change, 1);
  EXPECT_LT(solve_steady_with_change(patch_of({both, 1}, load, 3, 4)).evidence.change, 0.5);
}

// One row between straight ends is the strip of the line contact, whose displacements are those at
// the middle of its width.
TEST(PatchShape, IsTheStripAsOneRowBetweenStraightEnds) {
  const Eigen::Vector2d y(-2, 2), edge(1, 1);
  const PatchShape shape({Lobe(y, -edge, edge)});
  EXPECT_NEAR(shape.area(), 8, 1e-12);
  const Material material{1, 0.28};
  for (const double creepage : {0.2, 0.6}) {
    const SteadyPatch patch{.material = material,
                            .bound = PatchBound(shape, 1),
                            .rows = 1,
                            .elements = 60,
                            .load = rolling(creepage, 0, 0)};
    const SteadyProblem line{.contact = {StripKernel(material, 4), HertzBound(1, 1)},
                             .grid = Grid({.half_width = 1, .elements = 200}),
                             .basis = constant_basis(),
                             .method = Inversion{},
                             .load = PrescribedCreepage{creepage}};
    EXPECT_NEAR(resultants(patch)[0] / 4, solve_steady(line).force, 2e-4) << creepage;
  }
}

TEST(BoundTable, IsHertzsBoundToTheSquareOfItsSpacing) {
  const EllipticBound hertz(2, 3, 5);
  const PatchShape ellipse = PatchShape::ellipse(2, 3);
  const auto errors = [&](double spacing) {
    const PatchBound bound(ellipse, table_of(ellipse, spacing, hertz));
    const Vector3d motion(0.3, 0.2, 0.2);
    const PatchLoad load = rolling(motion[0], motion[1], motion[2]);
    return Vector3d(bound.total() / hertz.total() - 1,
                    bound.turning_moment() / hertz.turning_moment() - 1,
                    (resultants(patch_of(bound, load)) - resultants(patch_of(hertz, load))).norm() /
                        hertz.total());
  };
  const Vector3d coarse = errors(0.4), fine = errors(0.1);
  EXPECT_LT(coarse.cwiseAbs().maxCoeff(), 2e-2);
  EXPECT_LT(fine.cwiseAbs().maxCoeff(), 2e-3);
}

TEST(BoundTable, IsLinearInItsSquareAndZeroAtTheEdges) {
  const PatchShape shape = PatchShape::ellipse(2, 1);
  VectorXd x(9), y(9), g(9);
  x << -1, 0, 1, -1, 0, 1, -1, 0, 1;
  y << -0.5, -0.5, -0.5, 0, 0, 0, 0.5, 0.5, 0.5;
  g << 1, 2, 1, 3, 4, 3, 1, 2, 1;
  const PatchBound bound(shape, BoundTable(shape, x, y, g));
  EXPECT_EQ(bound.peak(), 4);
  EXPECT_NEAR(bound(0, 0, pi / 2), 4, 1e-12);
  EXPECT_NEAR(bound(0, 0, std::acos(0.25)), std::sqrt(12.5), 1e-12);  // x = 0.5
  EXPECT_NEAR(bound(0, 0, std::acos(0.75)), std::sqrt(4.5), 1e-12);   // x = 1.5
  EXPECT_NEAR(bound(0, std::asin(0.25), pi / 2), std::sqrt(10), 1e-12);
  EXPECT_NEAR(bound(0, std::asin(0.75), pi / 2), std::sqrt(2), 1e-12);
}

// Where nothing slips, the bound has no part in the solution.
TEST(BoundTable, IsNotFeltWhereNothingSlips) {
  const PatchShape shape = Egg{}.shape();
  const auto solved = [&](double wave) {
    const PatchBound bound(shape, table_of(shape, 0.05, [&](double x, double y) {
                             return 1 + wave * std::sin(7 * x) * std::cos(9 * y);
                           }));
    return solve_steady(patch_of(bound, rolling(1e-3, 2e-3, 1e-3)));
  };
  const SteadyPatchSolution one = solved(0), other = solved(0.6);
  ASSERT_EQ(one.slip_area(), 0);
  ASSERT_EQ(other.slip_area(), 0);
  EXPECT_GT((one.bound - other.bound).norm(), 0.1);
  EXPECT_LT((one.resultants - other.resultants).norm(), 1e-10 * one.resultants.norm());
}

TEST(BoundTable, IsReachedInFullSliding) {
  const PatchShape shape = Egg{}.shape();
  const PatchBound bound(shape, table_of(shape, 0.04, [](double x, double y) {
                           return std::exp(-x * x - y * y / 2);
                         }));
  const SteadyPatchSolution solution = solve_steady(patch_of(bound, rolling(3e4, 4e4, 0), 20, 16));
  EXPECT_NEAR(solution.resultants[0], -0.6 * bound.total(), 5e-4 * bound.total());
  EXPECT_NEAR(solution.resultants[1], -0.8 * bound.total(), 5e-4 * bound.total());
  EXPECT_LT(solution.evidence.bound_resolution(), 5e-4);
}

template <class Make>
std::string message(const Make& make) {
  try {
    make();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(PatchShape, RefusesBadTables) {
  using testing::StartsWith;
  const auto lobe = [](std::vector<double> y, std::vector<double> trailing,
                       std::vector<double> leading) {
    const auto vector = [](const std::vector<double>& values) {
      return VectorXd(Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size())));
    };
    return message([&] { Lobe(vector(y), vector(trailing), vector(leading)); });
  };
  EXPECT_EQ(lobe({0, 1, 2}, {0, -1, 0}, {0, 1, 0}), "");
  EXPECT_EQ(lobe({0, 1}, {-1, -1}, {1, 1}), "");
  EXPECT_THAT(lobe({}, {}, {}), StartsWith("number of rows = 0: expected two or more"));
  EXPECT_THAT(lobe({0}, {-1}, {1}), StartsWith("number of rows = 1: expected two or more"));
  EXPECT_THAT(lobe({0, 1}, {0, 0}, {0, 0}), StartsWith("number of rows = 2: expected three"));
  EXPECT_THAT(lobe({0, 1, 1}, {0, -1, 0}, {0, 1, 0}), StartsWith("row 3: y = 1: expected more"));
  EXPECT_THAT(lobe({0, 1, 2}, {0, 1, 0}, {0, -1, 0}), StartsWith("row 2: leading = -1: expected"));
  EXPECT_THAT(lobe({0, 1, 2}, {0, 1, 0}, {0, 1, 0}), StartsWith("row 2: leading = 1: expected"));
  EXPECT_THAT(lobe({0, 1, 2}, {0, -1, 1}, {0, 1, 0}), StartsWith("row 3: leading = 0: expected"));
  EXPECT_THAT(lobe({0, 1, 2}, {0, std::nan(""), 0}, {0, 1, 0}),
              StartsWith("row 2: trailing = nan"));
  EXPECT_THAT(lobe({0, 1, 2}, {0, -1, 0}, {0, INFINITY, 0}), StartsWith("row 2: leading = inf"));
  EXPECT_THAT(message([] {
                PatchShape({Egg{}.lobe(9), Egg{.y0 = 1}.lobe(9)});
              }),
              StartsWith("two lobes overlap at y ="));
  EXPECT_THROW(PatchShape({}), std::invalid_argument);
}

TEST(BoundTable, RefusesBadTables) {
  using testing::StartsWith;
  const PatchShape shape = PatchShape::ellipse(2, 1);
  VectorXd x(9), y(9), g(9);
  x << -1, 0, 1, -1, 0, 1, -1, 0, 1;
  y << -0.5, -0.5, -0.5, 0, 0, 0, 0.5, 0.5, 0.5;
  g << 1, 2, 1, 3, 4, 3, 1, 2, 1;
  const auto with = [&](Index row, double x_of_row, double y_of_row, double value) {
    VectorXd u = x, v = y, w = g;
    u[row] = x_of_row;
    v[row] = y_of_row;
    w[row] = value;
    return message([&] { BoundTable(shape, u, v, w); });
  };
  EXPECT_EQ(with(0, -1, -0.5, 1), "");
  EXPECT_THAT(with(4, 0, 0, -1), StartsWith("row 5: bound = -1: expected"));
  EXPECT_THAT(with(4, 0, 0, 0), StartsWith("row 5: bound = 0: expected a number > 0 between"));
  EXPECT_THAT(with(4, 0, 0, std::nan("")), StartsWith("row 5: bound = nan: expected"));
  EXPECT_THAT(with(4, std::nan(""), 0, 1), StartsWith("row 5: x = nan: expected"));
  EXPECT_THAT(with(4, -1, 0, 1), testing::HasSubstr("a point that is in no other row"));
  EXPECT_THAT(with(4, 0, 0.1, 1), "");
  const auto part = [&](Index rows) {
    return message([&] { BoundTable(shape, x.head(rows), y.head(rows), g.head(rows)); });
  };
  EXPECT_THAT(part(0), StartsWith("number of rows = 0: expected"));
  EXPECT_THAT(part(6), StartsWith("number of y with a bound > 0 = 2: expected three or more"));
  EXPECT_THAT(message([&] { BoundTable(shape, x, (y.array() / 2).matrix(), g); }),
              StartsWith("y = -0.25: expected a bound > 0 between -1 mm and here"));
  EXPECT_THAT(message([&] { BoundTable(shape, x * 10, y, g); }),
              StartsWith("number of x with a bound > 0 on one y = 1: expected three"));
  EXPECT_THAT(message([&] { BoundTable(shape, x, y, g * 0); }),
              StartsWith("largest bound within the edges = 0: expected"));
  EXPECT_EQ(BoundTable(shape, x, y, g).left_out(), 0);
}

}  // namespace microslip::patch_shape_test
