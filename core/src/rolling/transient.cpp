// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/transient.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "microslip/rolling/schemes.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "rolling_grid.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// A start file may have been printed with few digits.
constexpr double printed_traction = 1e-3;

/// A shift to a force that differs from that now by so little, over full sliding, is none.
constexpr double same_force = 1e-13;

/// A step of length 0 does not change the force; one that was printed differs from it by so little,
/// over full sliding.
constexpr double kept_force = 1e-9;

/// A remainder below this part of a step is rounding of the distance.
constexpr double negligible = 1e-9;

/// Steps of given lengths, in turn, the last of which ends at a distance. They are those from
/// distance 0; of a start further on, the first one is what is left of one of them.
class Schedule {
 public:
  Schedule(double distance, const std::vector<double>& lengths, double start = 0)
      : distance_(distance), start_(start), lengths_(lengths), ends_(lengths.size()) {
    require_positive("distance", distance);
    require(distance > start, "distance", distance,
            [&] { return fmt::format("more than {}, where it starts", format_short(start)); });
    for (const double length : lengths) require_positive("step length", length);
    std::partial_sum(lengths.begin(), lengths.end(), ends_.begin());
    first_ = step_after(start);
  }

  std::size_t first() const { return first_; }

  /// Where step k begins.
  double begin(std::size_t k) const { return k == first_ ? start_ : unlimited_begin(k); }

  double end(std::size_t k) const { return is_last(k) ? distance_ : unlimited_end(k); }

  double length(std::size_t k) const {
    const bool is_begun = k == first_ && start_ != unlimited_begin(k);
    const double rest = (is_begun ? end(k) : distance_) - begin(k);
    return rest < (1 - negligible) * full_length(k) ? rest : full_length(k);
  }

  bool is_last(std::size_t k) const {
    return distance_ - unlimited_end(k) <= negligible * full_length(k);
  }

  std::size_t size() const {
    std::size_t k = std::max(first_, whole_cycles(distance_));
    while (!is_last(k)) ++k;
    return k - first_ + 1;
  }

  /// End of the last step if the distance limits it by rounding only; else the distance.
  double unlimited_distance() const {
    const std::size_t last = first_ + size() - 1;
    const double end = unlimited_end(last);
    return std::abs(distance_ - end) <= negligible * full_length(last) ? end : distance_;
  }

 private:
  /// A number of steps that end before a distance.
  std::size_t whole_cycles(double distance) const {
    const double cycles = std::floor((1 - negligible) * distance / ends_.back());
    return static_cast<std::size_t>(cycles) * ends_.size();
  }

  std::size_t step_after(double start) const {
    if (start <= 0) return 0;
    std::size_t k = whole_cycles(start);
    while (unlimited_end(k) - start <= negligible * full_length(k)) ++k;
    return k;
  }

  double unlimited_begin(std::size_t k) const { return k == 0 ? 0 : unlimited_end(k - 1); }

  double full_length(std::size_t k) const { return lengths_[k % lengths_.size()]; }

  double unlimited_end(std::size_t k) const {
    const auto cycles = static_cast<double>(k / ends_.size());
    return cycles * ends_.back() + ends_[k % ends_.size()];
  }

  double distance_, start_;
  const std::vector<double>& lengths_;
  std::vector<double> ends_;
  std::size_t first_ = 0;
};

}  // namespace

void validate(const TransientProblem& problem) {
  validate(problem.contact);
  if (!problem.friction) return;
  validate(*problem.friction);
  if (problem.contact.has_unlike_bodies()) {
    throw std::invalid_argument("friction_law: expected none where bodies differ in material");
  }
  if (std::holds_alternative<Remembered>(problem.scheme)) return;
  if (!std::holds_alternative<Direct>(problem.scheme)) {
    reject("scheme", name_of(problem.scheme),
           "remembered or direct where friction depends on slip");
  }
  if (problem.friction->remembers()) {
    reject("scheme", name_of(problem.scheme), "remembered where friction has a memory");
  }
}

void require_definite(const TransientProblem& problem) {
  require_definite(problem.contact.kernel, problem.grid.half_width() + problem.grid.spacing());
}

void require_definite(const Kernel& kernel, double reach) {
  const double definite = kernel.definite_half_length();
  if (definite > reach) return;
  require(false, "length", definite / 2, [&] {
    return fmt::format(
        "more than (half_width + dx)/2 = {} mm, from where on plane strain resists displacements; "
        "below, a creepage would drive the force the wrong way. Steady rolling takes any length",
        format_short(reach / 2));
  });
}

void require_within_bound(const VectorXd& x, const VectorXd& bound, const VectorXd& traction) {
  const double tolerance = printed_traction * bound.maxCoeff();
  for (Index i = 0; i < x.size(); ++i) {
    require(std::abs(traction[i]) <= bound[i] + tolerance, "traction", traction[i], [&] {
      return fmt::format("at most the bound, {}, at x = {}", format_short(bound[i]),
                         format_short(x[i]));
    });
  }
}

TransientRolling::TransientRolling(const TransientProblem& problem, const Start& start,
                                   const ContactScale& contact)
    : problem_(problem) {
  validate(problem);
  require_definite(problem);
  grid_ = rolling_grid(problem);
  if (const auto* saved = std::get_if<SavedState>(&start)) {
    read(*saved);
    return;
  }
  set_contact(contact);
  if (const auto* shift = std::get_if<CattaneoShift>(&start)) {
    start_from_shift({shift->force});
  } else {
    const auto* traction = std::get_if<VectorXd>(&start);
    start_from(traction != nullptr ? *traction : VectorXd::Zero(problem.grid.size()));
  }
}

TransientRolling::TransientRolling(const TransientRolling& other)
    : problem_(other.problem_),
      grid_(other.grid_->clone()),
      state_(other.state_),
      next_(other.next_),
      solved_(other.solved_) {}

TransientRolling& TransientRolling::operator=(const TransientRolling& other) {
  return *this = TransientRolling(other);
}

TransientRolling::TransientRolling(TransientRolling&&) noexcept = default;
TransientRolling& TransientRolling::operator=(TransientRolling&&) noexcept = default;
TransientRolling::~TransientRolling() = default;

const VectorXd& TransientRolling::x() const { return grid_->x(); }
const VectorXd& TransientRolling::bound() const { return grid_->bound(); }

const ContactScale& TransientRolling::contact() const { return grid_->contact(); }

VectorXd TransientRolling::traction_at_nodes() const { return grid_->traction_at_nodes(state_); }
VectorXd TransientRolling::bound_at_nodes() const {
  const auto& [half_width, bound] = state_.scale;
  if (half_width == 0) return VectorXd::Zero(grid_->x().size());
  VectorXd values = bound * bound_at(problem_.contact.bound, grid_->x() / half_width);
  const VectorXd& ratio = grid_->friction_ratio();
  return ratio.size() > 0 ? VectorXd(values.cwiseProduct(ratio)) : values;
}
VectorXd TransientRolling::displacement() const { return grid_->displacement(state_.traction); }

double TransientRolling::elastic_energy() const {
  const VectorXd& p = state_.traction;
  return grid_->weights().cwiseProduct(p).dot(grid_->displacement(p)) / 2;
}

double TransientRolling::condition() { return grid_->condition(); }

void TransientRolling::start_from(const VectorXd& traction) {
  const VectorXd nodes = problem_.grid.nodes();
  require_within_bound(nodes, bound_at(problem_.contact.bound, nodes), traction);
  solved_.reset();
  grid_->start_from(traction, state_);
}

double TransientRolling::start_from_shift(const PrescribedForce& force) {
  TransientRolling shifted(*this);  // so that nothing is lost if there is no such shift
  shifted.start_from(VectorXd::Zero(problem_.grid.size()));
  const double distance = shifted.grid_->start_from_shift(force, shifted.state_);
  *this = std::move(shifted);
  return distance;
}

Shift TransientRolling::shift(const ShiftLoad& load) {
  const Prescribed prescribed(load);
  if (!prescribed.by_force) require(true, "shift", prescribed.value, "a finite number");
  const auto zeros = [&]() -> VectorXd { return VectorXd::Zero(state_.traction.size()); };
  const double rounding = same_force * grid_->weights().dot(grid_->bound());
  const bool is_none = prescribed.by_force ? std::abs(prescribed.value - state_.force) <= rounding
                                           : prescribed.value == 0;
  if (is_none && contact() == state_.scale) {
    return {.slip = zeros()};
  }
  solved_.reset();
  Shift result = grid_->solve_shift(state_, load, next_);
  std::swap(state_, next_);
  grid_->accept_step();
  return result;
}

void TransientRolling::set_speed(double speed) {
  require_positive("speed", speed);
  solved_.reset();
  grid_->set_speed(speed);
}

void TransientRolling::set_contact(const ContactScale& scale) {
  const bool is_another = scale != contact();
  grid_->set_contact(scale);
  if (is_another) solved_.reset();
}

void TransientRolling::solve_step(double length, const Load& load, StepJacobian* jacobian) {
  solved_.reset();
  grid_->solve_step(state_, length, load, next_, jacobian);
  next_.evidence.power = std::max(next_.evidence.power, std::abs(next_.dissipation));
  solved_ = {length, load};
}

bool TransientRolling::is_solved(double length, const Load& load) const {
  return solved_ && solved_->first == length && Prescribed(solved_->second) == Prescribed(load);
}

void TransientRolling::require_standstill(const Load& load) const {
  const auto require_kept = [](const char* name, double value, double now, double most_change) {
    require(std::abs(value - now) <= most_change, name, value, [&] {
      return fmt::format("{} as before in a step of length 0; a shift changes it without rolling",
                         format_short(now));
    });
  };
  const auto& [half_width, bound] = state_.scale;
  require_kept("half_width_factor", contact().half_width, half_width, 0);
  require_kept("bound_factor", contact().bound, bound, 0);
  const auto* force = std::get_if<PrescribedForce>(&load);
  if (force == nullptr) return;  // a creepage shifts nothing over no length
  const double full = grid_->weights().dot(grid_->bound());
  require_kept("force", force->value, state_.force, kept_force * full);
}

TransientState TransientRolling::attempt(double length, const Load& load) {
  if (length == 0) {
    require_standstill(load);
    return state_;
  }
  solve_step(length, load, nullptr);
  return next_;
}

TransientState TransientRolling::attempt(double length, const Load& load, StepJacobian& jacobian) {
  require(length != 0, "length", length, "a number > 0, because a step of length 0 has no slopes");
  solve_step(length, load, &jacobian);
  return next_;
}

void TransientRolling::step(double length, const Load& load) {
  if (length == 0) return require_standstill(load);
  if (!is_solved(length, load)) solve_step(length, load, nullptr);
  solved_.reset();
  std::swap(state_, next_);
  grid_->accept_step();
}

void TransientRolling::roll(double distance, const std::vector<double>& lengths,
                            const LoadHistory& loads,
                            const std::function<void(const TransientState&)>& after_step) {
  roll_on(state_.distance, 0, distance, lengths, loads,
          {.after_step = [&](const TransientState& state, auto) { after_step(state); }});
}

void TransientRolling::roll_to(double distance, const std::vector<double>& lengths,
                               const LoadHistory& loads,
                               const std::function<void(const TransientState&)>& after_step) {
  roll_to(distance, lengths, loads,
          {.after_step = [&](const TransientState& state, auto) { after_step(state); }});
}

void TransientRolling::roll_to(double distance, const std::vector<double>& lengths,
                               const LoadHistory& loads, const Observer& observer) {
  roll_on(0, state_.distance, distance, lengths, loads, observer);
}

/// Shifts the bodies at a distance where the loads do so without rolling.
void TransientRolling::stand(double distance, const LoadHistory& loads, const Observer& observer) {
  for (const LoadHistory::Standing& standing : loads.standing_at(distance)) {
    if (!standing.changes) continue;
    if (loads.changes_contact()) set_contact(standing.contact);
    const Shift shifted = shift(standing.load);
    if (observer.after_shift) observer.after_shift(state_, shifted, standing.time);
  }
}

void TransientRolling::roll_on(double origin, double start, double distance,
                               const std::vector<double>& lengths, const LoadHistory& loads,
                               const Observer& observer) {
  if (start == 0) stand(0, loads, observer);
  for_steps(distance, lengths, start, loads.ends_of_steps(),
            [&](double from, double to, double length) {
              if (loads.changes_contact()) set_contact(loads.contact_at(to));
              if (problem_.friction && loads.time_at(to)) {
                set_speed(length / (*loads.time_at(to) - *loads.time_at(from)));
              }
              step(loads.direction_to(to) * length, loads.between(from, to));
              // The same place, with fewer rounding errors.
              state_.distance = origin + loads.position_at(to);
              grid_->move_to(state_.distance);
              observer.after_step(state_, loads.time_at(to));
              stand(to, loads, observer);
            });
}

double stiffness(const TransientProblem& problem) {
  const double length = problem.grid.spacing();
  const double shift = 1e-9 * problem.grid.half_width();
  TransientRolling at_rest(problem);
  return -at_rest.attempt(length, PrescribedCreepage{shift / length}).force / shift;
}

void for_steps(double distance, const std::vector<double>& lengths, double start,
               const std::function<void(double from, double to, double length)>& step) {
  const Schedule schedule(distance, lengths, start);
  for (std::size_t k = schedule.first();; ++k) {
    step(schedule.begin(k), schedule.end(k), schedule.length(k));
    if (schedule.is_last(k)) return;
  }
}

void for_steps(double distance, const std::vector<double>& lengths, double start,
               const std::vector<double>& ends,
               const std::function<void(double from, double to, double length)>& step) {
  constexpr double rounding = 1e-9;
  double begin = start;
  for_steps(distance, lengths, start, [&](double from, double to, double length) {
    const double margin = rounding * (to - from);
    bool is_whole = begin == from;
    auto end = std::ranges::upper_bound(ends, begin + margin);
    for (; end != ends.end() && *end < to - margin; ++end) {
      step(begin, *end, *end - begin);
      begin = *end;
      is_whole = false;
    }
    const bool is_there = end != ends.end() && *end <= to + margin;
    const double until = is_there ? *end : to;
    if (until - begin > margin) step(begin, until, is_whole ? length : until - begin);
    begin = until;
  });
}

std::size_t number_of_steps(double distance, const std::vector<double>& lengths, double start) {
  return Schedule(distance, lengths, start).size();
}

std::size_t number_of_steps(double distance, const std::vector<double>& lengths, double start,
                            const std::vector<double>& ends) {
  if (ends.empty()) return number_of_steps(distance, lengths, start);
  std::size_t count = 0;
  for_steps(distance, lengths, start, ends, [&](double, double, double) { ++count; });
  return count;
}

double last_step(double distance, const std::vector<double>& lengths, double start) {
  const Schedule schedule(distance, lengths, start);
  return schedule.length(schedule.first() + schedule.size() - 1);
}

double end_of_whole_steps(double distance, const std::vector<double>& lengths) {
  return Schedule(distance, lengths).unlimited_distance();
}

}  // namespace microslip
