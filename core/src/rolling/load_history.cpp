// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/load_history.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Array3d;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

std::string named(Index row, const std::string& column) {
  return fmt::format("row {}: {}", row + 1, column);
}

void require_finite(const VectorXd& column, Index rows, const std::string& name) {
  require(column.size() == rows, "number of rows of " + name, static_cast<double>(column.size()),
          [&] { return fmt::format("{}, as of the first column", rows); });
  for (Index i = 0; i < rows; ++i) {
    if (!std::isfinite(column[i])) require(false, named(i, name), column[i], "a finite number");
  }
}

void require_times(const VectorXd& column) {
  for (Index i = 1; i < column.size(); ++i) {
    if (column[i] > column[i - 1]) continue;
    require(false, named(i, "t"), column[i],
            fmt::format("more than {} of the row before", format_short(column[i - 1])));
  }
}

constexpr const char* not_backwards = "rolling backwards is not in this version";

void require_distances(const VectorXd& column) {
  for (Index i = 1; i < column.size(); ++i) {
    if (column[i] >= column[i - 1]) continue;
    require(false, named(i, "q"), column[i],
            fmt::format("at least {} of the row before; {}", format_short(column[i - 1]),
                        not_backwards));
  }
}

void require_velocities(const RunRows& rows) {
  const VectorXd& velocity = *rows.velocity;
  for (Index i = 0; i < velocity.size(); ++i) {
    if (velocity[i] < 0) {
      require(false, named(i, "v"), velocity[i], fmt::format("a number >= 0; {}", not_backwards));
    }
    if (velocity[i] > 0 || !rows.angular_velocity || (*rows.angular_velocity)[i] == 0) continue;
    require(false, named(i, "omega"), (*rows.angular_velocity)[i],
            "0 where v is 0; a shift, without rolling, is not in runs of this version");
  }
}

/// A printed number may differ by as much, over the largest of its column.
constexpr double printed_number = 1e-9;

/// Rejects a column that changes from a row to the next one where nothing is rolled.
/// \param distances  of the rows  [mm]
void require_kept_at_standstill(const std::optional<VectorXd>& column, const std::string& name,
                                const std::vector<double>& distances) {
  if (!column) return;
  const double most = printed_number * column->lpNorm<Eigen::Infinity>();
  for (Index i = 1; i < column->size(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    const double before = (*column)[i - 1];
    if (distances[row] > distances[row - 1] || std::abs((*column)[i] - before) <= most) continue;
    require(false, named(i, name), (*column)[i],
            fmt::format("{} of the row before, as nothing is rolled between them; a shift, which "
                        "changes the load without rolling, is not in runs of this version",
                        format_short(before)));
  }
}

/// \throws std::invalid_argument unless the columns fit together
void require_columns(const RunRows& rows) {
  if (rows.distance.has_value() == rows.time.has_value()) {
    throw std::invalid_argument("columns: expected either q or t");
  }
  const int loads = int(rows.creepage.has_value()) + int(rows.force.has_value()) +
                    int(rows.angular_velocity.has_value());
  if (loads != 1) {
    throw std::invalid_argument("columns: expected one of creepage, force and omega");
  }
  if (rows.time.has_value() != rows.velocity.has_value()) {
    throw std::invalid_argument("columns: expected v where there is t, and only there");
  }
  if (rows.angular_velocity && rows.distance) {
    throw std::invalid_argument("columns: expected t and v where there is omega");
  }
}

/// The slopes of linear functions from row to row; 0 between rows at one place.
std::vector<double> slopes(const std::vector<double>& values, const std::vector<double>& lengths) {
  std::vector<double> found;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    found.push_back(lengths[i] > 0 ? (values[i + 1] - values[i]) / lengths[i] : 0);
  }
  return found;
}

std::vector<double> in_std(const VectorXd& values) { return {values.begin(), values.end()}; }

/// A column of the contact divided by the problem's value; empty without the column.
std::vector<double> sizes(const std::optional<VectorXd>& column, Index rows,
                          const std::string& name, double of_problem) {
  if (!column) return {};
  require_positive(name + " of the problem", of_problem);
  require_finite(*column, rows, name);
  for (Index i = 0; i < rows; ++i) {
    if ((*column)[i] < 0) require(false, named(i, name), (*column)[i], "a number >= 0");
  }
  return in_std(*column / of_problem);
}

}  // namespace

LoadHistory::LoadHistory(const RunRows& rows) {
  require_columns(rows);
  const VectorXd& along = rows.time ? *rows.time : *rows.distance;
  const std::string name = rows.time ? "t" : "q";
  const Index n = along.size();
  require(n >= 2, "number of rows", static_cast<double>(n), "at least 2");
  require_finite(along, n, name);
  if (rows.time) {
    require_times(along);
  } else {
    require_distances(along);
  }
  for (Index i = 1; i < n; ++i) lengths_.push_back(along[i] - along[i - 1]);
  speed_.assign(static_cast<std::size_t>(n), 1);
  if (rows.velocity) {
    require_finite(*rows.velocity, n, "v");
    if (rows.angular_velocity) require_finite(*rows.angular_velocity, n, "omega");
    require_velocities(rows);
    speed_ = in_std(*rows.velocity);
    times_ = in_std(*rows.time);
  }
  distances_ = {0};
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    distances_.push_back(distances_[i] + lengths_[i] * (speed_[i] + speed_[i + 1]) / 2);
  }

  require_positive("distance of the rows", distances_.back());
  const auto last = std::lower_bound(distances_.begin(), distances_.end(), distances_.back());
  last_row_ = static_cast<std::size_t>(last - distances_.begin()) - 1;

  take_contact(rows);
  if (rows.force) {
    require_finite(*rows.force, n, rows.force_name);
    require_kept_at_standstill(rows.force, rows.force_name, distances_);
    force_ = in_std(*rows.force);
    return;
  }
  const std::vector<double> acceleration = slopes(speed_, lengths_);
  if (rows.creepage) {
    require_finite(*rows.creepage, n, rows.creepage_name);
    const std::vector<double> creepage = in_std(*rows.creepage);
    const std::vector<double> change = slopes(creepage, lengths_);
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      shift_rate_.emplace_back(creepage[i] * speed_[i],
                               creepage[i] * acceleration[i] + change[i] * speed_[i],
                               change[i] * acceleration[i]);
    }
    return;
  }
  require_positive("radius", rows.radius);
  const std::vector<double> slip = in_std(*rows.velocity - rows.radius * *rows.angular_velocity);
  const std::vector<double> change = slopes(slip, lengths_);
  for (std::size_t i = 0; i < lengths_.size(); ++i) shift_rate_.emplace_back(slip[i], change[i], 0);
}

void LoadHistory::take_contact(const RunRows& rows) {
  if (rows.normal_load && (rows.half_width || rows.peak_traction)) {
    throw std::invalid_argument(
        "columns: expected half_width and peak_traction, or normal_load, from which they follow");
  }
  if (rows.peak_traction && rows.friction) {
    throw std::invalid_argument("columns: expected peak_traction or friction, which it includes");
  }
  const auto n = static_cast<Index>(distances_.size());
  const RunRows::Reference& reference = rows.of_problem;
  point_contact_ = rows.point_contact;
  load_ = sizes(rows.normal_load, n, "normal_load", reference.normal_load);
  size_ = sizes(rows.half_width, n, "half_width", reference.half_width);
  bound_ = rows.friction ? sizes(rows.friction, n, "friction", reference.friction)
                         : sizes(rows.peak_traction, n, "peak_traction", reference.peak_traction);
  for (const double distance : distances_) {
    if (changes_contact() && !contact_at(distance).carries()) lost_.push_back(distance);
  }
  require_kept_at_standstill(rows.normal_load, "normal_load", distances_);
  require_kept_at_standstill(rows.half_width, "half_width", distances_);
  require_kept_at_standstill(rows.peak_traction, "peak_traction", distances_);
  require_kept_at_standstill(rows.friction, "friction", distances_);
}

double LoadHistory::distance() const {
  return constant_ ? std::numeric_limits<double>::infinity() : distances_.back();
}

/// Finds the place of a distance, in a row that rolls. Within a row the distance is quadratic in
/// time.
LoadHistory::Place LoadHistory::place_of(double distance) const {
  const auto last = distances_.begin() + static_cast<std::ptrdiff_t>(last_row_) + 1;
  const auto next = std::upper_bound(distances_.begin() + 1, last, distance);
  const auto row = static_cast<std::size_t>(next - distances_.begin()) - 1;
  const double speed = speed_[row];
  const double acceleration = (speed_[row + 1] - speed) / lengths_[row];
  const double rolled = distance - distances_[row];
  const double speed_there = std::sqrt(std::max(0.0, speed * speed + 2 * acceleration * rolled));
  const double twice_mean = speed + speed_there;
  return {row, twice_mean > 0 ? std::min(lengths_[row], 2 * rolled / twice_mean) : 0};
}

/// The rigid shift between two places within a row  [mm]
double LoadHistory::shift_within(std::size_t row, double from, double to) const {
  const Array3d& rate = shift_rate_[row];
  const Array3d means(1, (from + to) / 2, (from * from + from * to + to * to) / 3);
  return (to - from) * (rate * means).sum();
}

double LoadHistory::between_rows(const std::vector<double>& column, const Place& at) const {
  return std::lerp(column[at.row], column[at.row + 1], at.since / lengths_[at.row]);
}

double LoadHistory::force_at(double distance) const {
  return between_rows(force_, place_of(distance));
}

ContactScale LoadHistory::contact_at(double distance) const {
  if (!changes_contact()) return {};
  const Place at = place_of(distance);
  const double bound = bound_.empty() ? 1 : between_rows(bound_, at);
  if (!load_.empty()) {
    const double load = between_rows(load_, at);
    return point_contact_ ? hertz_point_scale(load, bound) : hertz_scale(load, bound);
  }
  return {.half_width = size_.empty() ? 1 : between_rows(size_, at), .bound = bound};
}

std::optional<double> LoadHistory::lost_between(double from, double to) const {
  const auto next = std::ranges::upper_bound(lost_, from);
  if (next == lost_.end() || *next >= to) return std::nullopt;
  return *next;
}

Load LoadHistory::at(double distance) const {
  if (constant_) return *constant_;
  if (!force_.empty()) return PrescribedForce{force_at(distance)};
  const Place there = place_of(distance);
  const Array3d& rate = shift_rate_[there.row];
  const double speed = between_rows(speed_, there);
  if (speed > 0) {
    return PrescribedCreepage{(rate[0] + there.since * (rate[1] + there.since * rate[2])) / speed};
  }
  // Next to a standstill both are 0: the ratio of their slopes in time.
  const double acceleration = (speed_[there.row + 1] - speed_[there.row]) / lengths_[there.row];
  return PrescribedCreepage{(rate[1] + 2 * there.since * rate[2]) / acceleration};
}

std::optional<double> LoadHistory::time_at(double distance) const {
  if (times_.empty()) return std::nullopt;
  const Place there = place_of(distance);
  return times_[there.row] + there.since;
}

Load LoadHistory::between(double from, double to) const {
  if (constant_) return *constant_;
  if (!force_.empty()) return PrescribedForce{force_at(to)};
  const Place begin = place_of(from);
  const Place end = place_of(to);
  if (begin.row == end.row) {
    return PrescribedCreepage{shift_within(begin.row, begin.since, end.since) / (to - from)};
  }
  double shift = shift_within(begin.row, begin.since, lengths_[begin.row]);
  for (std::size_t row = begin.row + 1; row < end.row; ++row) {
    shift += shift_within(row, 0, lengths_[row]);
  }
  shift += shift_within(end.row, 0, end.since);
  return PrescribedCreepage{shift / (to - from)};
}

}  // namespace microslip
