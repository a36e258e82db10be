// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/creepage_noise.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "microslip/experiments/cut_elements.hpp"

namespace microslip::experiments {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Steps before those that are measured are at least this long  [dx]
constexpr double approach = 0.1;

/// Steps that end this close to a distance have reached it  [dx]
constexpr double rounding = 1e-6;

AdvectionScheme scheme_of(const std::string& treatment) {
  if (treatment == "at_node") return MaterialFixed{MovingBound::at_node};
  if (treatment == "cell_mean") return MaterialFixed{MovingBound::cell_mean};
  if (treatment == "direct") return Direct{};
  throw std::logic_error("no such treatment: " + treatment);
}

/// Generalised zeta function at s = -1/2: what is left of the sum of sqrt(k + t), k >= 0, when its
/// integral is taken off. Euler-Maclaurin, to 1e-8.
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

double mean_of(const std::vector<double>& values, std::size_t begin, std::size_t end) {
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i) sum += values[i];
  return sum / static_cast<double>(end - begin);
}

/// \param creepages  of the last steps, at least two elements' travel
Noise noise_of(const std::vector<double>& creepages, double step_ratio) {
  const int steps = steps_per_element(step_ratio);
  const auto window = static_cast<std::size_t>(steps);
  const std::size_t end = creepages.size();
  const double mean = mean_of(creepages, end - window, end);
  const double change = mean - mean_of(creepages, end - 2 * window, end - window);
  double raw = 0, steady = 0;
  for (std::size_t i = 0; i < window; ++i) {
    const double difference = creepages[end - window + i] - mean;
    const double place = (static_cast<double>(i) + 0.5) / steps - 0.5;
    raw += std::pow(difference, 2) / steps;
    steady += std::pow(difference - change * place, 2) / steps;
  }
  return {.steps = steps,
          .mean = mean,
          .deviation = std::sqrt(raw) / std::abs(mean),
          .drift = change / mean,
          .noise = std::sqrt(steady) / std::abs(mean),
          .adhesion = 0};
}

/// \param step  makes a step of the given ratio and returns its creepage
std::vector<double> last_creepages(double distance, double step_ratio,
                                   const std::function<double(double)>& step) {
  const double long_step = std::max(step_ratio, approach);
  const double measured = 2 * steps_per_element(step_ratio) * step_ratio;
  double rolled = 0;
  while (rolled + measured < distance - rounding) {
    const double length = std::min(long_step, distance - measured - rolled);
    step(length);
    rolled += length;
  }
  std::vector<double> creepages;
  for (int k = 0; k < 2 * steps_per_element(step_ratio); ++k) creepages.push_back(step(step_ratio));
  return creepages;
}

}  // namespace

Noise creepage_noise(const CattaneoToCarter& rolling, const std::string& treatment, double distance,
                     double step_ratio) {
  const auto elements = static_cast<double>(rolling.grid.size());
  Noise noise;
  if (treatment == "cut") {
    CutElementRolling contact(rolling, EdgeElements::cut, elements);
    noise = noise_of(last_creepages(distance, step_ratio,
                                    [&](double length) {
                                      contact.step(length);
                                      return contact.creepage();
                                    }),
                     step_ratio);
    const auto& zones = contact.zones();
    noise.adhesion = static_cast<double>(std::count(zones.begin(), zones.end(), Zone::adhesion));
  } else {
    TransientRolling contact(rolling.problem(scheme_of(treatment)), CattaneoShift{rolling.force});
    noise = noise_of(last_creepages(distance, step_ratio,
                                    [&](double length) {
                                      contact.step(length * rolling.grid.spacing(),
                                                   PrescribedForce{rolling.force});
                                      return contact.state().creepage;
                                    }),
                     step_ratio);
    noise.adhesion = static_cast<double>(contact.state().adhesion_elements);
  }
  noise.adhesion /= elements;
  return noise;
}

double predicted_noise(const CattaneoToCarter& rolling, const Noise& measured, double distance,
                       double step_ratio) {
  const double a = rolling.bound.half_width();
  const double dx = rolling.grid.spacing();
  // Displacement at a distance from a rigid strip that carries a unit force, relative to the strip.
  const double yielding = compliance(material_of(rolling.kernel)) / std::numbers::pi *
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
  if (treatment != "cut") {
    return rolling.rolled(scheme_of(treatment), step_ratio, elements).state().traction.tail(n);
  }
  CutElementRolling contact(rolling, EdgeElements::cut, static_cast<double>(n));
  while (contact.distance() < elements - rounding) {
    contact.step(std::min(step_ratio, elements - contact.distance()));
  }
  return contact.traction();
}

}  // namespace microslip::experiments
