// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/load_history.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "microslip/support/require.hpp"
#include "run_rows.hpp"

namespace microslip {

using Eigen::Array3d;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// The slopes of linear functions from row to row; 0 between rows at one place.
std::vector<double> slopes(const std::vector<double>& values, const std::vector<double>& lengths) {
  std::vector<double> found;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    found.push_back(lengths[i] > 0 ? (values[i + 1] - values[i]) / lengths[i] : 0);
  }
  return found;
}

std::vector<double> in_std(const VectorXd& values) { return {values.begin(), values.end()}; }

}  // namespace

LoadHistory::LoadHistory(const RunRows& rows) {
  require_rows(rows);
  TurningRows all = with_turns(rows);
  of_rows_ = std::move(all.of_file);
  take_way(all.rows);
  take_scales(all.rows);
  take_load(all.rows);
  find_stops();
}

/// Takes distances, positions, speeds and times.
void LoadHistory::take_way(const RunRows& rows) {
  const VectorXd& along = rows.time ? *rows.time : *rows.distance;
  speed_.assign(static_cast<std::size_t>(along.size()), 1);
  if (rows.velocity) {
    speed_ = in_std(rows.velocity->cwiseAbs());
    times_ = in_std(*rows.time);
  }
  distances_ = positions_ = {0};
  for (Index i = 1; i < along.size(); ++i) {
    const auto row = static_cast<std::size_t>(i) - 1;
    const double change = along[i] - along[i - 1];
    const double sense = rows.velocity ? (*rows.velocity)[i - 1] + (*rows.velocity)[i] : change;
    lengths_.push_back(std::abs(change));
    const double rolled = lengths_[row] * (speed_[row] + speed_[row + 1]) / 2;
    distances_.push_back(distances_[row] + rolled);
    const bool stands = distances_[row + 1] == distances_[row];
    direction_.push_back(stands ? 0 : sense > 0 ? 1 : -1);
    positions_.push_back(positions_[row] + direction_[row] * rolled);
  }
  require_positive("distance of the rows", distances_.back());
  const auto last = std::lower_bound(distances_.begin(), distances_.end(), distances_.back());
  last_row_ = static_cast<std::size_t>(last - distances_.begin()) - 1;
}

/// Takes the force, or the rate of the rigid shift in time or distance.
void LoadHistory::take_load(const RunRows& rows) {
  if (rows.force) {
    force_ = in_std(*rows.force);
    largest_force_ = rows.force->lpNorm<Eigen::Infinity>();
    force_acts_before_ = rows.force_acts_before;
    return;
  }
  const auto take_shift = [&](const std::vector<double>& rate) {
    const std::vector<double> change = slopes(rate, lengths_);
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      shift_rate_.emplace_back(rate[i], change[i], 0);
    }
  };
  if (rows.angular_velocity) {
    return take_shift(in_std(*rows.velocity - rows.radius * *rows.angular_velocity));
  }
  const std::vector<double> acceleration = slopes(speed_, lengths_);
  const std::vector<double> creepage = in_std(*rows.creepage);
  const std::vector<double> change = slopes(creepage, lengths_);
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    shift_rate_.push_back(direction_[i] *
                          Array3d(creepage[i] * speed_[i],
                                  creepage[i] * acceleration[i] + change[i] * speed_[i],
                                  change[i] * acceleration[i]));
  }
}

LoadHistory::Standing LoadHistory::standing_in(std::size_t row) const {
  constexpr double printed = 1e-9;  // relative: numbers of tables have few digits
  const auto differ = [&](double before, double after) {
    return std::abs(after - before) > printed * std::max(std::abs(before), std::abs(after));
  };
  const ContactScale before = contact_in(row), after = contact_in(row + 1);
  Standing found{
      .load = PrescribedShift{0},
      .contact = after,
      .changes = differ(before.half_width, after.half_width) || differ(before.bound, after.bound),
      .time = {}};
  if (!times_.empty()) found.time = times_[row + 1];
  if (!force_.empty()) {
    const double before_row = row == 0 && !force_acts_before_ ? 0 : force_[row];
    const double change = std::abs(force_[row + 1] - before_row);
    found.load = PrescribedForce{force_[row + 1]};
    found.changes = found.changes || change > printed * largest_force_;
    return found;
  }
  const double shift = shift_within(row, 0, lengths_[row]);
  found.load = PrescribedShift{shift};
  found.changes = found.changes || shift != 0;
  return found;
}

void LoadHistory::find_stops() {
  int direction = 0;
  for (std::size_t row = 0; row < direction_.size(); ++row) {
    const bool turns = direction_[row] * direction < 0;
    const bool shifts = direction_[row] == 0 && standing_in(row).changes;
    if (direction_[row] != 0) direction = direction_[row];
    const bool is_new = stops_.empty() || stops_.back() < distances_[row];
    if ((turns || shifts) && is_new) stops_.push_back(distances_[row]);
  }
}

std::vector<LoadHistory::Standing> LoadHistory::standing_at(double distance) const {
  std::vector<Standing> found;
  const auto [first, behind] = std::equal_range(distances_.begin(), distances_.end(), distance);
  const auto end = static_cast<std::size_t>(behind - distances_.begin());
  for (auto row = static_cast<std::size_t>(first - distances_.begin()); row + 1 < end; ++row) {
    found.push_back(standing_in(row));
  }
  return found;
}

std::vector<double> LoadHistory::row_distances() const {
  std::vector<double> found;
  for (const std::size_t row : of_rows_) found.push_back(distances_[row]);
  return found;
}

Load LoadHistory::of_row(std::size_t row) const {
  const std::size_t place = of_rows_[row];
  if (!force_.empty()) return PrescribedForce{force_[place]};
  return at(distances_[place]);
}

int LoadHistory::direction_to(double distance) const {
  return constant_ ? 1 : direction_[place_before(distance).row];
}

double LoadHistory::position_at(double distance) const {
  if (constant_ || distance <= 0) return distance;
  const std::size_t row = place_before(distance).row;
  const bool has_turned = positions_[row] != distances_[row] || direction_[row] < 0;
  if (!has_turned) return distance;
  return positions_[row] + direction_[row] * (distance - distances_[row]);
}

void LoadHistory::take_scales(const RunRows& rows) {
  const auto n = static_cast<Index>(distances_.size());
  const RunRows::Reference& reference = rows.of_problem;
  point_contact_ = rows.point_contact;
  load_ = sizes(rows.normal_load, n, "normal_load", reference.normal_load);
  size_ = sizes(rows.half_width, n, "half_width", reference.half_width);
  bound_ = rows.friction ? sizes(rows.friction, n, "friction", reference.friction)
                         : sizes(rows.peak_traction, n, "peak_traction", reference.peak_traction);
  for (std::size_t row = 0; row < distances_.size(); ++row) {
    if (changes_contact() && !contact_in(row).carries()) lost_.push_back(distances_[row]);
  }
}

double LoadHistory::distance() const {
  return constant_ ? std::numeric_limits<double>::infinity() : distances_.back();
}

/// Finds the place of a distance, in a row that rolls, behind all that happens there.
LoadHistory::Place LoadHistory::place_of(double distance) const {
  const auto last = distances_.begin() + static_cast<std::ptrdiff_t>(last_row_) + 1;
  const auto next = std::upper_bound(distances_.begin() + 1, last, distance);
  return place_in(static_cast<std::size_t>(next - distances_.begin()) - 1, distance);
}

/// Finds the place at which a distance is reached, in a row that rolls; at 0 that of place_of().
LoadHistory::Place LoadHistory::place_before(double distance) const {
  if (distance <= 0) return place_of(distance);
  const auto last = distances_.begin() + static_cast<std::ptrdiff_t>(last_row_) + 1;
  const auto next = std::lower_bound(distances_.begin() + 1, last, distance);
  return place_in(static_cast<std::size_t>(next - distances_.begin()) - 1, distance);
}

/// Finds the place of a distance in a row. The distance is quadratic in time there.
LoadHistory::Place LoadHistory::place_in(std::size_t row, double distance) const {
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

/// \param value  of a column
template <class Value>
ContactScale LoadHistory::contact_by(const Value& value) const {
  const double bound = bound_.empty() ? 1 : value(bound_);
  if (load_.empty()) return {.half_width = size_.empty() ? 1 : value(size_), .bound = bound};
  const double load = value(load_);
  return point_contact_ ? hertz_point_scale(load, bound) : hertz_scale(load, bound);
}

ContactScale LoadHistory::contact_in(std::size_t row) const {
  return contact_by([&](const std::vector<double>& column) { return column[row]; });
}

ContactScale LoadHistory::contact_at(double distance) const {
  if (!changes_contact()) return {};
  if (distance <= 0) return contact_in(0);
  const Place at = place_before(distance);
  return contact_by([&](const std::vector<double>& column) { return between_rows(column, at); });
}

std::vector<ContactScale> LoadHistory::contacts() const {
  std::vector<ContactScale> found;
  for (std::size_t row = 0; row < distances_.size(); ++row) found.push_back(contact_in(row));
  return found;
}

std::vector<double> LoadHistory::ends_of_steps() const {
  std::vector<double> ends;
  std::ranges::set_union(stops_, lost_, std::back_inserter(ends));
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

Load LoadHistory::at(double distance) const {
  if (constant_) return *constant_;
  const Place there = place_of(distance);
  if (!force_.empty()) return PrescribedForce{between_rows(force_, there)};
  const Array3d& rate = shift_rate_[there.row];
  const double speed = between_rows(speed_, there);
  const double rate_there = rate[0] + there.since * (rate[1] + there.since * rate[2]);
  if (speed > 0) return PrescribedCreepage{rate_there / (direction_[there.row] * speed)};
  // Next to a standstill both are 0 but for rounding, and have the ratio of their slopes in time. A
  // shift without rolling is no creepage.
  constexpr double rounding = 1e-9;
  const Array3d terms = rate * Array3d(1, there.since, there.since * there.since);
  if (std::abs(rate_there) > rounding * terms.abs().maxCoeff()) return PrescribedCreepage{0};
  const double acceleration = (speed_[there.row + 1] - speed_[there.row]) / lengths_[there.row];
  return PrescribedCreepage{(rate[1] + 2 * there.since * rate[2]) /
                            (direction_[there.row] * acceleration)};
}

std::optional<double> LoadHistory::time_at(double distance) const {
  if (times_.empty()) return std::nullopt;
  const Place there = place_before(distance);
  return times_[there.row] + there.since;
}

Load LoadHistory::between(double from, double to) const {
  if (constant_) return *constant_;
  const Place end = place_before(to);
  if (!force_.empty()) return PrescribedForce{between_rows(force_, end)};
  const Place begin = place_of(from);
  const double rolled = direction_[end.row] * (to - from);
  if (begin.row == end.row) {
    return PrescribedCreepage{shift_within(begin.row, begin.since, end.since) / rolled};
  }
  double shift = shift_within(begin.row, begin.since, lengths_[begin.row]);
  for (std::size_t row = begin.row + 1; row < end.row; ++row) {
    shift += shift_within(row, 0, lengths_[row]);
  }
  shift += shift_within(end.row, 0, end.since);
  return PrescribedCreepage{shift / rolled};
}

}  // namespace microslip
