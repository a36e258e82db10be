// SPDX-License-Identifier: GPL-3.0-or-later
#include "brush_rolling.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Where springs stick, b < c, and the bound at c.
struct StuckSprings {
  double begin, end;
  double bound;
};

/// A brush that rolls over its contact; tractions are counted as positive.
class RollingBrush {
 public:
  explicit RollingBrush(const TractionBound& bound) : bound_(bound) {
    const double a = half_width_of(bound);
    if (const auto* table = std::get_if<TabulatedBound>(&bound)) {
      for (Index i = 0; i < table->x().size(); ++i) add(table->x()[i], table->values()[i]);
      return;
    }
    constexpr int places = 4000;
    for (int i = 0; i <= places; ++i) {
      const double x = -a * std::cos(std::numbers::pi * i / places);
      add(x, at(x));
    }
  }

  double at(double x) const {
    return std::visit([&](const auto& g) { return g(x); }, bound_);
  }

  /// The zones from the leading edge on, for a traction that grows by m a length.
  std::vector<StuckSprings> zones(double m) const {
    count_work(4 * static_cast<double>(x_.size()));
    std::vector<StuckSprings> zones;
    std::size_t i = x_.size() - 1;
    double end = x_[i], bound = 0;  // of the zone that may begin here; new material is unstressed
    for (;;) {
      const std::size_t first = i;
      const double level = bound + m * end;
      while (i > 0 && value_[i - 1] + m * x_[i - 1] >= level) --i;
      if (i == 0) {
        if (end > x_[0]) zones.push_back({x_[0], end, bound});
        return zones;
      }
      const double begin = std::min(end, crossing(m, level, i));
      if (begin < end) zones.push_back({begin, end, bound});
      // The springs slip on as long as the bound falls faster than a stuck traction grows.
      --i;
      while (i > 0 && value_[i - 1] + m * x_[i - 1] < value_[i] + m * x_[i]) --i;
      if (i == 0) return zones;
      end = lowest(m, i);
      bound = smooth() ? at(end) : value_[i];
      // The search for the next crossing begins on the leading side of the minimum.
      if (x_[i] < end && i + 1 < first) ++i;
    }
  }

  double force(double m) const {
    double sum = 0, slips_to = x_.back();
    for (const auto& [begin, end, bound] : zones(m)) {
      const double length = end - begin;
      if (end < slips_to) sum += integral(slips_to) - integral(end);
      sum += length * (bound + m * length / 2);
      slips_to = begin;
    }
    return sum + integral(slips_to);
  }

  double traction(double m, const std::vector<StuckSprings>& zones, double x) const {
    for (const auto& [begin, end, bound] : zones) {
      if (x >= begin && x <= end) return bound + m * (end - x);
    }
    return at(x);
  }

  /// g', by differences of a smooth bound  [N/mm^3]
  double slope(double x) const {
    const double a = half_width_of(bound_);
    if (!smooth()) {
      const auto next = std::ranges::upper_bound(x_, x);
      if (next == x_.begin() || next == x_.end()) return 0;
      const auto i = static_cast<std::size_t>(next - x_.begin());
      return (value_[i] - value_[i - 1]) / (x_[i] - x_[i - 1]);
    }
    constexpr double step = 1e-5;  // of the angle
    const double angle = std::acos(std::clamp(-x / a, -1.0, 1.0));
    const double ahead = -a * std::cos(angle + step), behind = -a * std::cos(angle - step);
    return ahead > behind ? (at(ahead) - at(behind)) / (ahead - behind) : 0;
  }

 private:
  void add(double x, double value) {
    if (!x_.empty() && x <= x_.back()) {  // an edge and a row coincide
      if (x_.size() == 1) value_.back() = value;
      return;
    }
    x_.push_back(x);
    value_.push_back(value);
  }

  bool smooth() const { return !std::holds_alternative<TabulatedBound>(bound_); }

  double integral(double x) const {
    return std::visit([&](const auto& g) { return g.integral(x); }, bound_);
  }

  /// Where g + m x falls below a level, between the places i - 1 and i.
  double crossing(double m, double level, std::size_t i) const {
    const double low = x_[i - 1], high = x_[i];
    const double below = value_[i - 1] + m * low - level, above = value_[i] + m * high - level;
    if (above <= 0) return high;
    if (!smooth()) return low + (high - low) * below / (below - above);
    std::uintmax_t most = 60;
    const auto f = [&](double x) { return at(x) + m * x - level; };
    const auto found = boost::math::tools::toms748_solve(
        f, low, high, below, above, boost::math::tools::eps_tolerance<double>(52), most);
    return (found.first + found.second) / 2;
  }

  /// The place of the least g + m x next to place i.
  double lowest(double m, std::size_t i) const {
    if (!smooth()) return x_[i];
    std::uintmax_t most = 60;
    const auto f = [&](double x) { return at(x) + m * x; };
    return boost::math::tools::brent_find_minima(f, x_[i - 1], x_[std::min(i + 1, x_.size() - 1)],
                                                 26, most)
        .first;
  }

  const TractionBound& bound_;
  std::vector<double> x_, value_;
};

/// The growth m under which the springs carry a force.
double growth_under(const RollingBrush& brush, double force, double half_width) {
  namespace tools = boost::math::tools;
  const auto excess = [&](double growth) { return std::log(brush.force(growth) / force); };
  constexpr double factor = 4;
  std::uintmax_t most = 200;
  try {
    const auto found =
        tools::bracket_and_solve_root(excess, force / (2 * half_width * half_width), factor, true,
                                      tools::eps_tolerance<double>(52), most);
    return (found.first + found.second) / 2;
  } catch (const boost::math::evaluation_error&) {
    throw NotConverged("steady rolling: no creepage carries the force", 0, 1);
  }
}

}  // namespace

SteadySolution solve_brush(const SteadyProblem& problem) {
  const double compliance = problem.contact.kernel.layer_compliance();
  const double a = half_width_of(problem.contact.bound);
  const double full_sliding = full_sliding_force(problem.contact.bound);
  const Prescribed load(problem.load);
  require_below_full_sliding(load, full_sliding);
  const auto [by_force, value] = load;
  const RollingBrush brush(problem.contact.bound);
  const double growth = value == 0 ? 0
                        : by_force ? growth_under(brush, std::abs(value), a)
                                   : std::abs(value) / compliance;
  const double direction = load.direction();
  const double creepage = by_force ? direction * compliance * growth : value;
  const double force = by_force ? value : -direction * brush.force(growth);
  const std::vector<StuckSprings> zones =
      value == 0 ? std::vector<StuckSprings>{{-a, a, 0}} : brush.zones(growth);

  const VectorXd x = problem.grid.nodes();
  const auto sticks = [&](double at) {
    return std::ranges::any_of(zones, [&](const auto& z) { return at >= z.begin && at <= z.end; });
  };
  SteadySolution found{
      .x = x,
      .bound = bound_at(problem.contact.bound, x),
      .traction =
          x.unaryExpr([&](double at) { return -direction * brush.traction(growth, zones, at); }),
      .slip = x.unaryExpr([&](double at) {
        return sticks(at) ? 0 : direction * compliance * (growth + brush.slope(at));
      }),
      .displacement = {},
      .zones = {},
      .force = force,
      .creepage = creepage,
      .dissipation = -creepage * force,
      .iterations = 0,
      .evidence = {.dissipated = std::abs(creepage * force),
                   .load = std::abs(force),
                   .power = std::abs(creepage * force),
                   .full_sliding = full_sliding},
      .condition = 1,
      .scheme = SteadyScheme::closed_form};
  found.displacement = compliance * found.traction;
  if (zones.size() == 1) found.stick_edge = zones.front().begin;
  if (zones.empty()) found.stick_edge = a;
  const Zone slipping = direction < 0 ? Zone::slip_positive : Zone::slip_negative;
  for (const double at : x) found.zones.push_back(sticks(at) ? Zone::adhesion : slipping);
  return found;
}

}  // namespace microslip
