// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/joined_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/support/gauss_points.hpp"
#include "microslip/support/require.hpp"
#include "row_parts.hpp"

namespace microslip {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

/// Rows of each lobe in proportion to heights, at least three each where there are as many.
std::vector<Index> rows_of_lobes(const PatchShape& shape, Index rows) {
  const auto lobes = static_cast<Index>(shape.lobes().size());
  require(rows >= lobes, "rows", static_cast<double>(rows), [&] {
    return lobes == 1 ? std::string("a whole number >= 1")
                      : "at least one for each lobe, of which there are " + std::to_string(lobes);
  });
  const Index least = std::min<Index>(3, rows / lobes);
  std::vector<Index> found(shape.lobes().size(), least);
  for (Index left = rows - least * lobes; left > 0; --left) {  // to the highest rows
    std::size_t highest = 0;
    const auto height = [&](std::size_t l) {
      return shape.lobes()[l].height() / static_cast<double>(found[l]);
    };
    for (std::size_t l = 1; l < found.size(); ++l) {
      if (height(l) > height(highest)) highest = l;
    }
    ++found[highest];
  }
  return found;
}

/// Points and weights of a quadrature over psi.
struct Rule {
  std::vector<double> angles, weights;

  /// Adds Gauss's points in each of some panels between two angles, graded by a power towards the
  /// first.
  template <unsigned Points>
  void add(double from, double to, int power, int panels) {
    for (int panel = 0; panel < panels; ++panel) {
      const double begin = static_cast<double>(panel) / panels;
      for_gauss_points<Points>(begin, begin + 1.0 / panels, [&](double t, double weight) {
        angles.push_back(from + (to - from) * std::pow(t, power));
        weights.push_back(std::abs(to - from) * power * std::pow(t, power - 1) * weight);
      });
    }
  }
};

/// Divides a sub-row where sides of its cells are slanted: at the ends of long ellipses, in the outer
/// rows. There the integrals along lines jump where the side passes the point, over a distance that
/// is shorter the more slanted the side is. With one panel errors are up to 8e-3 for a/b above 5,
/// and the matrix of some grids is nearly singular, so that small loads have no solution.
int panels_of(const Lobe& lobe, const SubRow& part) {
  constexpr double slope_of_panel = 20, most = 8;
  const Lobe::Row from = lobe.row(part.from), to = lobe.row(part.to);
  const double slant =
      std::abs(to.middle - from.middle) + std::abs(to.half_length - from.half_length);
  const double slope = slant / (lobe.y(part.to) - lobe.y(part.from));
  return static_cast<int>(std::clamp(std::ceil(slope / slope_of_panel), 1.0, most));
}

/// Makes the rule for a point at psi = at, where the kernels are singular across its row, and steep
/// next to it: 14 points instead of 25 leave errors of 5e-4 at a/b = 5.
Rule rule_over(const Lobe& lobe, const SubRow& part, double at) {
  Rule rule;
  const int panels = panels_of(lobe, part);
  const double width = part.to - part.from;
  const double away = std::abs((part.from + part.to) / 2 - at) / width;  // in sub-rows
  if (away < 0.5) {
    rule.add<25>(at, part.from, 3, panels);
    rule.add<25>(at, part.to, 3, panels);
  } else if (away < 1.5) {
    const bool above = part.from > at;
    rule.add<10>(above ? part.from : part.to, above ? part.to : part.from, 2, panels);
  } else if (away < 3.5) {
    rule.add<4>(part.from, part.to, 1, panels);
  } else if (away < 8.5) {
    rule.add<3>(part.from, part.to, 1, panels);
  } else {
    rule.add<2>(part.from, part.to, 1, panels);
  }
  return rule;
}

/// A line y = const of a lobe in a quadrature across.
struct Line {
  double y, middle, half_length, weight;
};

std::vector<Line> lines_of(const Lobe& lobe, const Rule& rule) {
  std::vector<Line> lines;
  for (std::size_t q = 0; q < rule.angles.size(); ++q) {
    const double psi = rule.angles[q];
    const Lobe::Row row = lobe.row(psi);
    lines.push_back({lobe.y(psi), row.middle, row.half_length,
                     rule.weights[q] * lobe.height() * std::cos(psi)});
  }
  return lines;
}

/// Integrals along the lines y = const of p f for the three kernels f, summed over a sub-row: a
/// value for each sub-cell with v = 1.
///
/// With X = x - A s, f integrates to F, and X f to H; so an integral of p = mean + slope (s - middle)
/// over a sub-cell is
///   mean dF + slope [(x/A - middle) dF - dH/A],  d the difference between both sides.
/// Lines are summed before they are multiplied by what they have in common.
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
    clear();
  }

  void clear() {
    for (Sums& one : sums_) {
      one.plain.setZero(middle_.size());
      one.first.setZero(middle_.size());
    }
  }

  /// Adds a line.
  /// \param x       of the point, from the middle of the line
  /// \param Y       of the point, from the line
  /// \param A       half-length of the line
  /// \param weight  of the line
  void add(double x, double Y, double A, double weight) {
    const double lever = weight / A;
    X_ = x - A * sides_;
    R_ = (X_.square() + Y * Y).sqrt();
    log_ = ((X_.abs() + R_) / std::abs(Y)).log() * X_.sign();  // arsinh(X/|Y|)
    inverse_ = R_.inverse();
    X_ *= inverse_;
    const auto change = [n = middle_.size()](const ArrayXd& at_sides) {
      return at_sides.tail(n) - at_sides.head(n);
    };
    d_log_ = change(log_);
    d_R_ = change(R_);
    d_inverse_ = change(inverse_);
    d_cosine_ = change(X_);
    near().plain += weight * d_log_;
    near().first += lever * (x * d_log_ - d_R_);
    across().plain += weight * d_cosine_;
    across().first += lever * (x * d_cosine_ + Y * Y * d_inverse_);
    mixed().plain -= weight * Y * d_inverse_;
    mixed().first -= lever * Y * (x * d_inverse_ + d_log_ - d_cosine_);
  }

  /// The integrals of a kernel, 0 ... 2 for near, across, mixed.
  ArrayXd of(std::size_t kernel) const {
    return integrals(sums_[kernel].plain, sums_[kernel].first);
  }

  /// The same for the point at -x, if the sides are their own mirror image: sub-cells have their
  /// sums in the opposite order there, and one of both has the opposite sign.
  ArrayXd of_mirror_image(std::size_t kernel) const {
    const double sign = kernel == 2 ? -1 : 1;
    return integrals(sign * sums_[kernel].plain.reverse(), -sign * sums_[kernel].first.reverse());
  }

 private:
  /// Sums of dF and of (x dF - dH)/A.
  struct Sums {
    ArrayXd plain, first;
  };

  Sums& near() { return sums_[0]; }
  Sums& across() { return sums_[1]; }
  Sums& mixed() { return sums_[2]; }

  ArrayXd integrals(const ArrayXd& plain, const ArrayXd& first) const {
    return mean_ * plain + slope_ * (first - middle_ * plain);
  }

  ArrayXd sides_, middle_, mean_, slope_;
  std::array<Sums, 3> sums_;
  ArrayXd X_, R_, log_, inverse_, d_log_, d_R_, d_inverse_, d_cosine_;
};

}  // namespace

JoinedRows::JoinedRows(double ratio, Index rows, Index elements)
    : JoinedRows(
          [&] {
            require_positive("ratio", ratio);
            return PatchShape::ellipse(std::sqrt(ratio), 1 / std::sqrt(ratio));
          }(),
          rows, elements) {}

JoinedRows::JoinedRows(const PatchShape& shape, Index rows, Index elements)
    : rows_(rows), elements_(elements), shape_(shape), first_rows_{0} {
  require(elements >= 1, "elements", static_cast<double>(elements), "a whole number >= 1");
  const std::vector<Index> numbers = rows_of_lobes(shape, rows);
  for (std::size_t l = 0; l < numbers.size(); ++l) {
    first_rows_.push_back(first_rows_.back() + numbers[l]);
    const double height = pi / static_cast<double>(numbers[l]);
    for (Index k = 0; k < numbers[l]; ++k) {
      const double psi = -pi / 2 + (static_cast<double>(k) + 0.5) * height;
      const auto [middle, half_length] = shape.lobes()[l].row(psi);
      placed_.push_back({l, psi, height, shape.lobes()[l].y(psi), middle, half_length});
    }
  }
}

double JoinedRows::theta(Index i) const {
  return (static_cast<double>(i) + 0.5) * pi / static_cast<double>(elements_);
}

double JoinedRows::x(Index j, Index k) const {
  const Row& row = row_of(k);
  return row.middle + row.half_length * std::cos(static_cast<double>(j) * pi /
                                                 static_cast<double>(2 * elements_));
}

double JoinedRows::theta_of(double x, Index k) const {
  const Row& row = row_of(k);
  return std::acos(std::clamp((x - row.middle) / row.half_length, -1.0, 1.0));
}

/// The area is a(y) sin(theta) d theta dy.
VectorXd JoinedRows::areas() const {
  const double width = pi / static_cast<double>(elements_);
  VectorXd areas(cells());
  for (Index k = 0; k < rows_; ++k) {
    const Lobe& lobe = shape_.lobes()[this->lobe(k)];
    const double row = lobe.integral(psi(k) - height(k) / 2, psi(k) + height(k) / 2,
                                     [&](double at) { return lobe.row(at).half_length; });
    for (Index i = 0; i < elements_; ++i) {
      areas[cell(i, k)] = row * (std::cos(theta(i) - width / 2) - std::cos(theta(i) + width / 2));
    }
  }
  return areas;
}

/// Across a row, the integrals are those of a(y) dy, a(y) middle(y) dy, a(y)^2 dy and y a(y) dy.
Eigen::Matrix3Xd JoinedRows::moments() const {
  Eigen::Matrix3Xd moments = Eigen::Matrix3Xd::Zero(3, cells());
  const std::vector<SubCell> along = sub_cells(elements_);
  for (std::size_t l = 0; l < shape_.lobes().size(); ++l) {
    const Lobe& lobe = shape_.lobes()[l];
    for (const SubRow& row : sub_rows(lobe, first_rows_[l], first_rows_[l + 1] - first_rows_[l])) {
      const auto weighted = [&](const auto& of) {
        return lobe.integral(row.from, row.to, [&](double psi) {
          const Lobe::Row at = lobe.row(psi);
          return at.half_length * of(psi, at);
        });
      };
      const double zeroth = weighted([](double, const Lobe::Row&) { return 1.0; });
      const double middle = weighted([](double, const Lobe::Row& at) { return at.middle; });
      const double lever = weighted([](double, const Lobe::Row& at) { return at.half_length; });
      const double in_y = weighted([&](double psi, const Lobe::Row&) { return lobe.y(psi); });
      for (const SubCell& part : along) {
        const Eigen::Vector3d whole(part.sum() * zeroth,
                                    part.sum() * middle + part.first_moment() * lever,
                                    part.sum() * in_y);
        for (Index m = 0; m < row.across.size; ++m) {
          for (Index n = 0; n < part.along.size; ++n) {
            moments.col(cell(part.along.first + n, row.across.first + m)) +=
                row.across.weights[static_cast<std::size_t>(m)] *
                part.along.weights[static_cast<std::size_t>(n)] * whole;
          }
        }
      }
    }
  }
  return moments;
}

/// Rows of a shape that is mirrored in y have the same integrals, but for the sign of the mixed
/// ones. In an ellipse the points at x and -x share logarithms and roots.
JoinedRows::Kernels JoinedRows::kernels() const {
  const MatrixXd zero = MatrixXd::Zero(points(), cells());
  Kernels found{zero, zero, zero};
  const std::array<MatrixXd*, 3> all{&found.near, &found.across, &found.mixed};
  const std::vector<SubCell> along = sub_cells(elements_);
  const Index points_of_row = 2 * elements_ + 1;
  const bool is_symmetric = shape_.is_ellipse();  // in x, too
  LineIntegrals lines(along);
  Eigen::RowVectorXd of_cells(elements_);
  const auto add_lobe = [&](Index k, const Lobe& lobe, const std::vector<SubRow>& across) {
    const bool is_own = &lobe == &shape_.lobes()[this->lobe(k)];
    const double at = is_own ? psi(k) : lobe.psi(y(k)), y_of_row = y(k);
    for (const SubRow& row : across) {
      const Rule rule = rule_over(lobe, row, at);
      const std::vector<Line> sources = lines_of(lobe, rule);
      const auto set = [&](Index j, std::size_t n, const ArrayXd& of_parts) {
        of_cells.setZero();
        for (std::size_t e = 0; e < along.size(); ++e) {
          const Stencil& stencil = along[e].along;
          for (Index l = 0; l < stencil.size; ++l) {
            of_cells[stencil.first + l] +=
                stencil.weights[static_cast<std::size_t>(l)] * of_parts[static_cast<Index>(e)];
          }
        }
        for (Index m = 0; m < row.across.size; ++m) {
          all[n]->row(point(j, k)).segment(cell(0, row.across.first + m), elements_) +=
              row.across.weights[static_cast<std::size_t>(m)] * of_cells;
        }
      };
      for (Index j = 0; j < (is_symmetric ? elements_ + 1 : points_of_row); ++j) {
        const double x_of_point = x(j, k);
        lines.clear();
        for (const Line& line : sources) {
          lines.add(x_of_point - line.middle, y_of_row - line.y, line.half_length, line.weight);
        }
        for (std::size_t n = 0; n < 3; ++n) {
          set(j, n, lines.of(n));
          if (is_symmetric && j < elements_) {
            set(points_of_row - 1 - j, n, lines.of_mirror_image(n));
          }
        }
      }
    }
  };
  for (std::size_t l = 0; l < shape_.lobes().size(); ++l) {
    const Lobe& lobe = shape_.lobes()[l];
    const auto across = sub_rows(lobe, first_rows_[l], first_rows_[l + 1] - first_rows_[l]);
    for (Index k = 0; k < (shape_.is_mirrored() ? (rows_ + 1) / 2 : rows_); ++k) {
      add_lobe(k, lobe, across);
    }
  }
  if (!shape_.is_mirrored()) return found;
  for (Index k = 0; k < rows_ / 2; ++k) {
    const Index mirrored = rows_ - 1 - k;
    for (std::size_t n = 0; n < 3; ++n) {
      const double sign = n == 2 ? -1 : 1;
      for (Index from = 0; from < rows_; ++from) {
        all[n]->block(point(0, mirrored), cell(0, rows_ - 1 - from), points_of_row, elements_) =
            sign * all[n]->block(point(0, k), cell(0, from), points_of_row, elements_);
      }
    }
  }
  return found;
}

}  // namespace microslip
