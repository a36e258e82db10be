// SPDX-License-Identifier: GPL-3.0-or-later
#include "zoned_field.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Violations below this part of the bound, and of the creepage, are rounding.
constexpr double rounding_of_field = 1e-8;

double regular_decay(const Kernel& kernel, double z) {
  return visit_half_space([&](const auto& k) { return k.regular_decay(z); }, kernel);
}

double regular_displacement(const Kernel& kernel, double z) {
  return visit_half_space([&](const auto& k) { return k.regular_displacement(z); }, kernel);
}

}  // namespace

ZonedField::ZonedField(StickZones zones, double level)
    : zones_(std::move(zones)), level_(level), stick_(zones_.stick_points()) {
  const auto n = static_cast<Index>(stick_.places.size());
  traction_.resize(n);
  for (Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    traction_[i] = zones_.traction(stick_.zones[k], stick_.places[k]);
  }
  count_work(4 * static_cast<double>(n) * static_cast<double>(zones_.slip_points().weights.size()));
  const ZonedContact& contact = zones_.contact();
  if (contact.rows.smooth()) {
    sliding_.emplace(PlaneKernel(contact.kernel.material(), 1), contact.bound);
  }
}

double ZonedField::creepage() const { return zones_.contact().log_factor * level_; }

double ZonedField::traction(double x) const {
  const BoundaryPlace place = zones_.place_of(x);
  const auto zone = zones_.zone_of(x);
  return zone ? zones_.traction(*zone, place) : zones_.bound(place);
}

double ZonedField::slip_over_k(const BoundaryPlace& place) const {
  const ZonedContact& contact = zones_.contact();
  const double x = zones_.position(place);
  double slip = level_ - zones_.added_strain(x);
  if (sliding_) {
    slip -= sliding_->strain(x) / contact.log_factor;
  } else {
    RowPlace at = zones_.row_place(place);
    slip -= contact.rows.sliding_transform(at);
  }
  for (Index i = 0; i < traction_.size(); ++i) {
    const double away = zones_.distance(stick_.places[static_cast<std::size_t>(i)], place);
    slip += stick_.weights[i] * (stick_.bounds[i] - traction_[i]) / away;
  }
  return slip;
}

double ZonedField::slip(double x) const {
  if (zones_.zone_of(x)) return 0;
  return zones_.contact().log_factor * slip_over_k(zones_.place_of(x));
}

double ZonedField::regular_strain(double x) const {
  const Kernel& kernel = zones_.contact().kernel;
  double sum = 0;
  for (Index i = 0; i < traction_.size(); ++i) {
    const double away = x - zones_.position(stick_.places[static_cast<std::size_t>(i)]);
    sum += stick_.weights[i] * traction_[i] * regular_decay(kernel, away);
  }
  const StickZones::Points& slip = zones_.slip_points();
  for (Index i = 0; i < slip.weights.size(); ++i) {
    const double away = x - zones_.position(slip.places[static_cast<std::size_t>(i)]);
    sum += slip.weights[i] * slip.bounds[i] * regular_decay(kernel, away);
  }
  count_work(kernel_work * static_cast<double>(traction_.size() + slip.weights.size()));
  return sum / zones_.contact().log_factor;
}

namespace {

/// A run of points that break a condition.
struct Broken {
  std::size_t first, last;
};

/// The runs of broken points, in ascending order of their places.
/// \param order  indices of the points of one zone, ascending by place
template <class IsBroken>
std::vector<Broken> runs_of(const std::vector<std::size_t>& order, const IsBroken& is_broken) {
  std::vector<Broken> runs;
  bool open = false;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (!is_broken(order[i])) {
      open = false;
      continue;
    }
    if (!open) runs.push_back({i, i});
    runs.back().last = i;
    open = true;
  }
  return runs;
}

}  // namespace

std::optional<std::vector<ZoneEnds>> ZonedField::repaired() const {
  const StickZones::Points& slip = zones_.slip_points();
  const BoundRows& rows = zones_.contact().rows;
  const double least = 1e-10 * rows.half_width();
  const auto largest = [](const ArrayXd& of) { return of.size() > 0 ? of.maxCoeff() : 0; };
  const double peak = std::max(largest(stick_.bounds), largest(slip.bounds));
  const auto points_of = [](const StickZones& zones, const StickZones::Points& points,
                            std::size_t zone) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.places.size(); ++i) {
      if (points.zones[i] == zone) order.push_back(i);
    }
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
      return zones.distance(points.places[a], points.places[b]) > 0;
    });
    return order;
  };
  std::vector<ZoneEnds> next;
  bool changed = false;
  // Places at which a broken run begins and ends: half way to its neighbours.
  const auto ends_of = [&](const StickZones::Points& points, const std::vector<std::size_t>& order,
                           const Broken& run) {
    const auto row_place = [&](std::size_t i) { return zones_.row_place(points.places[order[i]]); };
    return std::pair(row_place(run.first), row_place(run.last));
  };
  for (std::size_t j = 0; j <= zones_.size(); ++j) {
    // The slip zone behind zone j; its parts that slip wrongly stick.
    const std::vector<std::size_t> order = points_of(zones_, slip, j);
    const auto slips_wrongly = [&](std::size_t i) {
      const auto k = static_cast<Index>(i);
      if (slip.bounds[k] <= 1e-12 * peak) return false;
      const double s = slip_over_k(slip.places[i]);
      return s < -rounding_of_field * (level_ + peak * 1e-4);
    };
    for (const Broken& run : runs_of(order, slips_wrongly)) {
      if (run.first == run.last && order.size() > 1) {
        // a single point may be rounding next to a row
        const double width = slip.weights[static_cast<Index>(order[run.first])];
        if (width < least) continue;
      }
      auto [begin, end] = ends_of(slip, order, run);
      if (rows.distance(begin, end) < least) continue;
      next.push_back({begin, end});
      changed = true;
    }
    if (j == zones_.size()) break;
    const std::vector<std::size_t> inside = points_of(zones_, stick_, j);
    const auto above = [&](std::size_t i) {
      const auto k = static_cast<Index>(i);
      return traction_[k] > stick_.bounds[k] + rounding_of_field * peak;
    };
    ZoneEnds rest = zones_.zones()[j];
    for (const Broken& run : runs_of(inside, above)) {
      auto [begin, end] = ends_of(stick_, inside, run);
      if (rows.distance(begin, end) < least) continue;
      changed = true;
      if (run.first > 0) next.push_back({rest.begin, begin});
      rest.begin = end;
    }
    next.push_back(rest);
  }
  if (!changed) return std::nullopt;
  return next;
}

ZonedField::Sums ZonedField::sums() const {
  Sums sums;
  const StickZones::Points& slip = zones_.slip_points();
  for (Index i = 0; i < traction_.size(); ++i) {
    sums.excess += stick_.weights[i] * std::max(0.0, traction_[i] - stick_.bounds[i]);
  }
  for (Index i = 0; i < slip.weights.size(); ++i) {
    const double power = slip.weights[i] * slip.bounds[i] * zones_.contact().log_factor *
                         slip_over_k(slip.places[static_cast<std::size_t>(i)]);
    sums.backward += std::max(0.0, -power);
    sums.dissipated += power;
  }
  return sums;
}

VectorXd ZonedField::displacement(const VectorXd& x) const {
  const ZonedContact& contact = zones_.contact();
  const double k = contact.log_factor;
  const auto at = [&](const BoundaryPlace& place) {
    const double position = zones_.position(place);
    double u = 0;
    if (sliding_) {
      u = sliding_->displacement(position);  // with L0 = 1 mm
    } else {
      u = -k * contact.rows.sliding_potential(position);
    }
    for (Index i = 0; i < traction_.size(); ++i) {
      const double away =
          std::abs(zones_.distance(stick_.places[static_cast<std::size_t>(i)], place));
      if (away > 0) {
        u += k * stick_.weights[i] * (stick_.bounds[i] - traction_[i]) * std::log(away);
      }
      u += stick_.weights[i] * traction_[i] *
           regular_displacement(
               contact.kernel,
               position - zones_.position(stick_.places[static_cast<std::size_t>(i)]));
    }
    const StickZones::Points& slip = zones_.slip_points();
    for (Index i = 0; i < slip.weights.size(); ++i) {
      u +=
          slip.weights[i] * slip.bounds[i] *
          regular_displacement(
              contact.kernel, position - zones_.position(slip.places[static_cast<std::size_t>(i)]));
    }
    return u;
  };
  VectorXd u(x.size());
  std::vector<double> at_begin(zones_.size());
  for (std::size_t j = 0; j < zones_.size(); ++j) at_begin[j] = at({2 * j + 1, 0});
  for (Index i = 0; i < x.size(); ++i) {
    const auto zone = zones_.zone_of(x[i]);
    u[i] = zone ? at_begin[*zone] - creepage() * (x[i] - zones_.position({2 * *zone + 1, 0}))
                : at(zones_.place_of(x[i]));
  }
  return u;
}

}  // namespace microslip
