// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/creepage_noise.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "microslip/experiments/cut_elements.hpp"

namespace microslip::experiments {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Steps before the measured ones are at least this long  [dx]
constexpr double approach = 0.1;

/// Steps that end this close to a distance have reached it  [dx]
constexpr double rounding = 1e-6;

EdgeElements treatment_of(const std::string& name) {
  if (name == "at_node") return EdgeElements::at_node;
  if (name == "cell_mean") return EdgeElements::cell_mean;
  if (name == "cut") return EdgeElements::cut;
  throw std::logic_error("no such treatment: " + name);
}

/// Evaluates the generalised zeta function at s = -1/2 to 1e-8, by Euler-Maclaurin: the sum of
/// sqrt(k + t), k >= 0, without the integral that makes the sum diverge.
double zeta(double t) {
  constexpr int terms = 40;
  double sum = 0;
  for (int k = 0; k < terms; ++k) sum += std::sqrt(k + t);
  const double end = terms + t;
  return sum - 2.0 / 3 * end * std::sqrt(end) + std::sqrt(end) / 2 - 1 / (24 * std::sqrt(end));
}

int steps_per_element(double step_ratio) {
  return static_cast<int>(std::ceil(1 / step_ratio - rounding));
}

using Creepages = Eigen::Ref<const VectorXd>;

/// Returns the standard deviation over the mean.
double deviation_of(const Creepages& w) {
  return std::sqrt((w.array() - w.mean()).square().mean()) / std::abs(w.mean());
}

/// Measures the noise of the last `steps` creepages.
/// \param creepages  of the last steps; they cover the travel of two elements or more
Noise noise_of(const VectorXd& creepages, int steps) {
  const VectorXd last = creepages.tail(steps);
  const double mean = last.mean();
  const double drift = mean - creepages.tail(2 * steps).head(steps).mean();
  const VectorXd place = VectorXd::NullaryExpr(
      steps, [&](Index i) { return (static_cast<double>(i) + 0.5) / steps - 0.5; });
  double largest = 0;
  for (Index i = 0; i + steps <= creepages.size(); ++i) {
    largest = std::max(largest, deviation_of(creepages.segment(i, steps)));
  }
  return {.steps = steps,
          .mean = mean,
          .deviation = deviation_of(last),
          .largest = largest,
          .drift = drift / mean,
          .noise = deviation_of(last - drift * place),
          .adhesion = 0};
}

/// Rolls a distance, and measures the noise of the last steps.
/// \param step  makes a step of the given ratio and returns its creepage
Noise roll(double distance, double step_ratio, const std::function<double(double)>& step) {
  const int steps = steps_per_element(step_ratio);
  const double travel = steps * step_ratio;
  const int travels = std::clamp(static_cast<int>(distance / travel + rounding), 2, 4);
  const double before = distance - travels * travel;
  for (double rolled = 0; rolled < before - rounding;) {
    const double length = std::min(std::max(step_ratio, approach), before - rolled);
    step(length);
    rolled += length;
  }
  VectorXd creepages(travels * steps);
  for (double& creepage : creepages) creepage = step(step_ratio);
  return noise_of(creepages, steps);
}

}  // namespace

Noise creepage_noise(const CattaneoToCarter& rolling, const std::string& treatment, double distance,
                     double step_ratio) {
  const auto elements = static_cast<double>(rolling.grid.size());
  Noise noise;
  if (treatment != "direct") {
    CutElementRolling contact(rolling, treatment_of(treatment), elements);
    noise = roll(distance, step_ratio, [&](double length) {
      contact.step(length);
      return contact.creepage();
    });
    const auto& zones = contact.zones();
    noise.adhesion = static_cast<double>(std::count(zones.begin(), zones.end(), Zone::adhesion));
  } else {
    TransientRolling contact(rolling.problem(Direct{}), CattaneoShift{rolling.force});
    noise = roll(distance, step_ratio, [&](double length) {
      contact.step(length * rolling.grid.spacing(), PrescribedForce{rolling.force});
      return contact.state().creepage;
    });
    noise.adhesion = static_cast<double>(contact.state().adhesion_elements);
  }
  noise.adhesion /= elements;
  return noise;
}

double predicted_noise(const CattaneoToCarter& rolling, const Noise& measured, double distance,
                       double step_ratio) {
  const double a = rolling.bound.half_width();
  const double dx = rolling.grid.spacing();
  // A rigid strip carries a unit force: the displacement at a distance, relative to the strip.
  const double yielding = compliance(rolling.kernel.material()) / std::numbers::pi *
                          std::acosh((2 - measured.adhesion) / measured.adhesion);
  const double force = std::sqrt(2 / a) * rolling.bound.peak() * dx * std::sqrt(dx);
  const auto excess = [&](double q) {
    const double t = 0.5 - q;
    return force * zeta(std::max(0.0, t - std::floor(t + rounding)));
  };
  double square = 0, sum = 0;
  for (int k = 0; k < measured.steps; ++k) {
    const double q = distance - k * step_ratio;
    const double creepage =
        yielding * (excess(q) - excess(q - step_ratio)) / (step_ratio * dx * measured.mean);
    sum += creepage / measured.steps;
    square += creepage * creepage / measured.steps;
  }
  return std::sqrt(std::max(0.0, square - sum * sum));
}

VectorXd rolled_traction(const CattaneoToCarter& rolling, const std::string& treatment,
                         Index distance, double step_ratio) {
  const Index n = rolling.grid.size();
  const auto elements = static_cast<double>(distance);
  if (treatment == "direct") return rolling.rolled(Direct{}, step_ratio, elements).state().traction;
  CutElementRolling contact(rolling, treatment_of(treatment), static_cast<double>(n));
  while (contact.distance() < elements - rounding) {
    contact.step(std::min(step_ratio, elements - contact.distance()));
  }
  return contact.traction().tail(n);
}

}  // namespace microslip::experiments
