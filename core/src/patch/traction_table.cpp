// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/traction_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "point_rows.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixX2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

/// Largest traction above the bound, over its peak: the bound by the pressure of rectangles is off by
/// that.
constexpr double tolerated_excess = 0.01;

/// Finds the interval of rising places about one, and how far it is in there: the first or the last
/// one, and 0 or 1, beyond the ends.
/// \param place  of an element
template <class Elements, class Place>
std::pair<std::size_t, double> interval_about(const Elements& elements, double at,
                                              const Place& place) {
  if (elements.size() == 1) return {0, 0};
  const auto above =
      std::ranges::upper_bound(elements.begin() + 1, elements.end() - 1, at, {}, place);
  const auto i = static_cast<std::size_t>(above - elements.begin()) - 1;
  const double from = place(elements[i]), to = place(elements[i + 1]);
  return {i, std::clamp((at - from) / (to - from), 0.0, 1.0)};
}

}  // namespace

TractionTable::TractionTable(const PatchBound& bound, const VectorXd& x, const VectorXd& y,
                             const MatrixX2d& tractions)
    : shape_(bound.shape()) {
  require(x.size() == y.size() && x.size() == tractions.rows() && x.size() > 0, "number of rows",
          static_cast<double>(x.size()), "as many values of x, y and tractions, at least one");
  for (Index i = 0; i < x.size(); ++i) {
    require(true, fmt::format("row {}: traction_x", i + 1), tractions(i, 0), "a finite number");
    require(true, fmt::format("row {}: traction_y", i + 1), tractions(i, 1), "a finite number");
  }
  const PointRows found = rows_of_points(shape_, x, y);
  for (const Index i : found.outside) left_out_ += tractions.row(i).norm() > 0;
  for (std::size_t l = 0; l < found.lobes.size(); ++l) {
    const Lobe& lobe = shape_.lobes()[l];
    std::vector<Row>& rows = lobes_.emplace_back();
    std::vector<double> at;
    std::size_t most = 0;
    for (const PointRow& points : found.lobes[l]) {
      Row row{.y = points.y, .places = points.s, .values = {}};
      for (std::size_t j = 0; j < points.s.size(); ++j) {
        const Index i = points.points[j];
        const double largest = bound(l, lobe.psi(points.y), std::acos(points.s[j]));
        const double size = tractions.row(i).norm();
        require(size <= largest + tolerated_excess * bound.peak(),
                fmt::format("row {}: traction", i + 1), size,
                [&] { return fmt::format("at most the bound, {} N/mm^2", format_short(largest)); });
        row.values.emplace_back(size == 0 ? Vector2d(0, 0)
                                          : Vector2d(tractions.row(i) / std::max(size, largest)));
      }
      at.push_back(row.y);
      most = std::max(most, row.places.size());
      rows.push_back(std::move(row));
    }
    require_rows(lobe, at, most, "tractions");
  }
}

Vector2d TractionTable::within(const Row& row, double s) {
  const auto [i, part] = interval_about(row.places, s, [](double place) { return place; });
  if (part == 0) return row.values[i];
  const double from = (1 - part) * (1 + row.places[i]), to = part * (1 + row.places[i + 1]);
  return (from * row.values[i] + to * row.values[i + 1]) / (1 + s);
}

Vector2d TractionTable::in_lobe(std::size_t lobe, double s, double y) const {
  const std::vector<Row>& rows = lobes_[lobe];
  const auto [i, part] = interval_about(rows, y, [](const Row& row) { return row.y; });
  if (part == 0) return within(rows[i], s);
  return (1 - part) * within(rows[i], s) + part * within(rows[i + 1], s);
}

Vector2d TractionTable::operator()(double x, double y) const {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity(), place = 0;
  for (std::size_t l = 0; l < lobes_.size(); ++l) {
    const Lobe& lobe = shape_.lobes()[l];
    const Lobe::Row row = lobe.row(lobe.psi(y));
    const double aside = std::max({lobe.low() - y, y - lobe.high(), 0.0});
    const double beyond = std::max(0.0, std::abs(x - row.middle) - row.half_length);
    const double distance = std::hypot(aside, beyond);
    if (distance >= least) continue;
    nearest = l;
    least = distance;
    place = row.half_length > 0 ? std::clamp((x - row.middle) / row.half_length, -1.0, 1.0) : 0;
  }
  return in_lobe(nearest, place, y);
}

}  // namespace microslip
