// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/active_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"
#include "partition.hpp"

namespace microslip {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Violations below this, relative to the largest bound or slip, are rounding.
constexpr double tolerance = 1e-12;

/// How often the block exchange may release one element before it counts as unsettled.
constexpr int release_limit = 3;

double prescribed_value(const Load& load) {
  return std::visit([](const auto& l) { return l.value; }, load);
}

double excess_over_bound(double traction, double bound) { return std::abs(traction) - bound; }

double wrong_slip(Zone zone, double slip) { return static_cast<double>(zone) * slip; }

Zone slip_zone(double traction) { return traction > 0 ? Zone::slip_positive : Zone::slip_negative; }

class ActiveSet {
 public:
  ActiveSet(const SlipEquations& equations, const Load& load)
      : equations_(equations),
        load_(load),
        bound_scale_(equations.bound.maxCoeff()),
        zones_(static_cast<std::size_t>(equations.bound.size()), Zone::adhesion) {}

  ContactState solve() {
    if (!exchange_blocks()) follow_path();
    return {response_.traction, response_.slip, zones_, response_.creepage, iterations_};
  }

 private:
  Index size() const { return equations_.bound.size(); }
  Zone& zone(Index i) { return zones_[static_cast<std::size_t>(i)]; }
  Zone zone(Index i) const { return zones_[static_cast<std::size_t>(i)]; }

  bool carries_load() const {
    return std::holds_alternative<PrescribedCreepage>(load_) ||
           std::find(zones_.begin(), zones_.end(), Zone::adhesion) != zones_.end();
  }

  Partition factorise() {
    ++iterations_;
    return {equations_, load_, zones_};
  }

  void respond(const Partition& partition) {
    response_ = partition.respond(equations_.bound, equations_.offset, prescribed_value(load_));
    slip_scale_ = std::max(std::abs(response_.creepage), response_.slip.lpNorm<Eigen::Infinity>());
    if (!response_.traction.allFinite() || !std::isfinite(slip_scale_)) {
      throw NotConverged("active set: singular system", iterations_,
                         std::numeric_limits<double>::infinity());
    }
  }

  bool above_bound(Index i) const {
    return zone(i) == Zone::adhesion &&
           excess_over_bound(response_.traction[i], equations_.bound[i]) > tolerance * bound_scale_;
  }

  bool slips_wrongly(Index i) const {
    return wrong_slip(zone(i), response_.slip[i]) > tolerance * slip_scale_;
  }

  /// Thesis 3.1.1; false if the partitions do not settle.
  bool exchange_blocks() {
    std::vector<int> releases(zones_.size(), 0);
    while (carries_load()) {
      respond(factorise());
      bool released = false;
      for (Index i = 0; i < size(); ++i) {
        if (!above_bound(i)) continue;
        if (++releases[static_cast<std::size_t>(i)] > release_limit) return false;
        zone(i) = slip_zone(response_.traction[i]);
        released = true;
      }
      if (released) continue;
      bool stuck = false;
      for (Index i = 0; i < size(); ++i) {
        if (!slips_wrongly(i)) continue;
        zone(i) = Zone::adhesion;
        stuck = true;
      }
      if (!stuck) return true;
    }
    return false;
  }

  struct Exchange {
    double height;
    Index element;
    Zone zone;
  };

  /// The first exchange on the way down from the bound g + height, on which traction and slip are
  /// those of g plus height times `rise`. The element of the last one cannot be the next.
  std::optional<Exchange> next_exchange(const Response& rise, Index last) const {
    std::optional<Exchange> next;
    const auto consider = [&](double violation, double slope, double scale, Index i, Zone to) {
      if (slope <= 0 || violation <= tolerance * scale) return;
      if (!next || violation > slope * next->height) next = {violation / slope, i, to};
    };
    for (Index i = 0; i < size(); ++i) {
      if (i == last) continue;
      if (zone(i) != Zone::adhesion) {
        consider(wrong_slip(zone(i), response_.slip[i]), -wrong_slip(zone(i), rise.slip[i]),
                 slip_scale_, i, Zone::adhesion);
        continue;
      }
      for (const Zone to : {Zone::slip_negative, Zone::slip_positive}) {
        const double s = static_cast<double>(to);
        consider(s * response_.traction[i] - equations_.bound[i], 1 - s * rise.traction[i],
                 bound_scale_, i, to);
      }
    }
    return next;
  }

  void follow_path() {
    std::fill(zones_.begin(), zones_.end(), Zone::adhesion);
    const VectorXd ones = VectorXd::Ones(size());
    const VectorXd zeros = VectorXd::Zero(size());
    const Index limit = iterations_ + 20 * size() + 100;
    for (Index last = -1; iterations_ < limit && carries_load();) {
      const Partition partition = factorise();
      respond(partition);
      const auto next = next_exchange(partition.respond(ones, zeros, 0), last);
      if (!next) break;
      zone(next->element) = next->zone;
      last = next->element;
    }
    const double violation = largest_violation();
    if (violation > 1e-9) {
      throw NotConverged("active set: no stick/slip partition found", iterations_, violation);
    }
  }

  double largest_violation() const {
    double worst = carries_load() ? 0 : std::numeric_limits<double>::infinity();
    for (Index i = 0; i < size(); ++i) {
      if (above_bound(i)) {
        worst = std::max(
            worst, excess_over_bound(response_.traction[i], equations_.bound[i]) / bound_scale_);
      }
      if (slips_wrongly(i)) {
        worst = std::max(worst, wrong_slip(zone(i), response_.slip[i]) / slip_scale_);
      }
    }
    return worst;
  }

  const SlipEquations& equations_;
  const Load& load_;
  double bound_scale_;
  std::vector<Zone> zones_;
  Response response_;
  double slip_scale_ = 0;
  int iterations_ = 0;
};

void require_below_full_sliding(const SlipEquations& equations, const Load& load) {
  const auto* force = std::get_if<PrescribedForce>(&load);
  if (force == nullptr) return;
  const double limit = equations.weights.dot(equations.bound);
  require(std::abs(force->value) < limit, "load.force", force->value,
          "an absolute value below full sliding, " + format_short(limit));
}

}  // namespace

ContactState solve_active_set(const SlipEquations& equations, const Load& load) {
  require_below_full_sliding(equations, load);
  return ActiveSet(equations, load).solve();
}

}  // namespace microslip
