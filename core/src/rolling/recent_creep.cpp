// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/recent_creep.hpp"

#include <algorithm>

#include "microslip/support/archive.hpp"

namespace microslip {

namespace {

/// Points per element at most; closer ones would only cost memory.
constexpr int resolution = 1000;

}  // namespace

RecentCreep::RecentCreep(double element) : element_(element) {
  points_.reserve(resolution + 3);
  start();
}

void RecentCreep::start() { points_.assign(1, {0, 0}); }

void RecentCreep::include(double length, double creepage) {
  const bool close =
      points_.size() > 1 && points_[points_.size() - 2].distance < element_ / resolution;
  for (Point& point : points_) {
    point.distance += length;
    point.creep += length * creepage;
  }
  if (close) points_.pop_back();
  const auto nearer = std::ranges::find_if(
      points_, [&](double distance) { return distance < element_; }, &Point::distance);
  if (nearer - points_.begin() > 1) points_.erase(points_.begin(), nearer - 1);
  points_.push_back({0, 0});
}

double RecentCreep::mean_with(double length, double creepage) const {
  const double before = element_ - length;
  if (before <= 0 || points_.size() == 1) return creepage;
  const Point& farthest = points_.front();
  if (farthest.distance <= before) {
    return (farthest.creep + length * creepage) / (farthest.distance + length);
  }
  const auto nearer = std::ranges::find_if(
      points_, [&](double distance) { return distance < before; }, &Point::distance);
  const Point& from = *(nearer - 1);
  const double fraction = (before - nearer->distance) / (from.distance - nearer->distance);
  const double creep = nearer->creep + fraction * (from.creep - nearer->creep);
  return (creep + length * creepage) / element_;
}

void RecentCreep::archive(Archive& archive) {
  const auto most = static_cast<Eigen::Index>(points_.capacity());
  auto count = static_cast<Eigen::Index>(points_.size());
  archive.whole("creep_points", count, 1, most);
  points_.resize(static_cast<std::size_t>(count));
  for (Point& point : points_) {
    archive.number("creep_distance", point.distance);
    archive.number("creep", point.creep);
  }
}

}  // namespace microslip
