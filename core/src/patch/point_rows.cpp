// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_rows.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr double printed_edge = 1e-4;

/// Largest part of a lobe's height without a row of points.
constexpr double widest_gap = 1.0 / 3;

/// A point of a table in the shape.
struct PlacedPoint {
  std::size_t lobe;
  double y, s;
  Index point;  ///< in the table
};

std::optional<PlacedPoint> placed(const PatchShape& shape, double x, double y, Index point) {
  for (std::size_t l = 0; l < shape.lobes().size(); ++l) {
    const Lobe& lobe = shape.lobes()[l];
    if (y < lobe.low() || y > lobe.high()) continue;
    const Lobe::Row row = lobe.row(lobe.psi(y));
    const double away = x - row.middle;
    if (std::abs(away) > (1 + printed_edge) * row.half_length) continue;
    if (row.half_length < printed_edge * lobe.height()) return PlacedPoint{l, y, 0, point};
    double s = std::clamp(away / row.half_length, -1.0, 1.0);
    if (std::abs(s) > 1 - printed_edge) s = std::copysign(1, s);
    return PlacedPoint{l, y, s, point};
  }
  return std::nullopt;
}

}  // namespace

PointRows rows_of_points(const PatchShape& shape, const VectorXd& x, const VectorXd& y) {
  PointRows found;
  found.lobes.resize(shape.lobes().size());
  std::vector<PlacedPoint> points;
  for (Index i = 0; i < x.size(); ++i) {
    require(true, fmt::format("row {}: x", i + 1), x[i], "a finite number");
    require(true, fmt::format("row {}: y", i + 1), y[i], "a finite number");
    if (const auto point = placed(shape, x[i], y[i], i)) {
      points.push_back(*point);
    } else {
      found.outside.push_back(i);
    }
  }
  std::ranges::sort(points, [](const PlacedPoint& one, const PlacedPoint& other) {
    return std::tie(one.lobe, one.y, one.s) < std::tie(other.lobe, other.y, other.s);
  });
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PlacedPoint& point = points[i];
    std::vector<PointRow>& rows = found.lobes[point.lobe];
    if (rows.empty() || rows.back().y != point.y) rows.push_back({point.y, {}, {}});
    PointRow& row = rows.back();
    require(row.s.empty() || point.s > row.s.back(), fmt::format("row {}: x", point.point + 1),
            x[point.point], "a point that is in no other row");
    row.s.push_back(point.s);
    row.points.push_back(point.point);
  }
  return found;
}

void require_rows(const Lobe& lobe, const std::vector<double>& y, std::size_t most,
                  const char* name) {
  const auto where = [&] {
    return fmt::format("y from {} to {} mm", format_short(lobe.low()), format_short(lobe.high()));
  };
  require(y.size() >= 3, fmt::format("number of y with {}", name), static_cast<double>(y.size()),
          [&] { return "three or more within the edges for " + where(); });
  double below = lobe.low();
  const auto require_near = [&](double next) {
    require(next - below <= widest_gap * 2 * lobe.height(), "y", next, [&] {
      return fmt::format("{} between {} mm and here, too: gaps of at most a third of {}", name,
                         format_short(below), where());
    });
    below = next;
  };
  for (const double row : y) require_near(row);
  require_near(lobe.high());
  require(most >= 3, fmt::format("number of x with {} on one y", name), static_cast<double>(most),
          [&] { return "three or more within the edges for some " + where(); });
}

}  // namespace microslip
