// SPDX-License-Identifier: GPL-3.0-or-later
#include "unlike_zone_search.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/linalg/lu_factors.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

/// The width of a stick zone much narrower than the contact, between slip in both directions: an
/// elastic half-space turns the traction over where slip would change as steeply as the pressure.
double narrow_width(double x, double ratio) {
  return 4 * (1 - x * x) / (pi * std::abs(ratio) * std::max(std::abs(x), 1e-3));
}

/// Newton's method for the logarithms of the widths over the widest one, and for the level.
class ZoneSearch {
 public:
  ZoneSearch(const ScaledLoad& load, ZonePattern first, double level)
      : load_(load),
        scale_(std::max(1.0, std::abs(load.ratio))),
        pattern_(std::move(first)),
        level_(level) {
    widest_ = static_cast<std::size_t>(
        std::max_element(pattern_.widths.begin(), pattern_.widths.end()) - pattern_.widths.begin());
  }

  std::optional<UnlikeZones> run() {
    constexpr int most = 60;
    constexpr double longest = 1;
    constexpr double least_part = 1e-4;
    VectorXd at = start();
    VectorXd left = residuals(at);
    for (int i = 0; i < most && left.size() > 0; ++i) {
      const VectorXd step = -least_squares(slopes(at, left), left);
      if (!step.allFinite()) break;
      const double size = step.lpNorm<Eigen::Infinity>();
      double part = std::min(1.0, longest / size);
      VectorXd next;
      for (; part > least_part; part /= 2) {
        next = residuals(at + part * step);
        if (next.allFinite() && next.norm() < (1 - part / 10) * left.norm()) break;
      }
      if (part <= least_part) break;
      at += part * step;
      left = next;
      if (size < enough) break;
    }
    if (!(left.norm() < accepted)) return std::nullopt;
    return zones(at);
  }

 private:
  static constexpr double enough = 1e-12;
  static constexpr double accepted = 1e-8;

  VectorXd start() const {
    std::vector<double> at;
    for (std::size_t i = 0; i < pattern_.size(); ++i) {
      if (i != widest_) at.push_back(std::log(pattern_.widths[i] / pattern_.widths[widest_]));
    }
    if (load_.force) at.push_back(level_ / scale_);
    return Eigen::Map<const VectorXd>(at.data(), static_cast<Index>(at.size()));
  }

  UnlikeZones zones(const VectorXd& at) const {
    ZonePattern pattern = pattern_;
    double sum = 0;
    Index next = 0;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
      pattern.widths[i] = i == widest_ ? 1 : std::exp(at[next++]);
      sum += pattern.widths[i];
    }
    for (double& width : pattern.widths) width *= 2 / sum;
    return {load_.ratio, pattern, load_.force ? scale_ * at[next] : level_};
  }

  VectorXd residuals(const VectorXd& at) const { return zones(at).residuals(load_.force); }

  MatrixXd slopes(const VectorXd& at, const VectorXd& left) const {
    constexpr double difference = 1e-6;
    MatrixXd slopes(left.size(), at.size());
    for (Index k = 0; k < at.size(); ++k) {
      VectorXd beside = at;
      beside[k] += difference;
      slopes.col(k) = (residuals(beside) - left) / difference;
    }
    return slopes;
  }

  ScaledLoad load_;
  double scale_;
  ZonePattern pattern_;
  double level_;
  std::size_t widest_;
};

/// A part of a zone that breaks the conditions.
struct Violation {
  std::size_t zone;
  Zone becomes;
  double behind, ahead;  ///< what is left of the zone on its sides; 0 at an edge of the contact
};

/// Places of a zone that are dense at its ends.
std::vector<ZonePlace> places_in(const ZonePattern& pattern, std::size_t zone) {
  constexpr int halvings = 34;
  const double width = pattern.widths[zone];
  std::vector<ZonePlace> places;
  for (int k = halvings; k > 0; --k) {
    for (const double part : {std::ldexp(0.71, -k), std::ldexp(1.0, -k)}) {
      places.push_back({zone, part * width, (1 - part) * width});
    }
  }
  for (std::size_t i = places.size() - 1; i-- > 0;) {
    places.push_back({zone, places[i].ahead, places[i].behind});
  }
  return places;
}

std::optional<Zone> broken_at(const UnlikeZones& zones, const ZonePlace& place) {
  const double rounding = 3e-5 + 1e-8 * std::abs(zones.ratio());
  const Zone zone = zones.pattern().zones[place.zone];
  if (zone != Zone::adhesion) {
    const double scale = 1 + std::abs(zones.creepage());
    if (static_cast<double>(zone) * zones.slip(place) <= rounding * scale) return std::nullopt;
    return Zone::adhesion;
  }
  const double traction = zones.traction(place);
  if (std::abs(traction) <= (1 + rounding) * zones.bound(place)) return std::nullopt;
  return traction > 0 ? Zone::slip_positive : Zone::slip_negative;
}

/// The one nearest to the leading edge.
std::optional<Violation> violation_of(const UnlikeZones& zones) {
  constexpr double none = 1e-7;
  const ZonePattern& pattern = zones.pattern();
  for (std::size_t i = pattern.size(); i-- > 0;) {
    std::optional<Violation> found;
    const std::vector<ZonePlace> places = places_in(pattern, i);
    for (std::size_t k = places.size(); k-- > 0;) {
      const auto becomes = broken_at(zones, places[k]);
      if (found && (!becomes || *becomes != found->becomes)) break;
      if (!becomes) continue;
      if (!found) found = {i, *becomes, 0, k + 1 == places.size() ? 0 : places[k].ahead};
      found->behind = k == 0 ? 0 : places[k].behind;
    }
    if (!found) continue;
    const double width = pattern.widths[i];
    const bool at_edge =
        (i == 0 && found->behind == 0) || (i + 1 == pattern.size() && found->ahead == 0);
    if (at_edge && width - found->behind - found->ahead < none) continue;
    return found;
  }
  return std::nullopt;
}

/// The pattern with the part that breaks the conditions as a zone of its own. Within a zone it is
/// not next to its ends.
ZonePattern repaired(const ZonePattern& pattern, const Violation& violation) {
  constexpr double least = 0.05;  // of the part
  ZonePattern next;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const double width = pattern.widths[i];
    if (i != violation.zone) {
      next.zones.push_back(pattern.zones[i]);
      next.widths.push_back(width);
      continue;
    }
    const bool from_edge = i == 0 && violation.behind == 0;
    const bool to_edge = i + 1 == pattern.size() && violation.ahead == 0;
    const double narrowest = from_edge || to_edge ? 0 : 1e-3 * width;
    const double broken = std::max(width - violation.behind - violation.ahead, narrowest);
    const double behind = from_edge ? 0 : std::max(violation.behind, least * broken);
    const double ahead = to_edge ? 0 : std::max(violation.ahead, least * broken);
    const double inside = std::max(width - behind - ahead, least * broken);
    const auto add = [&](Zone zone, double part) {
      if (part <= 0) return;
      next.zones.push_back(zone);
      next.widths.push_back(part);
    };
    add(pattern.zones[i], behind);
    add(violation.becomes, inside);
    add(pattern.zones[i], ahead);
  }
  return next;
}

}  // namespace

ZonePattern pattern_of(const SteadySolution& solution, double half_width, double ratio) {
  ZonePattern found;
  const Index n = solution.x.size();
  const double element = (solution.x[1] - solution.x[0]) / half_width;
  const auto zone = [&](Index i) { return solution.zones[static_cast<std::size_t>(i)]; };
  double begin = -1;
  for (Index i = 0; i < n; ++i) {
    if (i + 1 < n && zone(i + 1) == zone(i)) continue;
    const double end = i + 1 < n ? (solution.x[i] + solution.x[i + 1]) / 2 / half_width : 1;
    if (!found.zones.empty() && zone(i) != Zone::adhesion && found.zones.back() != Zone::adhesion) {
      const double width = std::min(element, narrow_width(begin, ratio)) / 2;
      found.widths.back() -= width / 2;
      found.zones.push_back(Zone::adhesion);
      found.widths.push_back(width);
      begin += width / 2;
    }
    found.zones.push_back(zone(i));
    found.widths.push_back(end - begin);
    begin = end;
  }
  for (std::size_t i = 1; i + 1 < found.size(); ++i) {
    double& width = found.widths[i];
    if (!found.sticks(i) || width > 3 * element || found.zones[i - 1] == found.zones[i + 1]) {
      continue;
    }
    double middle = -1 + width / 2;
    for (std::size_t k = 0; k < i; ++k) middle += found.widths[k];
    const double rest = width - std::min(width, narrow_width(middle, ratio));
    width -= rest;
    found.widths[i - 1] += rest / 2;
    found.widths[i + 1] += rest / 2;
  }
  return found;
}

std::optional<UnlikeZones> find_zones(const ScaledLoad& load, ZonePattern pattern, double level) {
  constexpr int most = 8;
  for (int i = 0; i < most; ++i) {
    const auto found = ZoneSearch(load, pattern, level).run();
    if (!found) return std::nullopt;
    const auto violation = violation_of(*found);
    if (!violation) return found;
    pattern = repaired(found->pattern(), *violation);
    level = found->level();
  }
  return std::nullopt;
}

}  // namespace microslip
