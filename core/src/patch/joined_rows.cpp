// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/joined_rows.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "microslip/support/gauss_points.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

constexpr int parts_across = 3;  ///< sub-rows of a row, on which v is constant across
constexpr int parts_along = 5;   ///< sub-cells of a cell, on which v is constant and p linear

/// The mean of v over a part of a cell or of a row, as weights of values at neighbouring centres.
struct Stencil {
  Index first;
  Index size;
  std::array<double, 3> weights;
};

/// Means of cos and sin over a part, with the weight of the tractions.
struct Means {
  double cos, sin;
};

/// Makes the stencil that is exact for 1, cos and sin at three centres; for 1 and one of them at
/// two; for 1 at one.
/// \param angle  of the first centre
/// \param step   from centre to centre
Stencil stencil(Index first, Index size, double angle, double step, const Means& mean,
                bool by_cos) {
  Stencil found{first, size, {1, 0, 0}};
  if (size == 2) {
    const auto value = [&](double at) { return by_cos ? std::cos(at) : std::sin(at); };
    const double from = value(angle), to = value(angle + step);
    const double part = ((by_cos ? mean.cos : mean.sin) - from) / (to - from);
    found.weights = {1 - part, part, 0};
  } else if (size == 3) {
    Eigen::Matrix3d values;
    for (int j = 0; j < 3; ++j) {
      const double at = angle + j * step;
      values.col(j) = Eigen::Vector3d(1, std::cos(at), std::sin(at));
    }
    const Eigen::Vector3d weights =
        values.partialPivLu().solve(Eigen::Vector3d(1, mean.cos, mean.sin));
    found.weights = {weights[0], weights[1], weights[2]};
  }
  return found;
}

/// A part of a cell: p = mean + slope (s - middle) for v = 1.
struct SubCell {
  double width, middle, mean, slope;  ///< in s
  Stencil along;

  /// Integrals of p and of p s over the part.
  double sum() const { return mean * width; }
  double first_moment() const { return middle * sum() + slope * width * width * width / 12; }
};

/// The parts of the cells of a row, from the leading edge on; p ds = (1 - cos) d theta.
std::vector<SubCell> sub_cells(Index elements) {
  const Index size = parts_along * elements;
  const double step = pi / static_cast<double>(elements);
  std::vector<SubCell> parts;
  for (Index e = 0; e < size; ++e) {
    const double from = pi * static_cast<double>(e) / static_cast<double>(size);
    const double to = pi * static_cast<double>(e + 1) / static_cast<double>(size);
    const auto integral = [&](const auto& of) { return of(to) - of(from); };
    const double sum = integral([](double t) { return t - std::sin(t); });
    const double with_cos =
        integral([](double t) { return std::sin(t) - t / 2 - std::sin(2 * t) / 4; });
    const double with_sin =
        integral([](double t) { return -std::cos(t) - std::sin(t) * std::sin(t) / 2; });
    SubCell part{.width = std::cos(from) - std::cos(to),
                 .middle = (std::cos(from) + std::cos(to)) / 2,
                 .mean = 0,
                 .slope = 0,
                 .along = {}};
    part.mean = sum / part.width;
    part.slope = 12 * (with_cos - part.middle * sum) / std::pow(part.width, 3);
    // v is even in theta at both edges, so that two centres are enough there.
    const Index i = e / parts_along;
    const bool at_edge = i == 0 || i == elements - 1;
    const Index count = std::min<Index>(elements, at_edge ? 2 : 3);
    const Index first = std::clamp<Index>(i - 1, 0, elements - count);
    part.along = stencil(first, count, (static_cast<double>(first) + 0.5) * step, step,
                         {with_cos / sum, with_sin / sum}, true);
    parts.push_back(part);
  }
  return parts;
}

/// A part of a row, between two angles psi.
struct SubRow {
  double from, to;
  Stencil across;
};

std::vector<SubRow> sub_rows(Index rows) {
  const Index size = parts_across * rows;
  const double step = pi / static_cast<double>(rows);
  std::vector<SubRow> parts;
  for (Index e = 0; e < size; ++e) {
    const double from = -pi / 2 + pi * static_cast<double>(e) / static_cast<double>(size);
    const double to = -pi / 2 + pi * static_cast<double>(e + 1) / static_cast<double>(size);
    const auto integral = [&](const auto& of) { return of(to) - of(from); };
    const double sum = integral([](double t) { return t / 2 + std::sin(2 * t) / 4; });
    const double with_cos =
        integral([](double t) { return std::sin(t) - std::pow(std::sin(t), 3) / 3; });
    const double with_sin = integral([](double t) { return -std::pow(std::cos(t), 3) / 3; });
    const Index count = std::min<Index>(rows, 3);
    const Index first = std::clamp<Index>(e / parts_across - 1, 0, rows - count);
    parts.push_back({from, to,
                     stencil(first, count, -pi / 2 + (static_cast<double>(first) + 0.5) * step,
                             step, {with_cos / sum, with_sin / sum}, false)});
  }
  return parts;
}

/// Points and weights of a quadrature over psi.
struct Rule {
  std::vector<double> angles, weights;

  /// Adds Gauss's points between two angles, graded by a power towards the first.
  template <unsigned Points>
  void add(double from, double to, int power) {
    for_gauss_points<Points>(0, 1, [&](double t, double weight) {
      angles.push_back(from + (to - from) * std::pow(t, power));
      weights.push_back(std::abs(to - from) * power * std::pow(t, power - 1) * weight);
    });
  }
};

/// Makes the rule for a point at psi = at, where the kernels are singular across its row, and steep
/// next to it. There the sides of cells are slanted, most in rows near the ends of a long ellipse:
/// 14 points instead of 25 leave errors of 5e-4 at a/b = 5.
Rule rule_over(const SubRow& part, double at) {
  Rule rule;
  const double width = part.to - part.from;
  const double away = std::abs((part.from + part.to) / 2 - at) / width;  // in sub-rows
  if (away < 0.5) {
    rule.add<25>(at, part.from, 3);
    rule.add<25>(at, part.to, 3);
  } else if (away < 1.5) {
    const bool above = part.from > at;
    rule.add<10>(above ? part.from : part.to, above ? part.to : part.from, 2);
  } else if (away < 3.5) {
    rule.add<4>(part.from, part.to, 1);
  } else if (away < 8.5) {
    rule.add<3>(part.from, part.to, 1);
  } else {
    rule.add<2>(part.from, part.to, 1);
  }
  return rule;
}

/// Integrals along the lines y = const of p f for the three kernels f, summed over a sub-row: a
/// value for each sub-cell with v = 1.
class LineIntegrals {
 public:
  explicit LineIntegrals(const std::vector<SubCell>& parts)
      : sides_(parts.size() + 1), middle_(parts.size()), mean_(parts.size()), slope_(parts.size()) {
    for (std::size_t e = 0; e < parts.size(); ++e) {
      const auto i = static_cast<Index>(e);
      sides_[i] = parts[e].middle + parts[e].width / 2;
      middle_[i] = parts[e].middle;
      mean_[i] = parts[e].mean;
      slope_[i] = parts[e].slope;
    }
    sides_[sides_.size() - 1] = -1;
    for (ArrayXd& sum : sums) sum.resize(middle_.size());
  }

  std::array<ArrayXd, 3> sums;  ///< near, across, mixed

  void clear() {
    for (ArrayXd& sum : sums) sum.setZero();
  }

  /// Adds a line. With X = x - A s, f integrates to F, and X f to H; so an integral of p is
  ///   mean dF + slope [(x/A - middle) dF - dH/A],  d the difference between both sides.
  /// \param x       of the point
  /// \param Y       of the point, from the line
  /// \param A       half-length of the line
  /// \param weight  of the line
  void add(double x, double Y, double A, double weight) {
    const double away = std::abs(Y);
    X_ = x - A * sides_;
    R_ = (X_.square() + Y * Y).sqrt();
    log_ = ((X_.abs() + R_) / away).log() * X_.sign();  // arsinh(X/|Y|)
    lever_ = slope_ * (x / A - middle_) + mean_;
    add_to(sums[0], log_, R_, A, weight);
    inverse_ = R_.inverse();
    add_to(sums[1], X_ * inverse_, -Y * Y * inverse_, A, weight);
    add_to(sums[2], -Y * inverse_, Y * (log_ - X_ * inverse_), A, weight);
  }

 private:
  template <class F, class H>
  void add_to(ArrayXd& sum, const F& f, const H& h, double A, double weight) {
    const Index n = middle_.size();
    F_ = f;
    H_ = h;
    sum += weight * (lever_ * (F_.tail(n) - F_.head(n)) - slope_ / A * (H_.tail(n) - H_.head(n)));
  }

  ArrayXd sides_, middle_, mean_, slope_;
  ArrayXd X_, R_, log_, inverse_, lever_, F_, H_;
};

}  // namespace

JoinedRows::JoinedRows(double ratio, Index rows, Index elements)
    : rows_(rows), elements_(elements), a_(std::sqrt(ratio)) {
  require_positive("ratio", ratio);
  require(rows >= 1, "rows", static_cast<double>(rows), "a whole number >= 1");
  require(elements >= 1, "elements", static_cast<double>(elements), "a whole number >= 1");
}

double JoinedRows::psi(Index k) const {
  return -pi / 2 + (static_cast<double>(k) + 0.5) * pi / static_cast<double>(rows_);
}

double JoinedRows::theta(Index i) const {
  return (static_cast<double>(i) + 0.5) * pi / static_cast<double>(elements_);
}

double JoinedRows::y(Index k) const { return b() * std::sin(psi(k)); }

double JoinedRows::x(Index j, Index k) const {
  return a_ * std::cos(psi(k)) *
         std::cos(static_cast<double>(j) * pi / static_cast<double>(2 * elements_));
}

/// The area is a(y) sin(theta) d theta b cos(psi) d psi.
VectorXd JoinedRows::areas() const {
  const auto across = [](double t) { return t / 2 + std::sin(2 * t) / 4; };
  const double height = pi / static_cast<double>(rows_),
               width = pi / static_cast<double>(elements_);
  VectorXd areas(cells());
  for (Index k = 0; k < rows_; ++k) {
    const double row = across(psi(k) + height / 2) - across(psi(k) - height / 2);
    for (Index i = 0; i < elements_; ++i) {
      areas[cell(i, k)] = row * (std::cos(theta(i) - width / 2) - std::cos(theta(i) + width / 2));
    }
  }
  return areas;
}

/// Across a row, the integrals are those of a(y) dy, of a(y)^2 dy and of y a(y) dy.
Eigen::Matrix3Xd JoinedRows::moments() const {
  Eigen::Matrix3Xd moments = Eigen::Matrix3Xd::Zero(3, cells());
  const std::vector<SubCell> along = sub_cells(elements_);
  for (const SubRow& row : sub_rows(rows_)) {
    const auto integral = [&](const auto& of) { return of(row.to) - of(row.from); };
    const double zeroth = integral([](double t) { return t / 2 + std::sin(2 * t) / 4; });
    const double in_x =
        a_ * integral([](double t) { return std::sin(t) - std::pow(std::sin(t), 3) / 3; });
    const double in_y = b() * integral([](double t) { return -std::pow(std::cos(t), 3) / 3; });
    for (const SubCell& part : along) {
      const Eigen::Vector3d whole(part.sum() * zeroth, part.first_moment() * in_x,
                                  part.sum() * in_y);
      for (Index m = 0; m < row.across.size; ++m) {
        for (Index l = 0; l < part.along.size; ++l) {
          moments.col(cell(part.along.first + l, row.across.first + m)) +=
              row.across.weights[static_cast<std::size_t>(m)] *
              part.along.weights[static_cast<std::size_t>(l)] * whole;
        }
      }
    }
  }
  return moments;
}

/// Rows mirrored in y have the same integrals, but for the sign of the mixed ones.
JoinedRows::Kernels JoinedRows::kernels() const {
  const MatrixXd zero = MatrixXd::Zero(points(), cells());
  Kernels found{zero, zero, zero};
  const std::array<MatrixXd*, 3> all{&found.near, &found.across, &found.mixed};
  const std::vector<SubCell> along = sub_cells(elements_);
  const std::vector<SubRow> across = sub_rows(rows_);
  LineIntegrals lines(along);
  Eigen::RowVectorXd of_cells(elements_);
  for (Index k = 0; k < (rows_ + 1) / 2; ++k) {
    for (const SubRow& row : across) {
      const Rule rule = rule_over(row, psi(k));
      for (Index j = 0; j <= 2 * elements_; ++j) {
        lines.clear();
        for (std::size_t q = 0; q < rule.angles.size(); ++q) {
          const double cosine = std::cos(rule.angles[q]);
          lines.add(x(j, k), y(k) - b() * std::sin(rule.angles[q]), a_ * cosine,
                    rule.weights[q] * b() * cosine);
        }
        for (std::size_t n = 0; n < 3; ++n) {
          of_cells.setZero();
          for (std::size_t e = 0; e < along.size(); ++e) {
            const Stencil& stencil = along[e].along;
            for (Index l = 0; l < stencil.size; ++l) {
              of_cells[stencil.first + l] += stencil.weights[static_cast<std::size_t>(l)] *
                                             lines.sums[n][static_cast<Index>(e)];
            }
          }
          for (Index m = 0; m < row.across.size; ++m) {
            all[n]->row(point(j, k)).segment(cell(0, row.across.first + m), elements_) +=
                row.across.weights[static_cast<std::size_t>(m)] * of_cells;
          }
        }
      }
    }
    const Index mirrored = rows_ - 1 - k;
    if (mirrored == k) continue;
    const Index height = 2 * elements_ + 1;
    for (std::size_t n = 0; n < 3; ++n) {
      const double sign = n == 2 ? -1 : 1;
      for (Index from = 0; from < rows_; ++from) {
        all[n]->block(point(0, mirrored), cell(0, rows_ - 1 - from), height, elements_) =
            sign * all[n]->block(point(0, k), cell(0, from), height, elements_);
      }
    }
  }
  return found;
}

}  // namespace microslip
