// SPDX-License-Identifier: GPL-3.0-or-later
#include "stick_zones.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/support/gauss_points.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::ArrayXd;
using Eigen::Index;
using std::numbers::pi;

namespace {

/// Ratio of the ends of a panel, from the end of a zone: 12 Gauss points leave 2e-14.
constexpr double panel_growth = 3;

}  // namespace

ZonedContact::ZonedContact(const Kernel& of_kernel, const TractionBound& of_bound)
    : kernel(of_kernel),
      bound(of_bound),
      rows(of_bound),
      log_factor(of_kernel.log_factor()),
      clear(of_kernel.clear_distance()),
      longest(std::min(clear, rows.smooth() ? rows.half_width() / 40 : clear)) {}

/// A stick or slip zone between two boundaries.
struct StickZones::Interval {
  std::size_t begin, end;  ///< boundaries
  std::size_t zone;        ///< the stick zone, or the number of stick zones behind
  /// Lengths of the zones beyond the ends; infinite beyond an edge of the contact  [mm]
  double behind, ahead;
};

StickZones::StickZones(std::shared_ptr<const ZonedContact> contact, std::vector<ZoneEnds> zones,
                       int refined)
    : contact_(std::move(contact)), zones_(std::move(zones)), refined_(refined) {
  boundaries_.push_back({0, 0});
  for (const ZoneEnds& zone : zones_) {
    boundaries_.push_back(zone.begin);
    boundaries_.push_back(zone.end);
  }
  boundaries_.push_back({contact_->rows.size() - 1, 0});
  const auto n = static_cast<Index>(boundaries_.size());
  between_.resize(n, n);
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      between_(i, j) = contact_->rows.distance(boundaries_[static_cast<std::size_t>(i)],
                                               boundaries_[static_cast<std::size_t>(j)]);
    }
  }
  std::vector<Interval> slipping;
  const auto width = [&](std::size_t i) {
    return between_(static_cast<Index>(i), static_cast<Index>(i + 1));
  };
  const std::size_t last = boundaries_.size() - 2;
  for (std::size_t i = 0; i <= last; i += 2) {
    slipping.push_back(
        {i, i + 1, i / 2, i == 0 ? HUGE_VAL : width(i - 1), i == last ? HUGE_VAL : width(i + 1)});
  }
  slip_ = points_of(slipping, refined_);
  const auto points = static_cast<Index>(slip_.places.size());
  lean_.resize(points);
  inverse_.resize(points);
  for (Index k = 0; k < points; ++k) {
    const auto& [boundary, from] = slip_.places[static_cast<std::size_t>(k)];
    double lean = 1, product = 1;
    for (std::size_t j = 0; j < size(); ++j) {
      const auto b = static_cast<Index>(2 * j + 1);
      const auto at = static_cast<Index>(boundary);
      const double to_begin = std::abs(from - between_(at, b));
      const double to_end = std::abs(from - between_(at, b + 1));
      const double root = std::sqrt(to_begin) * std::sqrt(to_end);
      lean *= (to_begin + to_end) / 2 / root;
      product /= root;
    }
    const std::size_t ahead = size() - slip_.zones[static_cast<std::size_t>(k)];
    lean_[k] = lean;
    inverse_[k] = ahead % 2 == 0 ? product : -product;
  }
  count_work(static_cast<double>(points) * static_cast<double>(10 * size()));
}

double StickZones::distance(const BoundaryPlace& from, const BoundaryPlace& to) const {
  return between_(static_cast<Index>(from.boundary), static_cast<Index>(to.boundary)) +
         (to.from - from.from);
}

StickZones::Points StickZones::points_of(const std::vector<Interval>& intervals,
                                         int refined) const {
  Points points;
  std::vector<double> weights, bounds, rises;
  const BoundRows& rows = contact_->rows;
  const auto lay_half = [&](const Interval& interval, bool from_begin) {
    const std::size_t boundary = from_begin ? interval.begin : interval.end;
    const double sign = from_begin ? 1 : -1;
    const RowPlace& base = boundaries_[boundary];
    const double half =
        between_(static_cast<Index>(interval.begin), static_cast<Index>(interval.end)) / 2;
    if (!(half > 0)) return;
    const double beyond = from_begin ? interval.behind : interval.ahead;
    std::size_t row = rows.piece_of(base);  // of the panel
    if (!from_begin && rows.distance({row, 0}, base) == 0 && row > 0) --row;
    const double own_bound = rows.bound(base);
    const std::size_t own = row;
    const auto row_ahead = [&] {
      const RowPlace next{from_begin ? row + 1 : row, 0};
      return sign * rows.distance(base, next);
    };
    double begin = 0;
    const double first = std::min({half, beyond, row_ahead(), contact_->longest});
    const double length = first * std::pow(panel_growth, -refined);
    while (begin < half) {
      const double to_row = row_ahead();
      double end = std::min(
          begin == 0 ? length : begin + std::min((panel_growth - 1) * begin, contact_->longest),
          half);
      const bool at_row = end >= to_row;
      if (at_row) end = std::min(to_row, half);
      const auto take = [&](double d, double weight) {
        const double behind = rows.distance({row, 0}, base) + sign * d;
        const double ahead = rows.distance(base, {row + 1, 0}) - sign * d;
        const double g = rows.between(row, behind, ahead);
        points.places.push_back({boundary, sign * d});
        points.zones.push_back(interval.zone);
        weights.push_back(weight);
        bounds.push_back(g);
        rises.push_back(row == own && !rows.smooth() ? rows.slope(row) * sign * d : g - own_bound);
      };
      if (end > begin) {
        const double width = end - begin;
        if (begin == 0) {
          for_gauss_points<12>(0, 1,
                               [&](double r, double w) { take(width * r * r, 2 * width * r * w); });
        } else if (4 * width <= begin) {
          for_gauss_points<6>(begin, end, take);
        } else {
          for_gauss_points<12>(begin, end, take);
        }
      }
      begin = end;
      if (!at_row || begin >= half) continue;
      if (from_begin ? row + 2 >= rows.size() : row == 0) break;
      row += from_begin ? 1 : static_cast<std::size_t>(-1);
    }
  };
  for (const Interval& interval : intervals) {
    lay_half(interval, true);
    lay_half(interval, false);
  }
  const auto array = [](const std::vector<double>& of) -> ArrayXd {
    return Eigen::Map<const ArrayXd>(of.data(), static_cast<Index>(of.size()));
  };
  points.weights = array(weights);
  points.bounds = array(bounds);
  points.rises = array(rises);
  return points;
}

StickZones::Points StickZones::stick_points() const {
  std::vector<Interval> sticking;
  const std::size_t last = boundaries_.size() - 1;
  const auto width = [&](std::size_t i) {
    const double length = between_(static_cast<Index>(i), static_cast<Index>(i + 1));
    return length > 0 ? length : HUGE_VAL;
  };
  for (std::size_t j = 0; j < size(); ++j) {
    const std::size_t b = 2 * j + 1;
    sticking.push_back({b, b + 1, j, width(b - 1), b + 2 > last ? HUGE_VAL : width(b + 1)});
  }
  // No point is so near to an end that the slip points beside it do not resolve the distance.
  constexpr int nearest_point = 9;  // refinements from a panel to its first Gauss point
  return points_of(sticking, std::max(0, refined_ - nearest_point));
}

double StickZones::level(std::size_t zone) const {
  const auto b = static_cast<Index>(2 * zone + 1);
  double sum = 0;
  for (Index k = 0; k < lean_.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const auto& [boundary, from] = slip_.places[i];
    const auto at = static_cast<Index>(boundary);
    const double ends = std::abs(from - between_(at, b)) + std::abs(from - between_(at, b + 1));
    const double term = slip_.weights[k] * slip_.bounds[k] * lean_[k] * 2 / ends;
    sum += slip_.zones[i] > zone ? -term : term;
  }
  for (std::size_t i = 0; i < strain_places_.size(); ++i) {
    double product = strain_weights_[i] * strain_values_[i];
    for (std::size_t j = 0; j < size(); ++j) {
      if (j == zone) continue;
      const BoundaryPlace begin{2 * j + 1, 0}, end{2 * j + 2, 0};
      product *= -(distance(strain_places_[i], begin) + distance(strain_places_[i], end)) / 2;
    }
    sum += product;
  }
  return sum;
}

double StickZones::force() const {
  double sum = (slip_.weights * slip_.bounds * lean_).sum();
  for (std::size_t i = 0; i < strain_places_.size(); ++i) {
    double product = strain_weights_[i] * strain_values_[i];
    for (std::size_t j = 0; j < size(); ++j) {
      const BoundaryPlace begin{2 * j + 1, 0}, end{2 * j + 2, 0};
      product *= -(distance(strain_places_[i], begin) + distance(strain_places_[i], end)) / 2;
    }
    sum -= product;
  }
  return sum;
}

bool StickZones::slips_ahead(std::size_t zone) const {
  const auto end = static_cast<Index>(2 * zone + 2);
  return between_(end, end + 1) > 0;
}

double StickZones::leading_root(std::size_t zone) const {
  const auto end = static_cast<Index>(2 * zone + 2);
  const std::size_t boundary = 2 * zone + 2;
  const double half = between_(end, end + 1) / 2;
  const double bound_here = contact_->rows.bound(boundaries_[boundary]);
  const auto others = [&](const auto& take) {
    for (Index m = 1; m + 1 < between_.rows(); ++m) {
      if (m != end) take(between_(m, end));  // the signed distance of the end ahead of m
    }
  };
  double root_here = 1;  // W at the end
  others([&](double away) { root_here /= std::sqrt(std::abs(away)); });
  const double sign = (size() - 1 - zone) % 2 == 0 ? 1 : -1;
  double up = 0, down = 0;
  const auto add = [&](double term) { (term > 0 ? up : down) += std::abs(term); };
  for (Index k = 0; k < lean_.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const std::size_t at = slip_.places[i].boundary;
    const double from = slip_.places[i].from;
    if (at == boundary && from > 0) {
      double log_ratio = 0;
      others([&](double away) { log_ratio += std::log1p(from / away); });
      const double g = slip_.bounds[k];
      add(-slip_.weights[k] * root_here * (g * std::expm1(-log_ratio / 2) + slip_.rises[k]) /
          (from * std::sqrt(from)));
      continue;
    }
    const double away = -distance({boundary, 0}, slip_.places[i]);
    add(sign * slip_.weights[k] * slip_.bounds[k] * inverse_[k] / away);
  }
  add(2 * bound_here * root_here / std::sqrt(half));
  if (strain_) add(sign * from_strain(zone, {boundary, 0}));
  return (up - down) / (up + down);
}

double StickZones::position(const BoundaryPlace& place) const {
  return contact_->rows.position(boundaries_[place.boundary]) + place.from;
}

std::optional<std::size_t> StickZones::zone_of(double x) const {
  for (std::size_t j = 0; j < size(); ++j) {
    if (x >= position({2 * j + 1, 0}) && x <= position({2 * j + 2, 0})) return j;
  }
  return std::nullopt;
}

BoundaryPlace StickZones::place_of(double x) const {
  const RowPlace at = contact_->rows.place_of(x);
  BoundaryPlace nearest{0, HUGE_VAL};
  for (std::size_t i = 0; i < boundaries_.size(); ++i) {
    const double from = contact_->rows.distance(boundaries_[i], at);
    if (std::abs(from) < std::abs(nearest.from)) nearest = {i, from};
  }
  return nearest;
}

RowPlace StickZones::row_place(const BoundaryPlace& place) const {
  RowPlace at = boundaries_[place.boundary];
  at.from += place.from;
  return at;
}

double StickZones::bound(const BoundaryPlace& place) const {
  return contact_->rows.bound(row_place(place));
}

double StickZones::traction(std::size_t zone, const BoundaryPlace& place) const {
  double root = 1;
  for (std::size_t m = 1; m + 1 < boundaries_.size(); ++m) {
    root *= std::sqrt(std::abs(distance({m, 0}, place)));
  }
  if (root == 0) return bound(place);
  double sum = 0;
  const auto at = static_cast<Index>(place.boundary);
  for (Index k = 0; k < lean_.size(); ++k) {
    const auto& [boundary, from] = slip_.places[static_cast<std::size_t>(k)];
    const double away = (place.from - from) - between_(at, static_cast<Index>(boundary));
    sum += slip_.weights[k] * slip_.bounds[k] * inverse_[k] / away;
  }
  if (strain_) sum += from_strain(zone, place);
  const double sign = (size() - 1 - zone) % 2 == 0 ? 1 : -1;
  return -sign * root * sum / pi;
}

void StickZones::add_strain(std::shared_ptr<const ChebyshevSeries> strain, Index terms) {
  constexpr double digits = 18;
  constexpr double most = 2000;
  strain_ = std::move(strain);
  std::vector<double> positions;
  for (std::size_t j = 0; j < size(); ++j) {
    const auto b = static_cast<Index>(2 * j + 1);
    const double width = between_(b, b + 1);
    // The roots of the neighbours are singular at a distance of the slip zones between.
    const double behind = j > 0 ? between_(b - 1, b) : HUGE_VAL;
    const double ahead = j + 1 < size() ? between_(b + 1, b + 2) : HUGE_VAL;
    const double clear = std::acosh(1 + 2 * std::min(behind, ahead) / width);
    const auto count = terms + static_cast<Index>(std::min(most, digits / clear));
    const double sign = (size() - 1 - j) % 2 == 0 ? 1 : -1;
    for (Index n = 0; n < count; ++n) {
      const double angle = pi * (static_cast<double>(n) + 0.5) / static_cast<double>(count);
      const double behind = width * std::pow(std::sin(angle / 2), 2);
      const double ahead = width * std::pow(std::cos(angle / 2), 2);
      const BoundaryPlace place =
          behind < ahead ? BoundaryPlace{2 * j + 1, behind} : BoundaryPlace{2 * j + 2, -ahead};
      double weight = sign / static_cast<double>(count);
      for (std::size_t m = 1; m + 1 < boundaries_.size(); ++m) {
        if (m == 2 * j + 1 || m == 2 * j + 2) continue;
        weight /= std::sqrt(std::abs(distance({m, 0}, place)));
      }
      strain_places_.push_back(place);
      positions.push_back(position(place));
      strain_weights_.push_back(weight);
    }
  }
  const auto count = static_cast<Index>(positions.size());
  strain_values_.resize(positions.size());
  Eigen::VectorXd::Map(strain_values_.data(), count) =
      (*strain_)(Eigen::VectorXd::Map(positions.data(), count));
}

double StickZones::from_strain(std::size_t, const BoundaryPlace& place) const {
  constexpr double same = 1e-6;
  const double x = position(place);
  const double step = same * contact_->rows.half_width();
  const Eigen::VectorXd around = (*strain_)(Eigen::Vector3d(x - step, x, x + step));
  const double here = around[1];
  const double slope = (around[2] - around[0]) / (2 * step);
  double sum = 0;
  for (std::size_t i = 0; i < strain_places_.size(); ++i) {
    const double away = distance(strain_places_[i], place);
    const double quotient = std::abs(away) < step ? -slope : (strain_values_[i] - here) / away;
    sum -= strain_weights_[i] * quotient;
  }
  return sum;
}

}  // namespace microslip
