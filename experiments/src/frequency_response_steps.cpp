// SPDX-License-Identifier: GPL-3.0-or-later
#include "frequency_response_steps.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "campaign.hpp"
#include "microslip/reference/small_motion.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/interpolation.hpp"

namespace microslip::experiments::frequency_response_study {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr double farthest = 5;    // distance rolled, in half-widths
constexpr double delay = 2;       // distance to the peak, in half-widths
constexpr double next_to = 0.25;  // closer to the peak than this, errors are measured apart

/// The response to a step over its steady value, against the distance in half-widths.
struct Answer {
  std::vector<double> distance;
  std::vector<double> value;
};

/// Rolls after steps of a load so small that all but 1e-7 of the contact adheres.
class Motions {
 public:
  explicit Motions(const FrequencyResponseParameters& p) : p_(p), a_(p.bound.half_width()) {}

  double lambda() const { return std::log(2 * p_.plane.length() / a_); }

  /// Returns the force at the end of each step, after a step of the creepage.
  Answer after_creepage(const AdvectionEntry& entry, double c, Index n) const {
    const double creepage = tiny() * log_compliance() * pi * p_.bound.peak();
    const double steady = -creepage * a_ / log_compliance();
    const Rolled rolled = whole_steps(entry, c, n, 0, PrescribedCreepage{creepage});
    Answer answer;
    for (Index i = 1; i < rolled.distance.size(); ++i) {
      answer.distance.push_back(rolled.distance[i] / a_);
      answer.value.push_back(rolled.force[i] / steady);
    }
    return answer;
  }

  /// Returns the creepage after a step of the force: the mean over each element, at the element's
  /// middle.
  Answer after_force(const AdvectionEntry& entry, double c, Index n) const {
    const double force = -tiny() * full_sliding_force(p_.bound);
    const double steady = -force * log_compliance() / a_;
    const double dx = spacing(n);
    const Rolled rolled = whole_steps(entry, c, n, force, PrescribedForce{force});
    const VectorXd &q = rolled.distance, &creep = rolled.creep;
    Answer answer;
    for (Index i = 0; i < q.size(); ++i) {
      if (q[i] < (1 - 1e-6) * dx) continue;
      answer.distance.push_back((q[i] - dx / 2) / a_);
      answer.value.push_back((creep[i] - interpolated(q, creep, q[i] - dx)) / (dx * steady));
    }
    return answer;
  }

  double spacing(Index n) const { return 2 * a_ / static_cast<double>(n); }

 private:
  /// Rolls from a shift to the force on, as far as whole steps go.
  Rolled whole_steps(const AdvectionEntry& entry, double c, Index n, double force,
                     const Load& load) const {
    const CattaneoToCarter start{.kernel = p_.plane,
                                 .bound = p_.bound,
                                 .grid = Grid({.half_width = a_, .elements = n}),
                                 .basis = constant_basis(),
                                 .force = force};
    return roll(start, entry.scheme(1), c, std::floor(farthest * a_ / (c * spacing(n))) * c, load);
  }

  double tiny() const { return p_.adhesion_amplitude; }
  double log_compliance() const { return p_.plane.log_factor(); }

  const FrequencyResponseParameters& p_;
  double a_;
};

/// An expensive function that is asked for at the same places for each scheme.
class Tabulated {
 public:
  explicit Tabulated(std::function<double(double)> function) : function_(std::move(function)) {}

  double operator()(double x) {
    const auto [at, is_new] = values_.try_emplace(x);
    if (is_new) at->second = function_(x);
    return at->second;
  }

 private:
  std::function<double(double)> function_;
  std::map<double, double> values_;
};

/// Returns the mean of the exact creepage over a length about a distance next to the peak.
/// Integrals begin at the peak; the substitution q = peak + (to - peak) t^3 removes the logarithm
/// there.
double mean_of(Tabulated& creepage, double distance, double length) {
  const auto from_peak = [&](double to) {
    const auto at = [&](double t) {
      return creepage(delay + (to - delay) * t * t * t) * 3 * t * t;
    };
    if (std::abs(to - delay) < 1e-9) return 0.0;
    return (to - delay) * boost::math::quadrature::gauss<double, 10>::integrate(at, 0.0, 1.0);
  };
  return (from_peak(distance + length / 2) - from_peak(distance - length / 2)) / length;
}

/// Lists the places of a curve, ever closer to the peak.
std::vector<double> places_about_peak(int points) {
  std::vector<double> places;
  const auto add = [&](double far, int first, int last) {
    const int sign = first < last ? 1 : -1;
    for (int i = first; i != last + sign; i += sign) {
      const double part = 2.0 * i / points;
      places.push_back(delay + (far - delay) * std::pow(part, 4));
    }
  };
  add(0.01, points / 2, 1);
  add(farthest, 1, points / 2);
  return places;
}

/// Returns the index of the first value at a distance or beyond.
std::size_t index_at(const Answer& answer, double distance) {
  const auto found =
      std::lower_bound(answer.distance.begin(), answer.distance.end(), distance - 1e-9);
  return static_cast<std::size_t>(found - answer.distance.begin());
}

/// Returns the largest difference from the exact function at some distances that are not next to
/// the peak.
double largest_error(const Answer& answer, Tabulated& exact) {
  double error = 0;
  for (const double distance :
       {0.25, 0.5, 1.0, 1.5, delay - next_to, delay + next_to, 3.0, 4.0, 4.9}) {
    const std::size_t i = index_at(answer, distance);
    if (i == answer.distance.size()) continue;
    error = std::max(error, std::abs(answer.value[i] - exact(answer.distance[i])));
  }
  return error;
}

/// Returns the index of the largest value next to the peak.
std::size_t peak_of(const Answer& answer) {
  std::size_t peak = index_at(answer, delay - next_to);
  for (std::size_t i = peak; i < index_at(answer, delay + next_to); ++i) {
    if (answer.value[i] > answer.value[peak]) peak = i;
  }
  return peak;
}

}  // namespace

MotionTables motion_tables(const FrequencyResponseParameters& p, const Progress& progress) {
  MotionTables tables{
      .steps = {"steps",
                "force and creepage after a small step, from rest, over their steady values",
                {{"kind", "1",
                  "force: after a step of the creepage; creepage: after a step of the force"},
                 {"scheme", "1", "step.scheme, or exact; N as the largest of step_errors, c = 1"},
                 {"distance", "1", "rolled, in half-widths"},
                 {"value", "1", "over the steady one; of a creepage the mean over an element"}}},
      .errors = {
          "step_errors",
          "errors after a small step, from rest",
          {{"scheme", "1", "step.scheme"},
           {"step_ratio", "1", "c"},
           {"elements", "1", "N"},
           {"force_error", "1", "largest after a step of the creepage, over the steady force"},
           {"creepage_error", "1",
            "largest after a step of the force, over the steady creepage; at least a quarter of "
            "the half-width from the peak"},
           {"peak", "1", "largest mean of the creepage over an element next to q = 2 a"},
           {"exact_peak", "1", "mean of the exact creepage over that element"}}}};
  const Motions motions(p);
  Tabulated force([&](double q) { return force_after_creepage_step(q, motions.lambda()); });
  Tabulated creepage(creepage_after_force_step);
  for (int i = 1; i <= p.points; ++i) {
    const double q = farthest * i / p.points;
    tables.steps.add({"force", "exact", q, force(q)});
  }
  for (const double q : places_about_peak(p.points)) {
    tables.steps.add({"creepage", "exact", q, creepage(q)});
  }
  const auto show = [&](const char* kind, const AdvectionEntry& entry, const Answer& answer) {
    for (std::size_t i = 0; i < answer.distance.size(); ++i) {
      tables.steps.add({kind, std::string(entry.name), answer.distance[i], answer.value[i]});
    }
  };
  const auto solve = [&](const AdvectionEntry& entry, double c, Index n) {
    const Answer forces = motions.after_creepage(entry, c, n);
    const Answer creepages = motions.after_force(entry, c, n);
    const std::size_t peak = peak_of(creepages);
    const double dx = motions.spacing(n) / p.bound.half_width();
    tables.errors.add({std::string(entry.name), c, n, largest_error(forces, force),
                       largest_error(creepages, creepage), creepages.value[peak],
                       mean_of(creepage, creepages.distance[peak], dx)});
    if (c != 1 || n != p.motion_sizes.back()) return;
    show("force", entry, forces);
    show("creepage", entry, creepages);
  };
  std::size_t done = 0;
  for (const AdvectionEntry& entry : advection_schemes()) {
    for (const double c : p.step_ratios) {
      Runs runs({.operations = p.operations});
      for (const Index n : p.motion_sizes) {
        progress(++done, advection_schemes().size() * p.step_ratios.size() * p.motion_sizes.size());
        if (!entry.safe_steps.holds(c)) continue;
        const Attempt attempt = runs.run(static_cast<double>(n), [&] { solve(entry, c, n); });
        if (attempt.status == Status::ok) continue;
        tables.errors.add(
            {std::string(entry.name), c, n, not_given, not_given, not_given, not_given});
      }
    }
  }
  return tables;
}

}  // namespace microslip::experiments::frequency_response_study
