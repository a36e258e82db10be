// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/inverted_rolling.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"
#include "stick_zone.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Largest theta. Beyond it the stick zone is shorter than 1e-80 of the contact.
constexpr double largest_theta = 200;

/// Least half-width of a strip, over the half-width of the contact; quadrature panels have to be as
/// short as that.
constexpr double narrowest_strip = 0.01;

/// Largest number of pieces of a table: the cost of evaluating all tractions grows with the square
/// of this number.
constexpr Index most_bound_pieces = 20000;
constexpr double least_theta = 1e-140;

/// Largest steps of the search for the logarithm of theta.
constexpr double most_step = 0.25;
constexpr double least_search_step = 1e-6;

/// Begin of a search: a logarithm of theta, and the first of growing steps.
struct Guess {
  double at;
  double step;        ///< the first step, small for a good guess
  double longest_up;  ///< longest step upwards
};

/// Searches for a change of sign of f(ln theta), beginning at a guess: upwards if f is below zero
/// there.
/// \param bits  accuracy of the result, in bits
/// \return ln theta; none if the sign does not change
template <class Function>
std::optional<double> root_from(const Guess& guess, const Function& f, unsigned bits) {
  const double lowest = std::log(least_theta);
  const double highest = std::log(largest_theta);
  double at = std::clamp(guess.at, lowest, highest);
  double value = f(at);
  double step = value < 0 ? guess.step : -guess.step;
  double next = at;
  double next_value = value;
  while (value * next_value > 0) {
    at = std::exchange(next, std::clamp(next + step, lowest, highest));
    if (next == at) return std::nullopt;
    value = std::exchange(next_value, f(next));
    step = std::min(guess.longest_up, step * (std::abs(step) < 0.1 ? 4 : 1.5));
  }
  if (next_value == 0) return next;
  if (value == 0) return at;
  std::uintmax_t most = 80;
  const bool up = at < next;
  const auto root = boost::math::tools::toms748_solve(
      f, up ? at : next, up ? next : at, up ? value : next_value, up ? next_value : value,
      boost::math::tools::eps_tolerance<double>(bits), most);
  return (root.first + root.second) / 2;
}

/// Finds the one stick zone of a load between bodies of the same material, for any bound. Its two
/// ends are the unknowns. Bodies of different material have several zones, see
/// unlike_zone_search.hpp.
class StickZoneSearch {
 public:
  explicit StickZoneSearch(std::shared_ptr<const InvertedContact> contact)
      : contact_(std::move(contact)) {}

  int evaluations() const { return evaluations_; }

  /// The next search for the same load on another contact with a similar stick zone.
  StickZoneSearch next(std::shared_ptr<const InvertedContact> contact, double near) const {
    StickZoneSearch next(std::move(contact));
    next.trailing_ = {trailing_.at, near, most_step};
    next.leading_ = {leading_.at, near, most_step};
    next.known_ = true;
    next.slopes_ = slopes_;
    next.evaluations_ = evaluations_;
    return next;
  }

  /// \param reached  the load that a zone carries
  /// \throws NotConverged if there is no such stick zone
  StickZone meet(double load, const std::function<double(const StickZone&)>& reached) {
    const auto excess = [&](const StickZone& zone) {
      const double carried = reached(zone);
      return carried > 0 ? std::log(carried / load) : -1000;
    };
    if (!contact_->slips_before()) {
      trailing_.at = root([&](double at) { return excess(zone(at, 0)); }, all_bits);
      return zone(trailing_.at, 0);
    }
    if (!known_) guess(excess);
    if (polish(excess)) return zone(trailing_.at, std::exp(leading_.at));
    trailing_ = {small, most_step, any};
    trailing_.at = root([&](double at) { return excess(with_trailing(at)); }, few_bits);
    with_trailing(trailing_.at);
    leading_.at = leading_roots_.at(trailing_.at);
    if (!polish(excess)) throw failure("a kink of the bound ends the stick zone");
    return zone(trailing_.at, std::exp(leading_.at));
  }

 private:
  NotConverged failure(const std::string& why) const {
    return {"steady rolling: " + why, evaluations_, 1};
  }

  StickZone zone(double log_trailing, double leading) {
    ++evaluations_;
    return {contact_, std::exp(log_trailing), leading};
  }

  template <class Excess>
  double root(const Excess& excess, unsigned bits) {
    const auto found = root_from(trailing_, excess, bits);
    if (!found) throw failure("no stick zone carries the load");
    return *found;
  }

  /// Begins with the zone that carries the load without slip ahead of it.
  template <class Excess>
  void guess(const Excess& excess) {
    const double at =
        root([&](double log_trailing) { return excess(zone(log_trailing, 0)); }, few_bits);
    trailing_.at = at;
    with_trailing(at);
    leading_.at = leading_roots_.at(at);
  }

  StickZone with_trailing(double log_trailing) {
    const auto lack = [&](double log_leading) {
      return -zone(log_trailing, std::exp(log_leading)).leading_root();
    };
    const auto root = root_from(leading_guess(log_trailing), lack, few_bits);
    if (!root) throw failure("no end of the stick zone");
    leading_roots_[log_trailing] = *root;
    return zone(log_trailing, std::exp(*root));
  }

  /// Newton's method for both ends at once, from a guess. Slopes are kept as long as the iteration
  /// converges with them.
  template <class Excess>
  bool polish(const Excess& excess) {
    constexpr int most = 30;
    constexpr double difference = 1e-6;
    constexpr double longest = 0.5;
    constexpr double rounding = 1e-13;
    const auto residual = [&](const Eigen::Vector2d& at) {
      const StickZone found = zone(at[0], std::exp(at[1]));
      return Eigen::Vector2d(excess(found), found.relative_leading_root());
    };
    Eigen::Vector2d at(trailing_.at, leading_.at);
    Eigen::Vector2d value = residual(at);
    double before = HUGE_VAL;
    for (int i = 0; i < most && value.allFinite(); ++i) {
      const double size = value.norm();
      const bool slow = size > 0.1 * before;
      if (slow && size < least_residual) break;
      if (slow || slopes_.isZero()) {
        slopes_.col(0) = (residual(at + Eigen::Vector2d(difference, 0)) - value) / difference;
        slopes_.col(1) = (residual(at + Eigen::Vector2d(0, difference)) - value) / difference;
      }
      Eigen::Vector2d step = slopes_.inverse() * value;
      if (!step.allFinite()) return false;
      step *= std::min(1.0, longest / step.norm());
      at -= step;
      before = size;
      value = residual(at);
      if (step.norm() < rounding) break;
    }
    if (!(value.norm() < least_residual)) return false;
    trailing_.at = at[0];
    leading_.at = at[1];
    return true;
  }

  /// The end of adhesion is the first root from the leading edge on. This root moves away from the
  /// leading edge as the trailing slip zone grows, so that a search that begins at the root for a
  /// shorter slip zone goes upwards.
  Guess leading_guess(double log_trailing) const {
    const auto longer = leading_roots_.lower_bound(log_trailing);
    if (longer == leading_roots_.begin()) return leading_;
    const auto& [shorter, root] = *std::prev(longer);
    return {root, std::clamp(log_trailing - shorter, least_search_step, most_step), most_step};
  }

  static constexpr unsigned all_bits = 52;
  static constexpr unsigned few_bits = 8;
  static constexpr double least_residual = 1e-9;
  static constexpr double small = -18;
  static constexpr double any = 4;

  std::shared_ptr<const InvertedContact> contact_;
  Guess trailing_{0, most_step, any};
  Guess leading_{-6, most_step, most_step};
  bool known_ = false;  ///< whether trailing_ and leading_ are good guesses
  Eigen::Matrix2d slopes_ = Eigen::Matrix2d::Zero();
  std::map<double, double> leading_roots_;  ///< by the logarithm of the trailing theta
  int evaluations_ = 0;
};

}  // namespace

namespace {

/// \return the kernel
const Kernel& half_space(const Kernel& kernel) {
  require_half_space(kernel, "the inversion");
  return kernel;
}

}  // namespace

InvertedRolling::InvertedRolling(const Kernel& kernel, const TractionBound& bound, double fineness)
    : contact_(std::make_shared<InvertedContact>(half_space(kernel), bound, fineness)) {
  if (std::isfinite(kernel.clear_distance())) {
    constexpr double coarse = 0.4;
    const PlaneKernel plane(kernel.material(), 1);
    stages_.push_back({std::make_shared<InvertedContact>(plane, bound, 1), most_step});
    stages_.push_back({std::make_shared<InvertedContact>(kernel, bound, coarse), 0.1});
  }
  stages_.push_back({contact_, 1e-4});
}

std::optional<std::string> InvertedRolling::obstacle() const {
  if (contact_->kernel.clear_distance() < narrowest_strip * contact_->half_width()) {
    return "the strip is too narrow for the inversion";
  }
  const auto* table = std::get_if<TabulatedBound>(&contact_->bound);
  if (table != nullptr && table->x().size() > most_bound_pieces) {
    return "the bound has too many pieces for the inversion";
  }
  return std::nullopt;
}

InvertedSolution InvertedRolling::solve(const Load& load) const {
  if (const auto why = obstacle()) throw NotConverged("steady rolling: " + *why, 0, 1);
  const Prescribed prescribed(load);
  require_below_full_sliding(prescribed, full_sliding_force(contact_->bound));
  const double target = std::abs(prescribed.value);
  if (target == 0 || (!prescribed.by_force && target >= contact_->sliding_creepage())) {
    return {contact_, nullptr, load, 0};
  }
  const auto reached = [&](const StickZone& zone) {
    return prescribed.by_force ? zone.force() : zone.creepage();
  };
  StickZoneSearch search(stages_.front().contact);
  StickZone zone = search.meet(target, reached);
  for (std::size_t i = 1; i < stages_.size(); ++i) {
    search = search.next(stages_[i].contact, stages_[i].near);
    zone = search.meet(target, reached);
  }
  zone.complete();
  return {contact_, std::make_shared<StickZone>(std::move(zone)), load, search.evaluations()};
}

InvertedSolution::InvertedSolution(std::shared_ptr<const InvertedContact> contact,
                                   std::shared_ptr<const StickZone> zone, const Prescribed& load,
                                   int evaluations)
    : contact_(std::move(contact)), zone_(std::move(zone)), evaluations_(evaluations) {
  const auto [by_force, value] = load;
  direction_ = load.direction();
  const double carried = zone_ ? zone_->force() : full_sliding_force(contact_->bound);
  creepage_ = by_force && zone_ ? direction_ * zone_->creepage() : by_force ? 0 : value;
  force_ = by_force ? value : -direction_ * carried;
}

double InvertedSolution::creepage() const { return creepage_; }
double InvertedSolution::force() const { return force_; }
double InvertedSolution::dissipation() const { return -creepage_ * force_; }
Index InvertedSolution::unknowns() const { return zone_ ? zone_->unknowns() : 0; }
double InvertedSolution::condition() const { return zone_ ? zone_->condition() : 1; }

double InvertedSolution::stick_edge() const {
  if (zone_) return zone_->begin();
  return direction_ == 0 ? -contact_->half_width() : contact_->half_width();
}

double InvertedSolution::stick_end() const { return zone_ ? zone_->end() : contact_->half_width(); }

bool InvertedSolution::sticks(double x) const {
  return direction_ == 0 || (zone_ && x >= zone_->begin() && x <= zone_->end());
}

double InvertedSolution::traction(double x) const {
  if (direction_ == 0) return 0;
  return -direction_ * (zone_ ? zone_->traction(x) : contact_->bound_at(x));
}

double InvertedSolution::slip(double x) const {
  if (sticks(x)) return 0;
  return zone_ ? direction_ * zone_->slip(x)
               : creepage_ - direction_ * contact_->sliding->strain(x);
}

VectorXd InvertedSolution::displacement(const VectorXd& x) const {
  if (direction_ == 0) return VectorXd::Zero(x.size());
  if (zone_) return -direction_ * zone_->displacement(x);
  return -direction_ *
         x.unaryExpr([this](double xi) { return contact_->sliding->displacement(xi); });
}

bool InvertedSolution::keeps_conditions() const {
  if (zone_) return zone_->keeps_conditions();
  // In full sliding the strain at some point inside may be larger than at the leading edge.
  constexpr Index places = 500;
  const double a = contact_->half_width();
  for (Index i = 0; i < places && direction_ != 0; ++i) {
    const double x = a * ((2 * static_cast<double>(i) + 1) / places - 1);
    if (direction_ * slip(x) < 0) return false;
  }
  return true;
}

Evidence InvertedSolution::evidence() const {
  constexpr Index fewest = 20;
  constexpr Index most = 100;
  const auto* table = std::get_if<TabulatedBound>(&contact_->bound);
  const Index parts = table == nullptr ? fewest : std::clamp(table->x().size(), fewest, most);
  return evidence_by_samples(
      contact_->bound, [this](double x) { return traction(x); },
      [this](double x) { return slip(x); }, stick_edge(), stick_end(), parts, force(), creepage());
}

}  // namespace microslip
