// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/patch_bound.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "microslip/support/require.hpp"
#include "point_rows.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

BoundTable::BoundTable(const PatchShape& shape, const VectorXd& x, const VectorXd& y,
                       const VectorXd& values, Zeros zeros) {
  require(x.size() == y.size() && x.size() == values.size() && x.size() > 0, "number of rows",
          static_cast<double>(x.size()), "as many values of x, y and bound, at least one");
  for (Index i = 0; i < x.size(); ++i) {
    require(values[i] >= 0 && values[i] <= 1e50, fmt::format("row {}: bound", i + 1), values[i],
            "a number from 0 to 1e50 N/mm^2");
  }
  const PointRows found = rows_of_points(shape, x, y);
  for (const Index i : found.outside) left_out_ += values[i] > 0;
  for (const auto& rows : found.lobes) {
    Rows& lobe = lobes_.emplace_back();
    for (const PointRow& row : rows) {
      if (auto known = row_of(row, values, zeros)) lobe.push_back(std::move(*known));
    }
  }
  require(peak_ > 0, "largest bound within the edges", peak_, "a number > 0");
  for (std::size_t l = 0; l < lobes_.size(); ++l) {
    std::vector<double> at;
    std::size_t most = 0;
    for (const Row& row : lobes_[l]) {
      at.push_back(row.y);
      most = std::max(most, row.places.size() - 2);
    }
    require_rows(shape.lobes()[l], at, most, "a bound > 0");
  }
}

/// Returns the points of a row, with ends; nothing if there is none. Zeros that are left out are those
/// next to the edges, which are outside; those of the edges themselves are without them, too.
std::optional<BoundTable::Row> BoundTable::row_of(const PointRow& row, const VectorXd& values,
                                                  Zeros zeros) {
  const bool keeps_zeros = zeros == Zeros::kept;
  std::size_t from = 0, to = row.points.size();
  while (!keeps_zeros && from < to && values[row.points[from]] == 0) ++from;
  while (!keeps_zeros && to > from && values[row.points[to - 1]] == 0) --to;
  if (from == to) return std::nullopt;
  Row found{.y = row.y, .places = {}, .squares = {}};
  const auto add = [&](double s, double square) {
    found.places.push_back(s);
    found.squares.push_back(square);
  };
  if (row.s[from] > -1) add(-1, 0);
  for (std::size_t i = from; i < to; ++i) {
    const double value = values[row.points[i]];
    require(value > 0 || keeps_zeros, fmt::format("row {}: bound", row.points[i] + 1), value,
            "a number > 0 between others that are");
    add(row.s[i], value * value);
    peak_ = std::max(peak_, value);
  }
  if (row.s[to - 1] < 1) add(1, 0);
  return found;
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

BoundTable BoundTable::turned() const {
  BoundTable table = *this;
  for (Rows& rows : table.lobes_) {
    for (Row& row : rows) {
      std::ranges::reverse(row.places);
      std::ranges::reverse(row.squares);
      for (double& place : row.places) place = -place;
    }
  }
  return table;
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

PatchBound PatchBound::turned() const {
  PatchBound bound = *this;
  bound.shape_ = shape_.turned();
  if (table_) bound.table_ = std::make_shared<const BoundTable>(table_->turned());
  return bound;
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
