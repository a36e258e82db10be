// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of generated shapes, loads and bounds beside rectangles with constant tractions, of two
// sizes from which the error of first order is extrapolated. The rectangles share no code with
// joined rows.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "microslip/linalg/lu_factors.hpp"
#include "microslip/patch/steady_patch.hpp"

namespace microslip::generated_shapes_test {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

/// A superellipse or an egg, and a bound on it.
struct Shape {
  double length, height, power, wider, bent, skew;

  double half(double u) const {
    const double rest = std::max(0.0, 1 - std::pow(std::abs(u), power));
    return length * std::pow(rest, 1 / power) * (1 + wider * u);
  }
  double middle(double u) const { return bent * u * u; }

  /// A bound that is zero at the edges and ends.
  double bound(double x, double y) const {
    const double u = y / height, s = (x - middle(u)) / half(u);
    return std::sqrt(std::max(0.0, 1 - u * u) * std::max(0.0, 1 - s * s)) * (1 + skew * u * s);
  }

  PatchShape shape() const {
    constexpr int rows = 81;
    VectorXd y(rows), trailing(rows), leading(rows);
    for (int j = 0; j < rows; ++j) {
      const double u = j == 0          ? -1
                       : j == rows - 1 ? 1
                                       : std::sin(pi * (1.0 * j / (rows - 1) - 0.5));
      y[j] = height * u;
      trailing[j] = middle(u) - half(u);
      leading[j] = middle(u) + half(u);
    }
    return PatchShape({Lobe(y, trailing, leading)});
  }

  BoundTable table(const PatchShape& of) const {
    std::vector<Vector3d> points;
    for (int k = 1; k < 40; ++k) {
      const double u = std::sin(pi * (k / 40.0 - 0.5)), y = height * u;
      for (int i = 1; i < 40; ++i) {
        const double x = middle(u) + half(u) * std::cos(pi * i / 40);
        points.emplace_back(x, y, bound(x, y));
      }
    }
    MatrixXd all(static_cast<Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i) all.row(static_cast<Index>(i)) = points[i];
    return {of, all.col(0), all.col(1), all.col(2)};
  }
};

/// Equal slices across, each of equal rectangles between its edges: s = w + [u(x) - u(x + dx)]/dx.
class Rectangles {
 public:
  Rectangles(const Shape& shape, double nu, int size) : n_(size * size), slip_(2 * n_, 2 * n_) {
    const double dy = 2 * shape.height / size;
    for (int k = 0; k < size; ++k) {
      const double y = shape.height * (2 * (k + 0.5) / size - 1), u = y / shape.height;
      // The mean length of the slice, so that the area is right.
      double half = 0, middle = 0;
      for (int i = 0; i < 20; ++i) {
        const double at = u + ((i + 0.5) / 20 - 0.5) * dy / shape.height;
        half += shape.half(at) / 20;
        middle += shape.half(at) * shape.middle(at) / 20;
      }
      middle /= half;
      const double dx = 2 * half / size;
      for (int i = 0; i < size; ++i) {
        cells_.push_back({middle + half - (i + 0.5) * dx, y, dx, dy});
        bound_.push_back(
            shape.bound(shape.middle(u) + shape.half(u) * (1 - 2 * (i + 0.5) / size), y));
      }
    }
    for (Index i = 0; i < n_; ++i) {
      const Cell& to = cells_[static_cast<std::size_t>(i)];
      for (Index j = 0; j < n_; ++j) {
        const Cell& from = cells_[static_cast<std::size_t>(j)];
        const Vector3d here = integrals(from, to.x, to.y),
                       ahead = integrals(from, to.x + to.dx, to.y);
        const Vector3d change = (here - ahead) / (pi * to.dx);
        slip_(i, j) = change[0] - nu * change[1];
        slip_(i, n_ + j) = slip_(n_ + i, j) = nu * change[2];
        slip_(n_ + i, n_ + j) = (1 - nu) * change[0] + nu * change[1];
      }
    }
  }

  /// Forces and moment, with a bound or none. Coulomb's law p = P(p - r s), with the projection P
  /// onto the bound, is solved by Newton's method from adhesion.
  Vector3d resultants(const Vector3d& motion, double peak) const {
    VectorXd rigid(2 * n_);
    for (Index i = 0; i < n_; ++i) {
      const Cell& cell = cells_[static_cast<std::size_t>(i)];
      rigid[i] = motion[0] - motion[2] * cell.y;
      rigid[n_ + i] = motion[1] + motion[2] * (cell.x + cell.dx / 2);
    }
    VectorXd p = -LuFactors(slip_).solve(rigid);
    double change = std::isinf(peak) ? 0 : 1;
    for (int system = 0; system < 30 && change > 1e-9; ++system) {
      const VectorXd s = slip_ * p + rigid;
      MatrixXd left = slip_;
      VectorXd right = -rigid;
      for (Index i = 0; i < n_; ++i) {
        const double most = peak * bound_[static_cast<std::size_t>(i)];
        const double length = 1 / std::max(slip_(i, i), slip_(n_ + i, n_ + i));
        const Vector2d old(p[i], p[n_ + i]);
        const Vector2d z = old - length * Vector2d(s[i], s[n_ + i]);
        if (z.norm() <= most) continue;
        // q = most e + most (1 - e e')/|z| (q - r s - z), s linear in all tractions
        const Vector2d e = z.normalized();
        const Matrix2d turn = most / z.norm() * (Matrix2d::Identity() - e * e.transpose());
        const MatrixXd rows = (MatrixXd(2, 2 * n_) << slip_.row(i), slip_.row(n_ + i)).finished();
        MatrixXd condition = length * turn * rows;
        condition.col(i) += (Matrix2d::Identity() - turn).col(0);
        condition.col(n_ + i) += (Matrix2d::Identity() - turn).col(1);
        const Vector2d known = most * e - turn * (z + length * Vector2d(rigid[i], rigid[n_ + i]));
        left.row(i) = condition.row(0);
        left.row(n_ + i) = condition.row(1);
        right[i] = known[0];
        right[n_ + i] = known[1];
      }
      VectorXd q = LuFactors(left).solve(right);
      for (Index i = 0; i < n_; ++i) {
        const double most = peak * bound_[static_cast<std::size_t>(i)];
        const double size = std::hypot(q[i], q[n_ + i]);
        if (size <= most) continue;
        q[i] *= most / size;
        q[n_ + i] *= most / size;
      }
      change = (q - p).lpNorm<Eigen::Infinity>();
      p = q;
    }
    EXPECT_LE(change, 1e-9);
    Vector3d sum = Vector3d::Zero();
    for (Index i = 0; i < n_; ++i) {
      const Cell& cell = cells_[static_cast<std::size_t>(i)];
      sum += cell.dx * cell.dy * Vector3d(p[i], p[n_ + i], cell.x * p[n_ + i] - cell.y * p[i]);
    }
    return sum;
  }

  double full_sliding() const {
    double sum = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) sum += bound_[i] * cells_[i].dx * cells_[i].dy;
    return sum;
  }

 private:
  struct Cell {
    double x, y, dx, dy;
  };

  /// Integrals of 1/R, Y^2/R^3 and X Y/R^3 over a rectangle, in closed form.
  static Vector3d integrals(const Cell& from, double x, double y) {
    Vector3d sum = Vector3d::Zero();
    for (const int i : {-1, 1}) {
      for (const int j : {-1, 1}) {
        const double X = x - from.x + i * from.dx / 2, Y = y - from.y + j * from.dy / 2;
        const double by_x = X == 0 ? 0 : X * std::asinh(Y / std::abs(X));
        const double by_y = Y == 0 ? 0 : Y * std::asinh(X / std::abs(Y));
        sum += i * j * Vector3d(by_x + by_y, by_x, -std::hypot(X, Y));
      }
    }
    return sum;
  }

  Index n_;
  MatrixXd slip_;
  std::vector<Cell> cells_;
  std::vector<double> bound_;
};

/// Generates shapes: superellipses and eggs.
class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed) {}
  double uniform(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }
  Shape shape() {
    const double root = std::exp(uniform(-0.35, 0.35));
    return {.length = root,
            .height = 1 / root,
            .power = uniform(1.8, 2.6),
            .wider = uniform(-0.3, 0.3),
            .bent = uniform(-0.2, 0.2),
            .skew = uniform(-0.3, 0.3)};
  }
  Vector3d motion(double size) {
    return size * Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
  }

 private:
  std::mt19937 random_;
};

PatchLoad load_of(const Vector3d& motion) {
  return {{{false, motion[0]}, {false, motion[1]}, {false, motion[2]}}};
}

Vector3d extrapolated(const Vector3d& coarse, const Vector3d& fine, double ratio) {
  return fine + (fine - coarse) / (ratio - 1);
}

TEST(GeneratedShapes, HaveTheForcesOfRectanglesWhereAllSticks) {
  Generator generator(5);
  for (int sample = 0; sample < 3; ++sample) {
    const Shape shape = generator.shape();
    const double nu = generator.uniform(0, 0.5);
    const Rectangles coarse(shape, nu, 10), fine(shape, nu, 15);
    const Vector3d motion = generator.motion(1);
    const double none = std::numeric_limits<double>::infinity();
    const Vector3d expected =
        extrapolated(coarse.resultants(motion, none), fine.resultants(motion, none), 1.5);
    const SteadyPatch patch{.material = {1, nu},
                            .bound = PatchBound(shape.shape(), 1e9),
                            .rows = 11,
                            .elements = 11,
                            .load = load_of(motion)};
    const SteadyPatchSolution found = solve_steady(patch);
    ASSERT_EQ(found.slip_area(), 0);
    EXPECT_LT((found.resultants - expected).norm(), 5e-3 * expected.norm())
        << found.resultants.transpose() << " / " << expected.transpose();
  }
}

TEST(GeneratedShapes, HaveTheForcesOfRectanglesWherePartsSlip) {
  Generator generator(6);
  for (int sample = 0; sample < 2; ++sample) {
    const Shape shape = generator.shape();
    const double nu = generator.uniform(0, 0.5);
    const Rectangles coarse(shape, nu, 10), fine(shape, nu, 15);
    const PatchShape edges = shape.shape();
    const PatchBound bound(edges, shape.table(edges));
    EXPECT_NEAR(bound.total(), fine.full_sliding(), 1e-2 * bound.total());
    for (const double size : {0.3, 0.8, 1.5}) {
      const Vector3d motion = generator.motion(size);
      const Vector3d expected =
          extrapolated(coarse.resultants(motion, 1), fine.resultants(motion, 1), 1.5);
      const SteadyPatch patch{
          .material = {1, nu}, .bound = bound, .rows = 12, .elements = 12, .load = load_of(motion)};
      const SteadyPatchSolution found = solve_steady(patch);
      EXPECT_GT(found.slip_area(), 0);
      EXPECT_LT((found.resultants - expected).norm(), 8e-3 * bound.total())
          << size << ": " << found.resultants.transpose() << " / " << expected.transpose();
    }
  }
}

}  // namespace microslip::generated_shapes_test
