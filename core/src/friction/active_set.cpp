// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/active_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "adhesion_system.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"

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

/// What a partition answers to bound, offset, reference and load; linear in the four.
struct Response {
  VectorXd traction;
  VectorXd slip;  ///< zero in adhesion
  double creepage = 0;
  double residual = 0;
};

}  // namespace

/// The search for the partition of given conditions, and what is kept from one to the next.
class ContactSearch {
 public:
  ContactSearch(SquareMatrix response, VectorXd weights, const Solver& solver)
      : system_(std::move(response), std::move(weights), solver) {}

  const AdhesionSystem& system() const { return system_; }

  void run(const SlipConditions& conditions, const Load& load, ContactState& state) {
    conditions_ = &conditions;
    prescribed_ = prescribed_value(load);
    force_prescribed_ = std::holds_alternative<PrescribedForce>(load);
    bound_scale_ = conditions.bound.maxCoeff();
    zones_ = state.zones;
    iterations_ = 0;
    system_.prescribe_force(force_prescribed_);
    system_.soften(conditions.soft);
    if (!exchange_blocks()) follow_path();
    if (!(response_.residual <= system_.solver().tolerance)) {
      throw NotConverged("active set: the residual of the equations in adhesion is above " +
                             format_short(system_.solver().tolerance),
                         iterations_, response_.residual);
    }
    state.traction = response_.traction;
    state.slip = response_.slip;
    state.zones = zones_;
    state.creepage = response_.creepage;
    state.iterations = iterations_;
    state.residual = response_.residual;
  }

 private:
  Index size() const { return conditions_->bound.size(); }
  Zone& zone(Index i) { return zones_[static_cast<std::size_t>(i)]; }
  Zone zone(Index i) const { return zones_[static_cast<std::size_t>(i)]; }

  bool carries_load() const {
    return !force_prescribed_ ||
           std::find(zones_.begin(), zones_.end(), Zone::adhesion) != zones_.end();
  }

  /// The answer of the partition that the system follows. Increments p - reference are what is
  /// computed, so that small ones keep their digits.
  void answer(const SlipConditions& conditions, double prescribed, Response& response) {
    VectorXd& traction = response.traction;
    VectorXd& slip = response.slip;
    increment_.setZero(size());
    for (Index i = 0; i < size(); ++i) {
      if (zone(i) == Zone::adhesion) continue;
      increment_[i] = static_cast<double>(zone(i)) * conditions.bound[i] - conditions.reference[i];
    }
    traction = conditions.reference + increment_;
    slip = conditions.offset;
    if (const auto& soft = conditions_->soft) {
      slip[soft->element] += soft->compliance * traction[soft->element];
    }
    if (!increment_.isZero(0)) {
      system_.response().apply(increment_, product_);
      slip += product_;
    }
    const double other = force_prescribed_ ? system_.weights().dot(traction) : 0;
    minus_slip_ = -slip;
    system_.solve(minus_slip_, prescribed - other, unknowns_);
    traction += unknowns_.increment;
    slip += unknowns_.response;
    slip.array() += unknowns_.creepage;
    for (Index i = 0; i < size(); ++i) {
      if (zone(i) == Zone::adhesion) slip[i] = 0;
    }
    response.creepage = unknowns_.creepage;
    response.residual = unknowns_.residual;
  }

  void respond() {
    ++iterations_;
    system_.follow(zones_);
    answer(*conditions_, prescribed_, response_);
    slip_scale_ = std::max(std::abs(response_.creepage), response_.slip.lpNorm<Eigen::Infinity>());
    if (!response_.traction.allFinite() || !std::isfinite(slip_scale_)) {
      throw NotConverged("active set: singular system", iterations_,
                         std::numeric_limits<double>::infinity());
    }
  }

  bool above_bound(Index i) const {
    return zone(i) == Zone::adhesion &&
           excess_over_bound(response_.traction[i], conditions_->bound[i]) >
               tolerance * bound_scale_;
  }

  bool slips_wrongly(Index i) const {
    return conditions_->bound[i] > 0 &&
           wrong_slip(zone(i), response_.slip[i]) > tolerance * slip_scale_;
  }

  /// Thesis 3.1.1; false if the partitions do not settle.
  bool exchange_blocks() {
    releases_.assign(zones_.size(), 0);
    while (carries_load()) {
      respond();
      bool released = false;
      for (Index i = 0; i < size(); ++i) {
        if (!above_bound(i)) continue;
        if (++releases_[static_cast<std::size_t>(i)] > release_limit) return false;
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
      if (i == last || conditions_->bound[i] <= 0) continue;
      if (zone(i) != Zone::adhesion) {
        consider(wrong_slip(zone(i), response_.slip[i]), -wrong_slip(zone(i), rise.slip[i]),
                 slip_scale_, i, Zone::adhesion);
        continue;
      }
      for (const Zone to : {Zone::slip_negative, Zone::slip_positive}) {
        const double s = static_cast<double>(to);
        consider(s * response_.traction[i] - conditions_->bound[i], 1 - s * rise.traction[i],
                 bound_scale_, i, to);
      }
    }
    return next;
  }

  void follow_path() {
    SlipConditions higher{.bound = VectorXd::Ones(size()),
                          .offset = VectorXd::Zero(size()),
                          .reference = VectorXd::Zero(size())};
    for (Index i = 0; i < size(); ++i) {
      if (conditions_->bound[i] > 0) {
        zone(i) = Zone::adhesion;
      } else {
        if (zone(i) == Zone::adhesion) zone(i) = Zone::slip_positive;
        higher.bound[i] = 0;
      }
    }
    const Index limit = iterations_ + 20 * size() + 100;
    for (Index last = -1; iterations_ < limit && carries_load();) {
      respond();
      answer(higher, 0, rise_);
      const auto next = next_exchange(rise_, last);
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
            worst, excess_over_bound(response_.traction[i], conditions_->bound[i]) / bound_scale_);
      }
      if (slips_wrongly(i)) {
        worst = std::max(worst, wrong_slip(zone(i), response_.slip[i]) / slip_scale_);
      }
    }
    return worst;
  }

  AdhesionSystem system_;
  const SlipConditions* conditions_ = nullptr;
  double prescribed_ = 0;
  bool force_prescribed_ = false;
  double bound_scale_ = 0;
  double slip_scale_ = 0;
  std::vector<Zone> zones_;
  std::vector<int> releases_;
  Response response_;
  Response rise_;  ///< of the path
  AdhesionSystem::Unknowns unknowns_;
  VectorXd increment_, product_, minus_slip_;
  int iterations_ = 0;
};

namespace {

void require_below_full_sliding(const Load& load, double full_sliding) {
  const auto* force = std::get_if<PrescribedForce>(&load);
  if (force == nullptr) return;
  require(std::abs(force->value) < full_sliding, "load.force", force->value,
          "an absolute value below full sliding, " + format_short(full_sliding));
}

}  // namespace

Load over(const Load& load, double length) {
  const auto* creepage = std::get_if<PrescribedCreepage>(&load);
  return creepage == nullptr ? load : PrescribedCreepage{creepage->value * length};
}

ActiveSet::ActiveSet(SquareMatrix response, VectorXd weights, const Solver& solver)
    : search_(std::make_unique<ContactSearch>(std::move(response), std::move(weights), solver)) {}

ActiveSet::~ActiveSet() = default;
ActiveSet::ActiveSet(ActiveSet&&) noexcept = default;
ActiveSet& ActiveSet::operator=(ActiveSet&&) noexcept = default;

void ActiveSet::solve(const SlipConditions& conditions, const Load& load, ContactState& state) {
  require_below_full_sliding(load, search_->system().weights().dot(conditions.bound));
  search_->run(conditions, load, state);
}

ContactState ActiveSet::solve(const SlipConditions& conditions, const Load& load) {
  const auto size = static_cast<std::size_t>(conditions.bound.size());
  return solve(conditions, load, std::vector<Zone>(size, Zone::adhesion));
}

ContactState ActiveSet::solve(const SlipConditions& conditions, const Load& load,
                              const std::vector<Zone>& first) {
  ContactState state{.traction = {}, .slip = {}, .zones = first};
  solve(conditions, load, state);
  return state;
}

const SquareMatrix& ActiveSet::response() const { return search_->system().response(); }

}  // namespace microslip
