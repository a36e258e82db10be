// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/patch_bound.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

/// A point belongs to the shape up to this part of a row's half-length beyond an edge, as tables are
/// printed with few digits.
constexpr double printed_edge = 1e-4;

/// Largest part of a lobe's height without a row of points.
constexpr double widest_gap = 1.0 / 3;

/// A point of a table in the shape.
struct BoundPoint {
  std::size_t lobe;
  double y, s, value;
  Index row;  ///< in the table
};

/// The lobe of a point and its s in there; nothing outside.
std::optional<BoundPoint> placed(const PatchShape& shape, double x, double y) {
  for (std::size_t l = 0; l < shape.lobes().size(); ++l) {
    const Lobe& lobe = shape.lobes()[l];
    if (y < lobe.low() || y > lobe.high()) continue;
    const Lobe::Row row = lobe.row(lobe.psi(y));
    const double away = x - row.middle;
    if (std::abs(away) > (1 + printed_edge) * row.half_length) continue;
    if (row.half_length < printed_edge * lobe.height()) return BoundPoint{l, y, 0, 0, 0};
    double s = std::clamp(away / row.half_length, -1.0, 1.0);
    if (std::abs(s) > 1 - printed_edge) s = std::copysign(1, s);
    return BoundPoint{l, y, s, 0, 0};
  }
  return std::nullopt;
}

}  // namespace

BoundTable::BoundTable(const PatchShape& shape, const VectorXd& x, const VectorXd& y,
                       const VectorXd& values) {
  require(x.size() == y.size() && x.size() == values.size() && x.size() > 0, "number of rows",
          static_cast<double>(x.size()), "as many values of x, y and bound, at least one");
  std::vector<BoundPoint> points;
  for (Index i = 0; i < x.size(); ++i) {
    const auto name = [&](const char* of) { return fmt::format("row {}: {}", i + 1, of); };
    require(true, name("x"), x[i], "a finite number");
    require(true, name("y"), y[i], "a finite number");
    require(values[i] >= 0 && values[i] <= 1e50, name("bound"), values[i],
            "a number from 0 to 1e50 N/mm^2");
    auto point = placed(shape, x[i], y[i]);
    if (!point) {
      left_out_ += values[i] > 0;
      continue;
    }
    point->value = values[i];
    point->row = i;
    points.push_back(*point);
    peak_ = std::max(peak_, values[i]);
  }
  require(peak_ > 0, "largest bound within the edges", peak_, "a number > 0");
  std::ranges::sort(points, [](const BoundPoint& one, const BoundPoint& other) {
    return std::tie(one.lobe, one.y, one.s) < std::tie(other.lobe, other.y, other.s);
  });
  lobes_.resize(shape.lobes().size());
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    const BoundPoint& first = points[begin];
    while (end < points.size() && points[end].lobe == first.lobe && points[end].y == first.y) {
      ++end;
      if (end < points.size() && points[end].lobe == first.lobe && points[end].y == first.y) {
        require(points[end].s > points[end - 1].s, fmt::format("row {}: x", points[end].row + 1),
                x[points[end].row], "a point that is in no other row");
      }
    }
    // Zeros next to the edges are outside; those of the edges themselves are without them, too.
    std::size_t from = begin, to = end;
    while (from < to && points[from].value == 0) ++from;
    while (to > from && points[to - 1].value == 0) --to;
    if (from == to) continue;
    Row row{.y = first.y, .places = {}, .squares = {}};
    const auto add = [&](double s, double square) {
      row.places.push_back(s);
      row.squares.push_back(square);
    };
    if (points[from].s > -1) add(-1, 0);
    for (std::size_t i = from; i < to; ++i) {
      require(points[i].value > 0, fmt::format("row {}: bound", points[i].row + 1), points[i].value,
              "a number > 0 between others that are");
      add(points[i].s, points[i].value * points[i].value);
    }
    if (points[to - 1].s < 1) add(1, 0);
    lobes_[first.lobe].push_back(std::move(row));
  }
  for (std::size_t l = 0; l < lobes_.size(); ++l) {
    const Lobe& lobe = shape.lobes()[l];
    const auto where = [&] {
      return fmt::format("y from {} to {} mm", format_short(lobe.low()), format_short(lobe.high()));
    };
    require(lobes_[l].size() >= 3, "number of y with a bound > 0",
            static_cast<double>(lobes_[l].size()),
            [&] { return "three or more within the edges for " + where(); });
    std::size_t most = 0;
    double below = lobe.low();
    const auto require_near = [&](double y) {
      require(y - below <= widest_gap * 2 * lobe.height(), "y", y, [&] {
        return fmt::format("a bound > 0 between {} mm and here, too: gaps of at most a third of {}",
                           format_short(below), where());
      });
      below = y;
    };
    for (const Row& row : lobes_[l]) {
      most = std::max(most, row.places.size());
      require_near(row.y);
    }
    require_near(lobe.high());
    require(most >= 5, "number of x with a bound > 0 on one y", static_cast<double>(most) - 2,
            [&] { return "three or more within the edges for some " + where(); });
  }
}

double BoundTable::square_of(const Row& row, double s) {
  const auto above = std::upper_bound(row.places.begin() + 1, row.places.end() - 1, s);
  const auto i = static_cast<std::size_t>(above - row.places.begin());
  const double part = (s - row.places[i - 1]) / (row.places[i] - row.places[i - 1]);
  return (1 - part) * row.squares[i - 1] + part * row.squares[i];
}

double BoundTable::operator()(const PatchShape& shape, std::size_t lobe, double psi,
                              double theta) const {
  const Rows& rows = lobes_[lobe];
  const Lobe& of = shape.lobes()[lobe];
  const double y = of.y(psi), s = std::cos(theta);
  const auto above = std::ranges::upper_bound(rows, y, {}, &Row::y);
  if (above == rows.begin()) {
    const double gap = above->y - of.low();
    return std::sqrt(square_of(*above, s) * (gap > 0 ? (y - of.low()) / gap : 1));
  }
  const Row& below = *(above - 1);
  if (above == rows.end()) {
    const double gap = of.high() - below.y;
    return std::sqrt(square_of(below, s) * (gap > 0 ? (of.high() - y) / gap : 1));
  }
  const double part = (y - below.y) / (above->y - below.y);
  return std::sqrt((1 - part) * square_of(below, s) + part * square_of(*above, s));
}

std::unique_ptr<BoundTable> BoundTable::half() const {
  std::unique_ptr<BoundTable> found(new BoundTable);
  found->peak_ = peak_;
  for (const Rows& rows : lobes_) {
    if (rows.size() < 5) return nullptr;
    Rows fewer;
    for (std::size_t j = 1; j < rows.size(); j += 2) {
      Row row{.y = rows[j].y, .places = {}, .squares = {}};
      for (std::size_t i = 0; i < rows[j].places.size(); ++i) {
        if (i % 2 == 1 && i + 1 < rows[j].places.size()) continue;
        row.places.push_back(rows[j].places[i]);
        row.squares.push_back(rows[j].squares[i]);
      }
      fewer.push_back(std::move(row));
    }
    found->lobes_.push_back(std::move(fewer));
  }
  return found;
}

PatchBound::PatchBound(const EllipticBound& bound)
    : shape_(PatchShape::ellipse(bound.half_width(), bound.lateral_half_width())),
      peak_(bound.peak()),
      longest_(bound.half_width()),
      total_(bound.total()),
      turning_moment_(bound.turning_moment()) {}

PatchBound::PatchBound(const PatchShape& shape, double peak) : shape_(shape), peak_(peak) {
  require_positive("peak", peak);
  constexpr int samples_of_lobe = 2000;
  longest_ = 0;
  for (const Lobe& lobe : shape.lobes()) {
    for (int i = 0; i <= samples_of_lobe; ++i) {
      const Lobe::Row row = lobe.row(pi * i / samples_of_lobe - pi / 2);
      longest_ = std::max(longest_, row.half_length);
    }
  }
  integrate();
}

PatchBound::PatchBound(const PatchShape& shape, const BoundTable& table)
    : shape_(shape), table_(std::make_shared<BoundTable>(table)), peak_(table.peak()) {
  require_positive("peak", peak_);
  integrate();
}

double PatchBound::operator()(std::size_t lobe, double psi, double theta) const {
  if (table_) return (*table_)(shape_, lobe, psi, theta);
  return peak_ * (shape_.lobes()[lobe].row(psi).half_length / longest_) * std::sin(theta);
}

void PatchBound::integrate() {
  total_ = integral_over(shape_, *this);
  turning_moment_ = integral_over(shape_, [&](std::size_t l, double psi, double theta) {
    const Lobe::Row row = shape_.lobes()[l].row(psi);
    const double x = row.middle + row.half_length * std::cos(theta);
    return (*this)(l, psi, theta) * std::hypot(x, shape_.lobes()[l].y(psi));
  });
}

}  // namespace microslip
