// SPDX-License-Identifier: GPL-3.0-or-later
#include "stick_zones_search.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <utility>

#include "microslip/linalg/lu_factors.hpp"
#include "zoned_field.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Ends nearer to a row than this count as at the row; zones narrower than ten times as much are
/// dropped  [half-widths]
constexpr double pinned = 1e-11;

/// A zone that ends so near to an edge at which a bound may stick is taken to reach the edge
/// [half-widths]
constexpr double near_edge = 1e-5;

class Search {
 public:
  Search(std::shared_ptr<const ZonedContact> contact, const ZonesLoad& load,
         const AddedStrain& strain)
      : contact_(std::move(contact)),
        rows_(contact_->rows),
        load_(load),
        strain_(strain),
        least_(pinned * rows_.half_width()) {}

  bool run(std::vector<ZoneEnds>& zones) {
    zones_ = zones;
    if (!tidy()) return false;
    for (int round = 0; round < 3; ++round) {
      if (round > 0 && !tidy()) return false;
      if (!newton(false)) return false;
      if (!bracket_all()) return false;
      if (newton(true)) {
        zones = zones_;
        return true;
      }
    }
    return false;
  }

 private:
  double gap(const RowPlace& from, const RowPlace& to) const { return rows_.distance(from, to); }

  StickZones at(const std::vector<ZoneEnds>& zones) const {
    return zones_with(contact_, zones, strain_, 0);
  }

  RowPlace edge(bool leading) const { return {leading ? rows_.size() - 1 : 0, 0}; }
  RowPlace behind(std::size_t j) const { return j == 0 ? edge(false) : zones_[j - 1].end; }
  RowPlace ahead(std::size_t j) const {
    return j + 1 == zones_.size() ? edge(true) : zones_[j + 1].begin;
  }

  /// Writes a leading end by its distance from the row ahead, and a trailing one by the nearest
  /// row.
  RowPlace by_row_ahead(const RowPlace& place) const {
    std::size_t row = rows_.piece_of(place) + 1;
    if (row >= 1 && gap({row - 1, 0}, place) == 0) --row;
    return {row, -gap(place, {row, 0})};
  }

  RowPlace by_nearest_row(const RowPlace& place) const {
    const std::size_t row = rows_.piece_of(place);
    const double from = gap({row, 0}, place), to = gap(place, {row + 1, 0});
    return from <= to ? RowPlace{row, from} : RowPlace{row + 1, -to};
  }

  /// Drops zones without a width, and joins zones without a slip zone between them.
  bool tidy() {
    std::vector<ZoneEnds> kept;
    for (const ZoneEnds& zone : zones_) {
      if (gap(zone.begin, zone.end) < 10 * least_) continue;
      if (!kept.empty() && gap(kept.back().end, zone.begin) < 10 * least_) {
        kept.back().end = zone.end;
        continue;
      }
      kept.push_back(zone);
    }
    zones_ = kept;
    for (ZoneEnds& zone : zones_) {
      zone.begin = by_nearest_row(zone.begin);
      zone.end = by_row_ahead(zone.end);
    }
    return !zones_.empty();
  }

  /// The zone may reach the leading edge of a bound that does not fall to zero there as a line.
  bool may_reach_edge() const { return rows_.smooth() || rows_.value(rows_.size() - 1) > 0; }

  bool is_pinned(std::size_t j) const {
    const RowPlace& end = zones_[j].end;
    return -end.from < 2 * least_;
  }

  double root_at(std::size_t j, const RowPlace& end) const {
    std::vector<ZoneEnds> zones = zones_;
    zones[j].end = end;
    return at(zones).leading_root(j);
  }

  bool bracket_all() {
    for (std::size_t j = zones_.size(); j-- > 0;) {
      if (!bracket(j)) return false;
    }
    return true;
  }

  /// Finds the leading end of a zone with all other ends as they are.
  bool bracket(std::size_t j) {
    const RowPlace limit = ahead(j), begin = zones_[j].begin;
    const bool may_stick_to_edge = j + 1 == zones_.size() && may_reach_edge();
    if (may_stick_to_edge && gap(zones_[j].end, edge(true)) < near_edge * rows_.half_width()) {
      zones_[j].end = edge(true);
      return true;
    }
    if (rows_.smooth()) return bracket_nearby(j, may_stick_to_edge);
    std::size_t row = zones_[j].end.row;  // ahead of the end, or at it
    // A place just behind a row, but not behind the begin of the zone or beyond the next zone.
    const auto inside = [&](const RowPlace& place) {
      return gap(begin, place) > least_ && gap(place, limit) > least_;
    };
    const auto far = [&](std::size_t r) -> double {  // the longest distance from the row
      const double to_row = gap({r - 1, 0}, {r, 0});
      const double to_begin = gap(begin, {r, 0}) - least_;
      return std::min(to_row, to_begin);
    };
    for (int guard = 0; guard < static_cast<int>(2 * rows_.size()) + 4; ++guard) {
      const double most = far(row);
      double nearest = least_;
      const double beyond = -gap({row, 0}, limit);  // of the row beyond the next zone
      if (beyond > 0) nearest = beyond + least_;
      if (most <= nearest) {
        if (most <= least_) return false;
        if (row == 0) return false;
        --row;
        continue;
      }
      const double near_root = root_at(j, {row, -nearest});
      if (near_root > 0) {
        const bool may_go_on =
            beyond <= 0 && row + 1 < rows_.size() && !rows_.is_gap(row) && inside({row, least_});
        if (!may_go_on) {
          zones_[j].end =
              may_stick_to_edge && row + 1 == rows_.size() ? edge(true) : RowPlace{row, -nearest};
          return beyond <= 0;
        }
        // The root changes its sign at the row, or in a piece ahead.
        const RowPlace just_ahead{row, least_};
        if (root_at(j, by_row_ahead(just_ahead)) <= 0) {
          zones_[j].end = {row, -least_};
          return true;
        }
        ++row;
        continue;
      }
      const double far_root = root_at(j, {row, -most});
      if (far_root < 0) {
        if (gap(begin, {row, -most}) <= 2 * least_) return false;
        if (row <= 1) return false;
        --row;
        continue;
      }
      if (far_root == 0) {
        zones_[j].end = {row, -most};
        return true;
      }
      std::uintmax_t steps = 60;
      const auto f = [&](double log_distance) {
        return root_at(j, {row, -std::exp(log_distance)});
      };
      const auto found = boost::math::tools::toms748_solve(
          f, std::log(nearest), std::log(most), near_root, far_root,
          boost::math::tools::eps_tolerance<double>(24), steps);
      zones_[j].end = {row, -std::exp((found.first + found.second) / 2)};
      return true;
    }
    return false;
  }

  /// The same under a smooth bound, which has no rows: the change of sign that is nearest.
  bool bracket_nearby(std::size_t j, bool may_stick_to_edge) {
    const RowPlace begin = zones_[j].begin, limit = ahead(j);
    const std::size_t row = rows_.size() - 1;
    const double to_begin = gap(begin, {row, 0}), to_limit = gap(limit, {row, 0});
    const auto root = [&](double from_edge) { return root_at(j, {row, -from_edge}); };
    double at = gap(zones_[j].end, {row, 0}), value = root(at);
    double step = 0.01 * std::min(to_begin - at, std::max(at - to_limit, least_));
    for (;; step *= 2) {
      double next = value > 0 ? std::max(at - step, (at + to_limit) / 2)
                              : std::min(at + step, (at + to_begin) / 2);
      if (std::abs(next - at) < least_) {
        if (value < 0 || !may_stick_to_edge) return false;
        zones_[j].end = edge(true);
        return true;
      }
      const double there = root(next);
      if (!std::isfinite(there)) return false;
      if (value * there > 0) {
        at = next;
        value = there;
        continue;
      }
      std::uintmax_t steps = 60;
      const auto found = at < next ? boost::math::tools::toms748_solve(
                                         root, at, next, value, there,
                                         boost::math::tools::eps_tolerance<double>(24), steps)
                                   : boost::math::tools::toms748_solve(
                                         root, next, at, there, value,
                                         boost::math::tools::eps_tolerance<double>(24), steps);
      zones_[j].end = {row, -(found.first + found.second) / 2};
      return true;
    }
  }

  VectorXd residuals(const std::vector<ZoneEnds>& zones,
                     const std::vector<std::size_t>& free) const {
    const StickZones made = at(zones);
    VectorXd left(static_cast<Index>(zones.size() + free.size()));
    Index k = 0;
    std::vector<double> levels;
    double scale = load_.level.value_or(0);
    for (std::size_t j = 0; j < zones.size(); ++j) {
      levels.push_back(made.level(j));
      scale = std::max(scale, std::abs(levels.back()));
    }
    left[k++] =
        load_.force ? std::log(made.force() / *load_.force) : (levels[0] - *load_.level) / scale;
    for (std::size_t j = 1; j < zones.size(); ++j) left[k++] = (levels[j] - levels[0]) / scale;
    for (const std::size_t j : free) left[k++] = made.leading_root(j);
    return left;
  }

  /// Newton's method for the trailing ends, with leading ends as they are or together with them.
  bool newton(bool with_leading) {
    constexpr int most = 40;
    constexpr double difference = 1e-6;
    constexpr double enough = 1e-13, accepted = 1e-9;
    std::vector<std::size_t> free;
    for (std::size_t j = 0; with_leading && j < zones_.size(); ++j) {
      const bool at_edge = j + 1 == zones_.size() && gap(zones_[j].end, edge(true)) <= 0;
      if (!at_edge && !is_pinned(j)) free.push_back(j);
    }
    const auto count = static_cast<Index>(zones_.size());
    const auto n = static_cast<Index>(zones_.size() + free.size());
    VectorXd left = residuals(zones_, free);
    double best = HUGE_VAL;
    for (int i = 0; i < most; ++i) {
      if (!left.allFinite()) return false;
      const double size = left.lpNorm<Eigen::Infinity>();
      if (size < enough || (size < accepted && size > best / 2)) return true;
      best = std::min(best, size);
      MatrixXd slopes(n, n);
      const auto moved = [&](std::vector<ZoneEnds>& zones, Index k, double step) {
        if (k < count) {
          zones[static_cast<std::size_t>(k)].begin.from += step;
        } else {
          zones[free[static_cast<std::size_t>(k - count)]].end.from *= std::exp(step);
        }
      };
      VectorXd scales(n);
      for (Index k = 0; k < n; ++k) {
        scales[k] = 1;
        if (k < count) {
          const auto j = static_cast<std::size_t>(k);
          scales[k] =
              std::min(gap(behind(j), zones_[j].begin), gap(zones_[j].begin, zones_[j].end));
        }
        std::vector<ZoneEnds> beside = zones_;
        moved(beside, k, difference * scales[k]);
        slopes.col(k) = (residuals(beside, free) - left) / difference;
      }
      if (!slopes.allFinite()) return false;
      const VectorXd step = -least_squares(slopes, left);
      if (!step.allFinite()) return false;
      double part = 1;
      for (Index k = 0; k < n; ++k)
        part = std::min(part, (k < count ? 0.5 : 1.5) / std::abs(step[k]));
      bool taken = false;
      for (int halvings = 0; halvings < 12; ++halvings, part /= 2) {
        std::vector<ZoneEnds> next = zones_;
        for (Index k = 0; k < n; ++k) moved(next, k, part * step[k] * scales[k]);
        if (!ordered(next)) continue;
        const VectorXd there = residuals(next, free);
        if (!there.allFinite()) continue;
        if (there.norm() > (1 - part / 10) * left.norm() && size > accepted) continue;
        for (const std::size_t j : free) next[j].end = by_row_ahead(next[j].end);
        for (ZoneEnds& zone : next) zone.begin = by_nearest_row(zone.begin);
        zones_ = next;
        left = residuals(zones_, free);
        taken = true;
        break;
      }
      if (!taken) return size < accepted;
    }
    return left.lpNorm<Eigen::Infinity>() < accepted;
  }

  bool ordered(const std::vector<ZoneEnds>& zones) const {
    RowPlace last = edge(false);
    for (const ZoneEnds& zone : zones) {
      if (!(gap(last, zone.begin) > 0 && gap(zone.begin, zone.end) > 0)) return false;
      last = zone.end;
    }
    return gap(last, edge(true)) >= 0;
  }

  std::shared_ptr<const ZonedContact> contact_;
  const BoundRows& rows_;
  ZonesLoad load_;
  AddedStrain strain_;
  double least_;
  std::vector<ZoneEnds> zones_;
};

}  // namespace

StickZones zones_with(const std::shared_ptr<const ZonedContact>& contact,
                      const std::vector<ZoneEnds>& zones, const AddedStrain& strain, int refined) {
  StickZones made(contact, zones, refined);
  if (strain.series) made.add_strain(strain.series, strain.terms);
  return made;
}

bool move_ends(const std::shared_ptr<const ZonedContact>& contact, const ZonesLoad& load,
               const AddedStrain& strain, std::vector<ZoneEnds>& zones) {
  if (zones.empty()) return load.level.has_value();  // full sliding
  return Search(contact, load, strain).run(zones);
}

std::optional<StickZones> find_stick_zones(const std::shared_ptr<const ZonedContact>& contact,
                                           const ZonesLoad& load, std::vector<ZoneEnds> guess,
                                           const AddedStrain& strain) {
  constexpr int most = 5;
  for (int i = 0; i < most; ++i) {
    if (!move_ends(contact, load, strain, guess)) return std::nullopt;
    StickZones found = zones_with(contact, guess, strain, StickZones::for_places);
    const ZonedField field(found, guess.empty() ? *load.level : found.level(0));
    const std::optional<std::vector<ZoneEnds>> repaired = field.repaired();
    if (!repaired) return found;
    guess = *repaired;
  }
  return std::nullopt;
}

}  // namespace microslip
