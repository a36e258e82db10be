// SPDX-License-Identifier: GPL-3.0-or-later
#include "unlike_rolling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "unlike_zone_search.hpp"

namespace microslip {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

/// Elements that show the zones to begin with.
constexpr Index elements_to_begin = 401;

/// A solution over a contact in the units of a problem.
class UnlikeSolution {
 public:
  UnlikeSolution(const SteadyProblem& problem, UnlikeZones zones)
      : problem_(problem),
        zones_(std::move(zones)),
        a_(problem.grid.half_width()),
        peak_(std::get<HertzBound>(problem.contact.bound).peak()),
        strain_(compliance(problem.contact.kernel.material()) * peak_) {}

  SteadySolution sampled() const {
    const VectorXd x = problem_.grid.nodes();
    const Index n = x.size();
    const Evidence evidence = by_quadrature();
    SteadySolution state{.x = x,
                         .bound = bound_at(problem_.contact.bound, x),
                         .traction = VectorXd(n),
                         .slip = VectorXd(n),
                         .displacement = displacement(x),
                         .zones = {},
                         .force = peak_ * a_ * zones_.force(),
                         .creepage = strain_ * zones_.creepage(),
                         .dissipation = evidence.dissipated,
                         .iterations = 0,
                         .evidence = evidence,
                         .condition = 1,
                         .scheme = SteadyScheme::inversion};
    if (const auto* force = std::get_if<PrescribedForce>(&problem_.load)) {
      state.force = force->value;
    } else {
      state.creepage = std::get<PrescribedCreepage>(problem_.load).value;
    }
    for (Index i = 0; i < n; ++i) {
      const ZonePlace place = zones_.place_of(x[i] / a_);
      state.traction[i] = peak_ * zones_.traction(place);
      state.slip[i] = strain_ * zones_.slip(place);
      state.zones.push_back(zones_.pattern().zones[place.zone]);
    }
    return state;
  }

 private:
  /// Calls with places of a zone, and their weights in an integral over it.
  template <class Function>
  void over(std::size_t zone, const Function& function) const {
    constexpr int halvings = 8;
    ArrayXd angles, weights;
    graded_angles(halvings, halvings, 10, angles, weights);
    const double width = zones_.pattern().widths[zone];
    for (Index i = 0; i < angles.size(); ++i) {
      const double behind = std::sin(angles[i] / 2), ahead = std::sin((pi - angles[i]) / 2);
      function(ZonePlace{zone, width * behind * behind, width * ahead * ahead},
               weights[i] * width * behind * ahead);
    }
  }

  Evidence by_quadrature() const {
    Evidence evidence{.full_sliding = full_sliding_force(problem_.contact.bound)};
    const double length = peak_ * a_;
    for (std::size_t i = 0; i < zones_.pattern().size(); ++i) {
      over(i, [&](const ZonePlace& place, double weight) {
        const double p = zones_.traction(place);
        const double power = length * weight * strain_ * p * zones_.slip(place);
        evidence.load += length * weight * std::abs(p);
        evidence.excess += length * weight * std::max(0.0, std::abs(p) - zones_.bound(place));
        evidence.backward += std::max(0.0, power);
        evidence.dissipated -= power;
      });
    }
    evidence.power = evidence.dissipated;
    return evidence;
  }

  /// Returns the displacement at the leading edge, by the tractions as line loads.
  double displacement_at_edge() const {
    double sum = 0;
    for (std::size_t i = 0; i < zones_.pattern().size(); ++i) {
      over(i, [&](const ZonePlace& place, double weight) {
        const double away = a_ * (1 - zones_.x_of(place));
        sum += weight * zones_.traction(place) *
               std::log(away / *problem_.contact.kernel.plane_length());
      });
    }
    return -problem_.contact.kernel.log_factor() * peak_ * a_ * sum;
  }

  /// The integral of slip between two places, which are over the half-width.
  double slip_between(double from, double to) const {
    double begin = -1, sum = 0;
    for (std::size_t i = 0; i < zones_.pattern().size(); ++i) {
      const double width = zones_.pattern().widths[i];
      const double low = std::clamp(from - begin, 0.0, width);
      const double high = std::clamp(to - begin, 0.0, width);
      begin += width;
      if (zones_.pattern().sticks(i) || low >= high) continue;
      const auto angle = [&](double behind) { return 2 * std::asin(std::sqrt(behind / width)); };
      ArrayXd angles, weights;
      graded_angles(0, 0, 10, angles, weights);
      const double part = (angle(high) - angle(low)) / pi;
      for (Index k = 0; k < angles.size(); ++k) {
        const double at = angle(low) + part * angles[k];
        const double behind = std::sin(at / 2), ahead = std::cos(at / 2);
        sum += part * weights[k] * width * behind * ahead *
               zones_.slip({i, width * behind * behind, width * ahead * ahead});
      }
    }
    return sum;
  }

  /// Integrates the strain, which is the creepage minus the slip and the strain by the pressure.
  VectorXd displacement(const VectorXd& x) const {
    VectorXd u(x.size());
    const double w = strain_ * zones_.creepage();
    double at = displacement_at_edge(), from = a_;
    const auto pressed = [&](double place) {
      return problem_.contact.pressure_strain *
             std::get<HertzBound>(problem_.contact.bound).integral(place);
    };
    for (Index i = x.size() - 1; i >= 0; --i) {
      at -= w * (from - x[i]) - (pressed(from) - pressed(x[i])) -
            strain_ * a_ * slip_between(x[i] / a_, from / a_);
      u[i] = at;
      from = x[i];
    }
    return u;
  }

  const SteadyProblem& problem_;
  UnlikeZones zones_;
  double a_, peak_;
  double strain_;  ///< by the peak
};

}  // namespace

std::optional<SteadySolution> unlike_by_inversion(const SteadyProblem& problem) {
  const auto& bound = std::get<HertzBound>(problem.contact.bound);
  const double unit = compliance(problem.contact.kernel.material());
  ScaledLoad load{.force = std::nullopt, .ratio = problem.contact.pressure_strain / unit};
  if (const auto* force = std::get_if<PrescribedForce>(&problem.load)) {
    load.force = force->value / (bound.peak() * bound.half_width());
  }
  SteadyProblem by_elements = problem;
  by_elements.method = Calibrated{};
  by_elements.basis = constant_basis();
  by_elements.grid = Grid({.half_width = bound.half_width(), .elements = elements_to_begin});
  const SteadySolution first = solve_steady(by_elements);
  const double level = first.creepage / (unit * bound.peak()) - 2 / pi * load.ratio;
  const auto zones = find_zones(load, pattern_of(first, bound.half_width(), load.ratio), level);
  if (!zones) return std::nullopt;
  return UnlikeSolution(problem, *zones).sampled();
}

}  // namespace microslip
