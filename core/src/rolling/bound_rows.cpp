// SPDX-License-Identifier: GPL-3.0-or-later
#include "bound_rows.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {

BoundRows::BoundRows(const TractionBound& bound) : half_width_(half_width_of(bound)) {
  const auto* table = std::get_if<TabulatedBound>(&bound);
  if (table == nullptr) {
    edges_.emplace(Edges{{bound, SidedBound::Edge::trailing}, {bound, SidedBound::Edge::leading}});
    x_ = {-half_width_, half_width_};
    value_ = {0, 0};
    slope_ = {0};
    return;
  }
  const auto& x = table->x();
  const auto& g = table->values();
  Eigen::Index first = 0, last = x.size() - 1;
  const auto coincide = [&](Eigen::Index i) { return x[i + 1] <= x[i]; };
  while (first < last && (coincide(first) || (g[first] == 0 && g[first + 1] == 0))) ++first;
  while (last > first && (coincide(last - 1) || (g[last] == 0 && g[last - 1] == 0))) --last;
  for (Eigen::Index i = first; i <= last; ++i) {
    x_.push_back(x[i]);
    value_.push_back(g[i]);
  }
  for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
    slope_.push_back((value_[i + 1] - value_[i]) / (x_[i + 1] - x_[i]));
  }
}

RowPlace BoundRows::place_of(double x) const {
  const auto next = std::upper_bound(x_.begin(), x_.end(), x);
  std::size_t row = next == x_.begin() ? 0 : static_cast<std::size_t>(next - x_.begin()) - 1;
  if (row + 1 < x_.size() && x_[row + 1] - x < x - x_[row]) ++row;
  return {row, x - x_[row]};
}

double BoundRows::between(std::size_t row, double behind, double ahead) const {
  if (edges_) return behind < ahead ? edges_->trailing(behind) : edges_->leading(ahead);
  const double slope = slope_[row];
  return std::max(0.0,
                  behind < ahead ? value_[row] + slope * behind : value_[row + 1] - slope * ahead);
}

std::size_t BoundRows::piece_of(const RowPlace& place) const {
  std::size_t row = std::min(place.row, x_.size() - 2);
  while (row > 0 && distance({row, 0}, place) < 0) --row;
  while (row + 2 < x_.size() && distance({row + 1, 0}, place) >= 0) ++row;
  return row;
}

double BoundRows::bound(const RowPlace& place) const {
  const std::size_t row = piece_of(place);
  const double behind = distance({row, 0}, place), ahead = distance(place, {row + 1, 0});
  return behind < 0 || ahead < 0 ? 0 : between(row, behind, ahead);
}

namespace {

/// d ln|d|, 0 at d = 0
double entropy(double d) { return d == 0 ? 0 : d * std::log(std::abs(d)); }

}  // namespace

double BoundRows::sliding_transform(const RowPlace& place) const {
  double sum = 0, before = 0;
  const std::size_t last = x_.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const double d = -distance(place, {i, 0});
    const double slope = i < last ? slope_[i] : 0;
    sum += (slope - before) * entropy(d);
    before = slope;
    if (i == 0 && value_[i] != 0) sum += value_[i] * (std::log(std::abs(d)) + 1);
    if (i == last && value_[i] != 0) sum -= value_[i] * (std::log(std::abs(d)) + 1);
  }
  return sum;
}

double BoundRows::sliding_potential(double x) const {
  double sum = 0, before = 0;
  const std::size_t last = x_.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const double d = x - x_[i];
    const double slope = i < last ? slope_[i] : 0;
    sum += (slope - before) * (d / 2 * entropy(d) - 0.75 * d * d);
    before = slope;
    const double jump = i == 0 ? value_[i] : i == last ? -value_[i] : 0;
    if (jump != 0) sum += jump * (entropy(d) - d);
  }
  return sum;
}

}  // namespace microslip
