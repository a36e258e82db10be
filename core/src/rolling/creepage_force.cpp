// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/creepage_force.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

/// Relative rounding error of a point of the curve.
constexpr double rounding_of_curve = 2e-15;

/// A load as a positive number that grows along the curve.
struct Target {
  bool force;
  double size;
  double direction;

  double reached_by(const CreepageForce& state) const {
    return force ? -state.force : state.creepage;
  }
};

Target target_of(const CreepageForceCurve& curve, const Load& load) {
  const Prescribed prescribed(load);
  require_below_full_sliding(prescribed, curve.full_sliding_force);
  return {prescribed.by_force, std::abs(prescribed.value), prescribed.direction() < 0 ? -1.0 : 1.0};
}

}  // namespace

LoadedState meet_load(const CreepageForceCurve& curve, const Load& load) {
  const Target target = target_of(curve, load);
  const double a = curve.half_width;
  int evaluations = 0;
  const auto excess = [&](double b) {
    ++evaluations;
    // A difference below the rounding error counts as zero; otherwise the search would halve it
    // again and again.
    const double difference = target.reached_by(curve.at(b)) - target.size;
    return std::abs(difference) <= rounding_of_curve * target.size ? 0 : difference;
  };
  if (!target.force && target.size >= curve.full_sliding_creepage) {
    return {{a, target.size, -curve.full_sliding_force}, 1, target.direction, 0};
  }
  const double least = -a * (1 - least_sliding);
  const double at_full_sliding =
      (target.force ? curve.full_sliding_force : curve.full_sliding_creepage) - target.size;
  const double at_least = excess(least);
  if (at_least >= 0) {
    const CreepageForce all = curve.at(least);
    const double reached = target.reached_by(all);
    const double scale = reached > 0 ? target.size / reached : 0;
    return {{least, scale * all.creepage, scale * all.force}, scale, target.direction, evaluations};
  }
  std::uintmax_t most = 60;
  const auto root =
      boost::math::tools::toms748_solve(excess, least, a, at_least, at_full_sliding,
                                        boost::math::tools::eps_tolerance<double>(51), most);
  const double b = (root.first + root.second) / 2;
  CreepageForce state = curve.at(b);
  const double residual =
      std::abs(target.reached_by(state) - target.size) / (at_full_sliding + target.size);
  if (!(residual < 1e-9)) {
    throw NotConverged("steady rolling: no stick zone carries the load", evaluations, residual);
  }
  // Next to full adhesion the curve has rounding errors, so the exact load is put in place of its
  // value.
  (target.force ? state.force : state.creepage) = target.force ? -target.size : target.size;
  return {state, 1, target.direction, evaluations};
}

}  // namespace microslip
