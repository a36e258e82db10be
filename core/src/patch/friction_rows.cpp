// SPDX-License-Identifier: GPL-3.0-or-later
#include "friction_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Points are not closer than this part of the half-length of a row, over the number of cells.
constexpr double spacing_of_points = 0.5;

/// Between two values that may be infinite, if they are equal.
double between(double from, double to, double part) {
  return from == to ? from : std::lerp(from, to, part);
}

template <class Points>
double ratio_at(const Points& points, double x) {
  const auto above = std::ranges::upper_bound(points, x, {}, [](const auto& p) { return p.x; });
  if (above == points.begin()) return points.front().ratio;
  if (above == points.end()) return points.back().ratio;
  const auto below = above - 1;
  return std::lerp(below->ratio, above->ratio, (x - below->x) / (above->x - below->x));
}

}  // namespace

FrictionRows::FrictionRows(const JoinedRows& rows, const SlipFriction& friction,
                           double size_of_patch, double size)
    : rows_(&rows),
      friction_(friction),
      unit_(size_of_patch),
      size_(size),
      ratios_(VectorXd::Ones(rows.cells())) {
  if (!friction_.remembers()) return;
  for (Index k = 0; k < rows.rows(); ++k) points_.push_back(new_row(k));
}

FrictionRows::Points FrictionRows::new_row(Index k) const {
  Points points{{size_ * rows_->x(2 * rows_->elements(), k), 1}};
  for (Index i = rows_->elements() - 1; i >= 0; --i) points.push_back({centre(i, k), 1});
  points.push_back({edge(k), 1});
  return points;
}

/// Linear between the centres, and constant beyond them.
double FrictionRows::speed_at(double x, Index k, const VectorXd& speeds) const {
  const Index last = rows_->elements() - 1;
  Index i = 0;  // the first centre that is not ahead of x
  while (i <= last && centre(i, k) > x) ++i;
  if (i == 0) return speeds[rows_->cell(0, k)];
  if (i > last) return speeds[rows_->cell(last, k)];
  const double ahead = centre(i - 1, k), here = centre(i, k);
  return between(speeds[rows_->cell(i, k)], speeds[rows_->cell(i - 1, k)],
                 (x - here) / (ahead - here));
}

/// The ratio of material on its way through a row, from centre to centre.
double FrictionRows::after_way(double from, double to, Index k, const VectorXd& speeds,
                               double ratio) const {
  double x = from, speed = speed_at(from, k, speeds);
  const auto go = [&](double next, double there) {
    ratio = friction_.ratio_after(ratio, speed, there, unit_ * (x - next) / friction_.speed);
    x = next;
    speed = there;
  };
  for (Index i = 0; i < rows_->elements(); ++i) {
    const double place = centre(i, k);
    if (place < x && place > to) go(place, speeds[rows_->cell(i, k)]);
  }
  if (to < x) go(to, speed_at(to, k, speeds));
  return ratio;
}

/// The ratio of material that is at x at the end of a step.
double FrictionRows::after_step(double x, double dq, Index k, const VectorXd& speeds) const {
  const double from = std::min(x + dq, edge(k));
  const bool enters = x + dq >= edge(k);
  const double before = enters ? 1 : ratio_at(points_[static_cast<std::size_t>(k)], from);
  return after_way(from, x, k, speeds, before);
}

void FrictionRows::follow(double dq, const VectorXd& speeds, VectorXd& ratios) const {
  ratios.resize(rows_->cells());
  for (Index k = 0; k < rows_->rows(); ++k) {
    for (Index i = 0; i < rows_->elements(); ++i) {
      const Index cell = rows_->cell(i, k);
      if (!friction_.remembers()) {
        ratios[cell] = friction_.law(speeds[cell]);
      } else if (i > 0 && centre(i, k) + dq >= edge(k)) {  // has come along the centre before
        ratios[cell] = after_way(centre(i - 1, k), centre(i, k), k, speeds, ratios[cell - 1]);
      } else {
        ratios[cell] = after_step(centre(i, k), dq, k, speeds);
      }
    }
  }
}

void FrictionRows::take(double dq, const VectorXd& speeds) {
  follow(dq, speeds, ratios_);
  for (std::size_t k = 0; k < points_.size(); ++k) {
    points_[k] = moved(points_[k], static_cast<Index>(k), dq, speeds);
  }
}

/// The points of a row at the end of a step. Points behind the trailing edge go, but for the first,
/// which follows the law as if it were within; so do those ahead of the leading edge of a contact
/// that became shorter.
FrictionRows::Points FrictionRows::moved(const Points& points, Index k, double dq,
                                         const VectorXd& speeds) const {
  const double trailing = size_ * rows_->x(2 * rows_->elements(), k), leading = edge(k);
  Points found;
  const auto add = [&](double x, double ratio) {
    if (found.size() == 1 && x <= trailing) found.clear();
    found.push_back({x, ratio});
  };
  for (const Point& point : points) {
    const double x = point.x - dq, from = std::min(point.x, leading);
    if (x >= leading) break;
    if (found.empty() && x > trailing) add(trailing, 1);  // has come in from behind
    add(x, after_way(from, x, k, speeds, point.ratio));
  }
  const double spacing =
      spacing_of_points * size_ * rows_->half_length(k) / static_cast<double>(rows_->elements());
  for (Index i = rows_->elements() - 1; i >= 0; --i) {
    const double x = centre(i, k);
    if (found.empty() || x - found.back().x > spacing) add(x, ratios_[rows_->cell(i, k)]);
  }
  const std::size_t size = found.size();
  if (size > 2 && found[size - 1].x - found[size - 2].x < spacing) found.pop_back();
  found.push_back({leading, 1});
  return found;
}

/// A row at y of another size, by the two rows about it: what is remembered at the same part of the
/// length of rows, linearly.
void FrictionRows::resize(double size) {
  const JoinedRows& rows = *rows_;
  const double b = rows.shape().lateral_half_width();
  std::vector<Points> found = points_;
  for (std::size_t row = 0; row < found.size(); ++row) {
    const auto k = static_cast<Index>(row);
    const double sine = std::clamp(size * rows.y(k) / (size_ * b), -1.0, 1.0);
    const double at =
        (std::asin(sine) / std::numbers::pi + 0.5) * static_cast<double>(rows.rows()) - 0.5;
    const double last = static_cast<double>(rows.rows() - 1);
    const double below = std::clamp(std::floor(at), 0.0, last), above = std::min(below + 1, last);
    const double scale =
        std::cos(std::asin(sine)) * rows.shape().half_width() / rows.half_length(k);
    const auto value = [&](double from, double s) {
      const auto of = static_cast<Index>(from);
      return ratio_at(points_[static_cast<std::size_t>(of)], s * size_ * rows.half_length(of));
    };
    for (Point& point : found[row]) {
      const double s = point.x / (size_ * rows.half_length(k));
      point.ratio = std::lerp(value(below, s), value(above, s), std::clamp(at - below, 0.0, 1.0));
      point.x *= scale;
    }
  }
  points_ = std::move(found);
  size_ = size;
}

void FrictionRows::archive(Archive& archive) {
  constexpr Index most = 1 << 20;
  archive.number("friction_speed", friction_.speed);
  archive.number("friction_size", size_);
  archive.numbers("friction_ratios", ratios_, rows_->cells());
  for (Points& row : points_) {
    auto count = static_cast<Index>(row.size());
    archive.whole("friction_points", count, 2, most);
    VectorXd numbers(2 * count);
    for (Index i = 0; !archive.reads() && i < count; ++i) {
      const Point& point = row[static_cast<std::size_t>(i)];
      numbers.segment<2>(2 * i) << point.x, point.ratio;
    }
    archive.numbers("friction", numbers, 2 * count);
    if (!archive.reads()) continue;
    row.clear();
    for (Index i = 0; i < count; ++i) row.push_back({numbers[2 * i], numbers[2 * i + 1]});
  }
}

}  // namespace microslip
