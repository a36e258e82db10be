// SPDX-License-Identifier: GPL-3.0-or-later
#include "unlike_zones.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/support/gauss_points.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

/// The least distance to an end of a zone, over the zone's width: at the end itself there would be
/// 0/0.
constexpr double nearest_to_end = 1e-30;

/// A Gauss point counts as at a place if their distance is below this fraction of the place's
/// distance from the zone's end.
constexpr double same = 1e-6;

/// Panels are halved so often towards an edge of the contact, where the density vanishes as a
/// square times a logarithm.
constexpr int halvings_at_edge = 8;

/// Returns how often panels are halved towards a stick zone, whose far end makes the density nearly
/// singular.
/// \param ratio  of the stick zone's width to the slip zone's
int halvings_for(double ratio) {
  constexpr int most = 60;
  const double halvings = std::ceil(std::log2(4 / std::sqrt(std::min(1.0, ratio))));
  return static_cast<int>(std::min<double>(most, halvings));
}

}  // namespace

void graded_angles(int from, int to, unsigned points, ArrayXd& angles, ArrayXd& weights) {
  std::vector<double> ends{0}, at, by;
  for (int k = from; k >= 0; --k) ends.push_back(std::ldexp(pi / 2, -k));
  for (int k = 1; k <= to; ++k) ends.push_back(pi - std::ldexp(pi / 2, -k));
  ends.push_back(pi);
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const auto add = [&](double angle, double weight) {
      at.push_back(angle);
      by.push_back(weight);
    };
    points == 10 ? for_gauss_points<10>(ends[k], ends[k + 1], add)
                 : for_gauss_points<15>(ends[k], ends[k + 1], add);
  }
  angles = Eigen::Map<const ArrayXd>(at.data(), static_cast<Index>(at.size()));
  weights = Eigen::Map<const ArrayXd>(by.data(), static_cast<Index>(by.size()));
}

UnlikeZones::UnlikeZones(double ratio, ZonePattern pattern, double level)
    : ratio_(ratio), pattern_(std::move(pattern)), level_(level) {
  for (std::size_t i = 0; i < pattern_.size(); ++i) {
    if (!pattern_.sticks(i)) sources_.push_back(source_of(i));
  }
}

double UnlikeZones::creepage() const { return level_ + 2 / pi * ratio_; }

/// The root grows with this power of the distance. A trailing edge that sticks has no slip zone
/// behind it, and tractions are singular there.
Index UnlikeZones::moments() const {
  Index sticking = 0;
  for (const Zone zone : pattern_.zones) sticking += zone == Zone::adhesion ? 1 : 0;
  return sticking - (is_singular() ? 1 : 0);
}

/// The width of zones from this one on, up to another.
double UnlikeZones::between(std::size_t from, std::size_t to) const {
  double sum = 0;
  for (std::size_t i = from; i < to; ++i) sum += pattern_.widths[i];
  return sum;
}

/// Returns the distance from a boundary: behind the zone of that number, or the leading edge.
double UnlikeZones::distance(const ZonePlace& place, std::size_t boundary) const {
  return boundary <= place.zone ? place.behind + between(boundary, place.zone)
                                : place.ahead + between(place.zone + 1, boundary);
}

/// Whether there is a stick zone on either side of a boundary.
bool UnlikeZones::is_stick_end(std::size_t boundary) const {
  return (boundary > 0 && pattern_.sticks(boundary - 1)) ||
         (boundary < pattern_.size() && pattern_.sticks(boundary));
}

double UnlikeZones::sign_of_root(std::size_t zone) const {
  double sign = 1;
  for (std::size_t i = zone + 1; i < pattern_.size(); ++i) sign *= pattern_.sticks(i) ? -1 : 1;
  return sign;
}

/// The root of the product of distances from the stick ends.
double UnlikeZones::root(const ZonePlace& place, bool own_ends) const {
  double root = sign_of_root(place.zone);
  for (std::size_t b = 0; b <= pattern_.size(); ++b) {
    const bool own = b == place.zone || b == place.zone + 1;
    if (!is_stick_end(b) || (own && !own_ends)) continue;
    const double factor = std::sqrt(distance(place, b));
    root = is_singular() && b == 0 ? root / factor : root * factor;
  }
  return root;
}

double UnlikeZones::logarithm(const ZonePlace& place) const {
  return std::log(distance(place, 0) / distance(place, pattern_.size()));
}

/// Returns the density of the Cauchy integral, with the measure of the angle.
double UnlikeZones::density(const ZonePlace& place) const {
  const double sign = static_cast<double>(pattern_.zones[place.zone]);
  double value = bound(place) * (sign + ratio_ / pi * logarithm(place)) / root(place, false);
  if (!is_stick_end(place.zone)) value *= std::sqrt(place.behind);
  if (!is_stick_end(place.zone + 1)) value *= std::sqrt(place.ahead);
  return value;
}

/// Returns the derivative of density() by the place, within the zone.
double UnlikeZones::density_slope(const ZonePlace& place) const {
  const double beside = 1e-5 * std::min(place.behind, place.ahead);
  const double next = density({place.zone, place.behind + beside, place.ahead - beside});
  const double last = density({place.zone, place.behind - beside, place.ahead + beside});
  return (next - last) / (2 * beside);
}

UnlikeZones::Source UnlikeZones::source_of(std::size_t zone) const {
  const double width = pattern_.widths[zone];
  const int from = zone == 0 ? halvings_at_edge : halvings_for(pattern_.widths[zone - 1] / width);
  const int to = zone + 1 == pattern_.size() ? halvings_at_edge
                                             : halvings_for(pattern_.widths[zone + 1] / width);
  ArrayXd angles;
  Source source;
  source.zone = zone;
  source.half = width / 2;
  graded_angles(from, to, 15, angles, source.weights);
  source.behind = width * (angles / 2).sin().square();
  source.ahead = width * ((pi - angles) / 2).sin().square();
  source.x.resize(angles.size());
  source.density.resize(angles.size());
  for (Index i = 0; i < angles.size(); ++i) {
    const ZonePlace place{zone, source.behind[i], source.ahead[i]};
    source.x[i] = x_of(place);
    source.density[i] = density(place);
  }
  if (is_stick_end(zone)) source.at_begin = density({zone, 0, width});
  if (is_stick_end(zone + 1)) source.at_end = density({zone, width, 0});
  count_work(static_cast<double>(angles.size() * 40));
  return source;
}

/// Adds the integral of the density over the distance to a place; beside the zone less the integral
/// of the nearer end's density, which is known, and at the end itself the finite part.
void UnlikeZones::add_cauchy(const Source& source, const ZonePlace& place, Sum& sum) const {
  const auto beside = [&](double side, const ArrayXd& from_end, double at_end, double away) {
    for (Index i = 0; i < from_end.size(); ++i) {
      sum.add(side * source.weights[i] * (source.density[i] - at_end) / (away + from_end[i]));
    }
    if (away > 0) sum.add(side * at_end * pi / std::sqrt(away * (away + 2 * source.half)));
  };
  if (source.zone > place.zone) {
    beside(1, source.behind, source.at_begin, distance(place, source.zone));
  } else if (source.zone < place.zone) {
    beside(-1, source.ahead, source.at_end, distance(place, source.zone + 1));
  } else {
    const double here = density(place);
    for (Index i = 0; i < source.behind.size(); ++i) {
      const double away = place.behind < place.ahead ? source.behind[i] - place.behind
                                                     : place.ahead - source.ahead[i];
      const bool is_here = std::abs(away) < same * std::min(place.behind, place.ahead);
      sum.add(source.weights[i] *
              (is_here ? density_slope(place) : (source.density[i] - here) / away));
    }
  }
}

/// The transform of the densities, over pi.
UnlikeZones::Sum UnlikeZones::cauchy(const ZonePlace& place) const {
  Sum sum;
  for (const Source& source : sources_) add_cauchy(source, place, sum);
  sum.up /= pi;
  sum.down /= pi;
  if (moments() == 0) sum.add(-level_);
  return sum;
}

double UnlikeZones::moment(Index power) const {
  double sum = 0;
  for (const Source& source : sources_) {
    sum += (source.weights * source.density * source.x.pow(static_cast<double>(power))).sum();
  }
  return sum;
}

double UnlikeZones::force() const {
  double centre = 0;
  for (std::size_t b = 0; b <= pattern_.size(); ++b) {
    if (!is_stick_end(b)) continue;
    const double x = b == 0 ? -1 : x_of({b - 1, pattern_.widths[b - 1], 0});
    centre += is_singular() && b == 0 ? -x : x;
  }
  return moment(moments()) - pi * level_ * centre / 2;
}

/// Tells by zero whether the traction leaves the bound with the power 3/2: the value is the
/// logarithm of the ratio of two terms that have to cancel.
double UnlikeZones::leading_condition(std::size_t boundary) const {
  const Sum sum = cauchy({boundary - 1, pattern_.widths[boundary - 1], 0});
  return std::log(sum.up / sum.down);
}

VectorXd UnlikeZones::residuals(std::optional<double> prescribed) const {
  std::vector<double> left;
  const Index count = moments();
  double terms = 0;
  for (const Source& source : sources_) terms += (source.weights * source.density.abs()).sum();
  for (Index k = 0; k < count; ++k) {
    const double by_level = k + 1 == count ? pi * level_ : 0;
    left.push_back((moment(k) - by_level) / (terms + std::abs(by_level)));
  }
  if (prescribed) {
    const double all = terms + pi * std::abs(level_) + std::abs(*prescribed);
    left.push_back((force() - *prescribed) / (terms > 0 ? all : 1));
  }
  for (std::size_t b = 1; b < pattern_.size(); ++b) {
    if (pattern_.sticks(b - 1)) left.push_back(leading_condition(b));
  }
  return Eigen::Map<const VectorXd>(left.data(), static_cast<Index>(left.size()));
}

ZonePlace UnlikeZones::place_of(double x) const {
  const std::size_t last = pattern_.size() - 1;
  double begin = 0;
  std::size_t zone = 0;
  while (zone < last && begin + pattern_.widths[zone] <= x + 1) begin += pattern_.widths[zone++];
  const double to_end = 1 - x - between(zone + 1, last + 1);
  const double width = pattern_.widths[zone];
  const bool is_behind = x + 1 - begin < width / 2;
  const double near = std::clamp(is_behind ? x + 1 - begin : to_end, nearest_to_end * width, width);
  return {zone, is_behind ? near : width - near, is_behind ? width - near : near};
}

double UnlikeZones::x_of(const ZonePlace& place) const {
  const double behind = distance(place, 0);
  const double ahead = distance(place, pattern_.size());
  return behind < ahead ? behind - 1 : 1 - ahead;
}

double UnlikeZones::bound(const ZonePlace& place) const {
  return std::sqrt(distance(place, 0) * distance(place, pattern_.size()));
}

/// Less what the pressure would cause without slip, for which the strain is known.
double UnlikeZones::traction(const ZonePlace& place) const {
  const double g = bound(place);
  if (!pattern_.sticks(place.zone)) return static_cast<double>(pattern_.zones[place.zone]) * g;
  return root(place, true) * cauchy(place).total() - ratio_ / pi * g * logarithm(place);
}

double UnlikeZones::slip(const ZonePlace& place) const {
  if (pattern_.sticks(place.zone)) return 0;
  return -root(place, true) * cauchy(place).total();
}

}  // namespace microslip
