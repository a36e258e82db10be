// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/active_set.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "adhesion_system.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Violations below this limit, relative to the largest bound or slip, are rounding errors.
constexpr double tolerance = 1e-12;

/// Extra relief, relative to the violation, so that elements do not all reach their bound at the
/// same place of the path.
constexpr double margin = 0.1;

/// A path that takes more exchanges than this starts again. The limit after block exchanges is
/// lower, because these lead either close to the solution or far away from it.
constexpr int most_exchanges_from_blocks = 20;
constexpr int most_exchanges_from_given = 60;

/// Largest violation at the end of a path, relative to the largest bound or slip.
constexpr double acceptable_violation = 1e-9;

double excess_over_bound(double traction, double bound) { return std::abs(traction) - bound; }

double wrong_slip(Zone zone, double slip) { return static_cast<double>(zone) * slip; }

Zone slip_zone(double traction) { return traction > 0 ? Zone::slip_positive : Zone::slip_negative; }

}  // namespace

/// Searches for the partition that meets given conditions. Factors are kept from one search to the
/// next.
class ContactSearch {
 public:
  ContactSearch(LinearOperator response, VectorXd weights, const Solver& solver)
      : system_(std::move(response), std::move(weights), solver) {}

  const AdhesionSystem& system() const { return system_; }
  double condition() { return system_.condition(); }
  void archive(Archive& archive) { system_.archive(archive); }

  void run(const SlipConditions& conditions, const Prescribed& load, ContactState& state) {
    enough_ = 1e-5;
    begin(conditions, load, state.zones);
    if (!exchange_blocks() && !follow_path_nearby(state.zones) && !follow_path_from_adhesion()) {
      throw NotConverged("active set: no stick/slip partition found", iterations_,
                         largest_violation());
    }
    finish(state);
  }

  void run_partition(const SlipConditions& conditions, const Prescribed& load,
                     const std::vector<Zone>& zones, ContactState& state) {
    enough_ = 1;
    begin(conditions, load, zones);
    respond();
    finish(state);
  }

 private:
  /// The solution of a partition, which is linear in bound, offset, reference and load.
  struct Response {
    VectorXd traction;
    VectorXd slip;  ///< zero in adhesion
    double rigid_slip = 0;
    double residual = 0;
  };

  void begin(const SlipConditions& conditions, const Prescribed& load,
             const std::vector<Zone>& zones) {
    conditions_ = &conditions;
    prescribed_ = load.value;
    force_prescribed_ = load.by_force;
    bound_scale_ = conditions.bound.maxCoeff();
    zones_ = zones;
    iterations_ = 0;
    system_.prescribe_force(force_prescribed_);
    system_.set_compliant(conditions.compliant);
  }

  void finish(ContactState& state) {
    if (!(response_.residual <= system_.solver().tolerance)) {
      throw NotConverged(
          fmt::format("active set: the residual of the equations in adhesion is above {}",
                      format_short(system_.solver().tolerance)),
          iterations_, response_.residual);
    }
    state.traction = response_.traction;
    state.slip = response_.slip;
    state.zones = zones_;
    state.rigid_slip = response_.rigid_slip;
    state.iterations = iterations_;
    state.residuals = residuals();
  }

  Index size() const { return conditions_->bound.size(); }
  Zone& zone(Index i) { return zones_[static_cast<std::size_t>(i)]; }
  Zone zone(Index i) const { return zones_[static_cast<std::size_t>(i)]; }

  bool carries_load() const {
    return !force_prescribed_ ||
           std::find(zones_.begin(), zones_.end(), Zone::adhesion) != zones_.end();
  }

  /// Solves for the partition that the system follows. The unknowns are increments p - reference,
  /// so that small ones keep their digits.
  void solve_partition(const SlipConditions& conditions, double prescribed, Response& response) {
    VectorXd& traction = response.traction;
    VectorXd& slip = response.slip;
    increment_.setZero(size());
    for (Index i = 0; i < size(); ++i) {
      if (zone(i) == Zone::adhesion) continue;
      increment_[i] = static_cast<double>(zone(i)) * conditions.bound[i] - conditions.reference[i];
    }
    traction = conditions.reference + increment_;
    slip = conditions.offset;
    for (const auto& [element, compliance] : conditions_->compliant) {
      slip[element] += compliance * increment_[element];
    }
    if (!increment_.isZero(0)) {
      system_.response().apply(increment_, product_);
      slip += product_;
    }
    const double other = force_prescribed_ ? system_.weights().dot(traction) : 0;
    minus_slip_ = -slip;
    system_.solve(minus_slip_, prescribed - other, enough_, unknowns_);
    if (conditions_->common != 0 && !force_prescribed_) add_common_shift();
    traction += unknowns_.increment;
    slip += unknowns_.response;
    slip.array() += unknowns_.rigid_slip;
    for (Index i = 0; i < size(); ++i) {
      if (zone(i) == Zone::adhesion) slip[i] = 0;
    }
    response.rigid_slip = unknowns_.rigid_slip;
    if (conditions_->common != 0) response.rigid_slip -= conditions_->common * change_of_force();
    response.residual = unknowns_.residual;
  }

  /// Change of the force from the reference to the solution.
  double change_of_force() const {
    return system_.weights().dot(increment_) + system_.weights().dot(unknowns_.increment);
  }

  /// Adds the shift that the force causes by the common compliance to the solution without this
  /// compliance. The unknown rigid slip is the sum of both.
  void add_common_shift() {
    minus_slip_.setZero();
    system_.solve(minus_slip_, 1, enough_, by_shift_);
    const double common = conditions_->common;
    const double shift =
        common * change_of_force() / (1 - common * system_.weights().dot(by_shift_.increment));
    unknowns_.increment += shift * by_shift_.increment;
    unknowns_.response += shift * by_shift_.response;
    unknowns_.rigid_slip += shift;
    unknowns_.residual = std::max(unknowns_.residual, by_shift_.residual);
  }

  void respond() {
    count_work(20 * static_cast<double>(size()));
    ++iterations_;
    system_.follow(zones_);
    solve_partition(*conditions_, prescribed_, response_);
    slip_scale_ =
        std::max(std::abs(response_.rigid_slip), response_.slip.lpNorm<Eigen::Infinity>());
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

  /// Exchanges all violating elements at once.
  /// \return false if the partitions do not settle: an element would be released again, and there
  ///         are not fewer violations than when this happened before
  bool exchange_blocks() {
    released_.assign(zones_.size(), 0);
    Index fewest = std::numeric_limits<Index>::max();
    while (carries_load()) {
      respond();
      const Violations found = exchange_violating();
      if (found.all == 0) return true;
      if (!found.again) continue;
      if (found.all >= fewest) return false;
      fewest = found.all;
      released_.assign(zones_.size(), 0);
    }
    return false;
  }

  struct Violations {
    Index all = 0;
    bool again = false;  ///< whether an element is released that has been released before
  };

  /// Elements above the bound slip, and elements that slip in the wrong direction stick.
  Violations exchange_violating() {
    Violations found;
    for (Index i = 0; i < size(); ++i) {
      if (above_bound(i)) {
        char& released = released_[static_cast<std::size_t>(i)];
        found.again = found.again || released != 0;
        released = 1;
        zone(i) = slip_zone(response_.traction[i]);
        ++found.all;
      } else if (zone(i) != Zone::adhesion && slips_wrongly(i)) {
        zone(i) = Zone::adhesion;
        ++found.all;
      }
    }
    return found;
  }

  struct Exchange {
    double fraction;  ///< of the relief that is left
    Index element;
    Zone from;
    Zone to;
  };

  /// The next exchange as the remaining fraction of the relief falls to zero. Traction and slip are
  /// the response plus that fraction of `rise`. The previous exchange cannot be reversed
  /// immediately, with one exception: an element with a small bound may stick on its way from one
  /// direction of slip to the other.
  std::optional<Exchange> next_exchange(const SlipConditions& relief, const Response& rise,
                                        const std::optional<Exchange>& last) const {
    std::optional<Exchange> next;
    const auto consider = [&](double violation, double slope, double scale, Index i, Zone to) {
      if (slope <= 0 || violation <= tolerance * scale) return;
      if (last && last->element == i && last->from == to) return;
      if (!next || violation > slope * next->fraction) next = {violation / slope, i, zone(i), to};
    };
    for (Index i = 0; i < size(); ++i) {
      if (conditions_->bound[i] <= 0) continue;
      if (zone(i) != Zone::adhesion) {
        consider(wrong_slip(zone(i), response_.slip[i]), -wrong_slip(zone(i), rise.slip[i]),
                 slip_scale_, i, Zone::adhesion);
        continue;
      }
      for (const Zone to : {Zone::slip_negative, Zone::slip_positive}) {
        const double s = static_cast<double>(to);
        consider(s * response_.traction[i] - conditions_->bound[i],
                 relief.bound[i] - s * rise.traction[i], bound_scale_, i, to);
      }
    }
    return next;
  }

  /// The element that sticks when the last one in adhesion begins to slip under a force: the
  /// rigid slip then jumps until an element that slips in the other direction sticks.
  std::optional<Exchange> next_to_stick(const Exchange& slips) const {
    std::optional<Exchange> next;
    double least = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < size(); ++i) {
      if (conditions_->bound[i] <= 0 || zone(i) == slips.to) continue;
      const double slip = std::abs(response_.slip[i] + slips.fraction * rise_.slip[i]);
      if (slip >= least) continue;
      least = slip;
      next = {slips.fraction, i, zone(i), Zone::adhesion};
    }
    return next;
  }

  SlipConditions unchanged() const {
    const VectorXd zeros = VectorXd::Zero(size());
    return {.bound = zeros, .offset = zeros, .reference = zeros};
  }

  /// Changes of bound and offset that make the partition the solution, with some margin.
  SlipConditions relieved() const {
    SlipConditions relief = unchanged();
    for (Index i = 0; i < size(); ++i) {
      if (conditions_->bound[i] <= 0) continue;
      if (zone(i) == Zone::adhesion) {
        const double excess = excess_over_bound(response_.traction[i], conditions_->bound[i]);
        relief.bound[i] = std::max(0.0, excess + margin * std::abs(excess));
      } else {
        const double wrong = wrong_slip(zone(i), response_.slip[i]);
        relief.offset[i] =
            -static_cast<double>(zone(i)) * std::max(0.0, wrong + margin * std::abs(wrong));
      }
    }
    return relief;
  }

  /// Follows the path from the partition of the system, with its relief, to the given bounds and
  /// offsets.
  /// \return false if the end is not reached within `most_exchanges`
  bool follow_path(const SlipConditions& relief, Index most_exchanges) {
    const Index limit = iterations_ + most_exchanges;
    for (std::optional<Exchange> last; iterations_ < limit;) {
      solve_partition(relief, 0, rise_);
      const auto next = next_exchange(relief, rise_, last);
      if (!next) return largest_violation() <= acceptable_violation;
      zone(next->element) = next->to;
      last = next;
      if (!carries_load()) {
        last = next_to_stick(*next);
        if (!last) return false;
        zone(last->element) = last->to;
      }
      respond();
    }
    return false;
  }

  /// Solves for the current partition, except that elements with a zero bound slip.
  /// \return false if no element is left to carry the load
  bool start() {
    for (Index i = 0; i < size(); ++i) {
      if (conditions_->bound[i] <= 0 && zone(i) == Zone::adhesion) zone(i) = Zone::slip_positive;
    }
    if (!carries_load()) return false;
    respond();
    return true;
  }

  bool follow_path_from(const std::vector<Zone>& first) {
    zones_ = first;
    return follow_path_from_here(most_exchanges_from_given);
  }

  bool follow_path_from_here(Index most_exchanges) {
    return start() && follow_path(relieved(), most_exchanges);
  }

  /// A given partition in which all elements stick contains no information.
  bool follow_path_nearby(const std::vector<Zone>& given) {
    const bool knows = std::ranges::any_of(given, [](Zone z) { return z != Zone::adhesion; });
    return (!knows && follow_path_from_here(most_exchanges_from_blocks)) || follow_path_from(given);
  }

  bool follow_path_from_adhesion() {
    SlipConditions higher = unchanged();
    higher.bound = (conditions_->bound.array() > 0).cast<double>();
    zones_.assign(zones_.size(), Zone::adhesion);
    return start() && follow_path(higher, 20 * size() + 100);
  }

  /// Residuals of the last solution.
  Residuals residuals() const {
    double excess = 0;
    double wrong = 0;
    for (Index i = 0; i < size(); ++i) {
      const double bound = conditions_->bound[i];
      if (bound <= 0) continue;
      if (zone(i) == Zone::adhesion) {
        excess = std::max(excess, excess_over_bound(response_.traction[i], bound));
      } else {
        wrong = std::max(wrong, wrong_slip(zone(i), response_.slip[i]));
      }
    }
    return {.equations = response_.residual,
            .bound = excess > 0 ? excess / bound_scale_ : 0,
            .slip = wrong > 0 ? wrong / slip_scale_ : 0};
  }

  double largest_violation() const {
    if (!carries_load()) return std::numeric_limits<double>::infinity();
    const Residuals left = residuals();
    return std::max(left.bound, left.slip);
  }

  AdhesionSystem system_;
  const SlipConditions* conditions_ = nullptr;
  double prescribed_ = 0;
  double enough_ = 0;  ///< required residual of solutions, over the tolerance
  bool force_prescribed_ = false;
  double bound_scale_ = 0;
  double slip_scale_ = 0;
  std::vector<Zone> zones_;
  std::vector<char> released_;  ///< whether the block exchange has released the element
  Response response_;
  Response rise_;  ///< of the path
  AdhesionSystem::Unknowns unknowns_;
  AdhesionSystem::Unknowns by_shift_;  ///< unknowns due to a unit rigid slip
  VectorXd increment_, product_, minus_slip_;
  int iterations_ = 0;
};

ActiveSet::ActiveSet(LinearOperator response, VectorXd weights, const Solver& solver)
    : search_(std::make_unique<ContactSearch>(std::move(response), std::move(weights), solver)) {}

ActiveSet::~ActiveSet() = default;

ActiveSet::ActiveSet(const ActiveSet& other)
    : search_(std::make_unique<ContactSearch>(*other.search_)) {}

ActiveSet& ActiveSet::operator=(const ActiveSet& other) {
  if (this != &other) *this = ActiveSet(other);
  return *this;
}

ActiveSet::ActiveSet(ActiveSet&&) noexcept = default;
ActiveSet& ActiveSet::operator=(ActiveSet&&) noexcept = default;

void ActiveSet::solve(const SlipConditions& conditions, const Prescribed& load,
                      ContactState& state) {
  if (load.by_force) {
    require_below_full_sliding(load.value, search_->system().weights().dot(conditions.bound));
  }
  search_->run(conditions, load, state);
}

ContactState ActiveSet::solve(const SlipConditions& conditions, const Prescribed& load) {
  const auto size = static_cast<std::size_t>(conditions.bound.size());
  return solve(conditions, load, std::vector<Zone>(size, Zone::adhesion));
}

ContactState ActiveSet::solve(const SlipConditions& conditions, const Prescribed& load,
                              const std::vector<Zone>& first) {
  ContactState state{.traction = {}, .slip = {}, .zones = first};
  solve(conditions, load, state);
  return state;
}

void ActiveSet::solve_partition(const SlipConditions& conditions, const Prescribed& load,
                                const std::vector<Zone>& zones, ContactState& state) {
  search_->run_partition(conditions, load, zones, state);
}

double ActiveSet::condition() { return search_->condition(); }

void ActiveSet::archive(Archive& archive) { search_->archive(archive); }

const Eigen::VectorXd& ActiveSet::weights() const { return search_->system().weights(); }
const LinearOperator& ActiveSet::response() const { return search_->system().response(); }

}  // namespace microslip
