// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/varying_load.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>

#include "microslip/experiments/bristle_contact.hpp"
#include "microslip/experiments/claims.hpp"
#include "microslip/reference/carter.hpp"
#include "microslip/reference/load_response.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/convergence.hpp"
#include "study_keys.hpp"
#include "table_values.hpp"

namespace microslip::experiments {

using Complex = std::complex<double>;
using Eigen::Index;
using std::numbers::pi;

namespace {

/// Distance after which contacts and bristles have settled; the effect of a change decays as
/// exp(-0.4 q/a).
constexpr double settling = 40;  ///< [half-widths]

constexpr int bristles_of_half_width = 400;

double creepage_of(const VaryingLoadParameters& p, double stick_ratio) {
  return Carter::from_stick_ratio(p.material, p.bound, stick_ratio).creepage();
}

double full_sliding(const VaryingLoadParameters& p) { return full_sliding_force(p.bound); }

/// Returns the force of Carter's solution under another load. Half-width and bound are proportional
/// to the root of the load.
double quasi_steady_force(const VaryingLoadParameters& p, double creepage, double load) {
  const double size = std::sqrt(load);
  const HertzBound bound(size * p.bound.half_width(), size * p.bound.peak());
  return Carter::from_creepage(p.material, bound, creepage).force();
}

double load_at(double amplitude, double wavelength, double q) {
  return 1 + amplitude * std::sin(2 * pi * q / wavelength);
}

TransientRolling settled(const VaryingLoadParameters& p, double creepage, Index n) {
  const double a = p.bound.half_width();
  TransientRolling rolling({.contact = {PlaneKernel(p.material, p.length), p.bound},
                            .grid = Grid({.half_width = a, .elements = n}),
                            .basis = constant_basis(),
                            .scheme = Remembered{}});
  rolling.roll(settling * a, {2 * a / static_cast<double>(n)}, PrescribedCreepage{creepage},
               [](const TransientState&) {});
  return rolling;
}

/// Rolls waves of the load. Calls `after` along the last wave, with the distance from the wave's
/// beginning and the step as a fraction of the wave.
/// \param wavelength  [mm]
/// \param step        a wave has a whole number of steps of about this length  [mm]
void roll_waves(const VaryingLoadParameters& p, TransientRolling& rolling, double creepage,
                double wavelength, double amplitude, double step,
                const std::function<void(double q, double part)>& after) {
  const int steps = std::max(8, static_cast<int>(std::lround(wavelength / step)));
  const int waves = 1 + static_cast<int>(std::ceil(settling * p.bound.half_width() / wavelength));
  for (int i = 1; i <= waves * steps; ++i) {
    const double q = i * wavelength / steps;
    rolling.set_contact(hertz_scale(load_at(amplitude, wavelength, q)));
    rolling.step(wavelength / steps, PrescribedCreepage{creepage});
    if (i > (waves - 1) * steps) after(q - (waves - 1) * wavelength, 1.0 / steps);
  }
}

/// Measures dF/(mu dP). A settled wave of the other sign is the same wave half a wavelength later:
/// what is even in the amplitude has no part in the first harmonic.
Complex measured_response(const VaryingLoadParameters& p, const TransientRolling& steady,
                          double creepage, double wavelength, double step) {
  Complex sum = 0;
  TransientRolling rolling(steady);
  roll_waves(p, rolling, creepage, wavelength, p.amplitude, step, [&](double q, double part) {
    sum += part * rolling.state().force * std::polar(1.0, -2 * pi * q / wavelength);
  });
  return sum * Complex(0, 2) / p.amplitude / full_sliding(p);
}

/// Makes bristles with the steady slope of the half-space for small creepages.
Bristles bristles_of(const VaryingLoadParameters& p, double creepage) {
  const double k = compliance(p.material) / pi;
  return {p.bound, creepage, 2 * p.bound.half_width() * k};
}

/// Rolls bristles along a wave of the load, after preceding waves. The last force is at the end of
/// the wave.
std::vector<double> roll_bristles(const Bristles& bristles, double wavelength, double amplitude) {
  BristleContact contact(bristles, bristles_of_half_width);
  const int steps = std::max(1, static_cast<int>(std::lround(wavelength / contact.step())));
  const int waves = 1 + static_cast<int>(std::ceil(4 * bristles.bound.half_width() / wavelength));
  std::vector<double> forces;
  for (int i = 1; i <= waves * steps; ++i) {
    const double q = static_cast<double>(i % steps) / steps * wavelength;
    contact.roll(std::sqrt(load_at(amplitude, wavelength, q)));
    if (i > (waves - 1) * steps) forces.push_back(contact.force());
  }
  return forces;
}

Table curves_table(const VaryingLoadParameters& p) {
  Table table("curves", "the force that answers small waves of the normal load",
              {{"case", "1",
                "exact: linear theory of the half-space; quasi_steady: Carter's solution of each "
                "moment; springs: a foundation of springs"},
               {"stick_ratio", "1", "a'/a under the mean load"},
               {"wavelength_ratio", "1", "L over the half-width"},
               {"size", "1", "of dF/(mu dP)"},
               {"phase", "rad", "of -dF/(mu dP); below zero, the force comes after the load"}});
  const double a = p.bound.half_width();
  const auto add = [&](const char* name, double stick_ratio, const auto& response) {
    for (int i = 0; i < p.points; ++i) {
      const double ratio = log_spaced(p.shortest, p.longest, i, p.points);
      const Complex h = response(ratio);
      table.add({name, stick_ratio, ratio, std::abs(h), std::arg(-h)});
    }
  };
  for (const double stick_ratio : p.stick_ratios) {
    const Bristles bristles = bristles_of(p, creepage_of(p, stick_ratio));
    add("exact", stick_ratio, [&](double ratio) {
      return force_by_normal_load(2 * pi / ratio, stick_ratio, p.length / a);
    });
    add("quasi_steady", stick_ratio, [&](double) { return -(1 - stick_ratio); });
    add("springs", stick_ratio,
        [&](double ratio) { return bristles.force_by_normal_load(ratio * a); });
  }
  return table;
}

struct SmallWaves {
  Table measured;
  Table orders;
};

/// Carter's solution under the mean load, as the scheme computes it.
struct SteadyState {
  double stick_ratio;
  double creepage;
  TransientRolling rolling;
};

/// Lists states of about the given stick ratio, whose stick zones end at different positions within
/// an element.
std::vector<SteadyState> aligned(const VaryingLoadParameters& p, double stick_ratio, Index n) {
  std::vector<SteadyState> states;
  for (const double ratio : aligned_stick_ratios(stick_ratio, p.alignments, n)) {
    const double creepage = creepage_of(p, ratio);
    states.push_back({ratio, creepage, settled(p, creepage, n)});
  }
  return states;
}

struct Measured {
  Complex response;  ///< mean over the states
  double error;      ///< relative, root of the mean square
};

Measured measured(const VaryingLoadParameters& p, const std::vector<SteadyState>& states,
                  double wavelength, double step) {
  const double a = p.bound.half_width();
  const auto count = static_cast<double>(states.size());
  Measured all{};
  for (const SteadyState& state : states) {
    const Complex exact =
        force_by_normal_load(2 * pi * a / wavelength, state.stick_ratio, p.length / a);
    const Complex h = measured_response(p, state.rolling, state.creepage, wavelength, step);
    all.response += h / count;
    all.error += std::norm((h - exact) / exact) / count;
  }
  all.error = std::sqrt(all.error);
  return all;
}

SmallWaves small_waves(const VaryingLoadParameters& p, const Progress& progress) {
  SmallWaves tables{
      {"measured",
       "small waves of the normal load by the remembered scheme",
       {{"stick_ratio", "1", "a'/a under the mean load"},
        {"wavelength_ratio", "1", "L over the half-width"},
        {"step_ratio", "1", "c"},
        {"elements", "1", "N"},
        {"size", "1", "of dF/(mu dP), mean over the alignments"},
        {"phase", "rad", "of the same with the sign -"},
        {"error", "1", "of dF/(mu dP), relative, root of the mean square over the alignments",
         1e-5}}},
      {"orders",
       "of that error, fitted over all N",
       {{"stick_ratio", "1", "a'/a under the mean load"},
        {"wavelength_ratio", "1", "L over the half-width"},
        {"step_ratio", "1", "c"},
        {"order", "1", "fitted", 0.05}}}};
  const double a = p.bound.half_width();
  std::size_t done = 0;
  const std::size_t all = p.stick_ratios.size() * p.step_ratios.size() * p.wavelengths.size();
  for (const double stick_ratio : p.stick_ratios) {
    std::vector<std::vector<SteadyState>> states;
    for (const Index n : p.sizes) states.push_back(aligned(p, stick_ratio, n));
    for (const double step_ratio : p.step_ratios) {
      for (const double ratio : p.wavelengths) {
        std::vector<double> sizes, errors;
        for (std::size_t k = 0; k < p.sizes.size(); ++k) {
          const auto n = static_cast<double>(p.sizes[k]);
          const auto [h, error] = measured(p, states[k], ratio * a, step_ratio * 2 * a / n);
          sizes.push_back(n);
          errors.push_back(error);
          tables.measured.add(
              {stick_ratio, ratio, step_ratio, n, std::abs(h), std::arg(-h), error});
        }
        tables.orders.add({stick_ratio, ratio, step_ratio, fitted_order(sizes, errors)});
        progress(++done, all);
      }
    }
  }
  return tables;
}

struct LargeWaves {
  Table waves;
  Table means;
};

LargeWaves large_waves(const VaryingLoadParameters& p, const Progress& progress) {
  LargeWaves tables{
      {"waves",
       "the force along a large wave of the normal load",
       {{"wavelength_ratio", "1", "L over the half-width under the mean load"},
        {"part", "1", "of the wave that has been rolled"},
        {"load", "1", "P over its mean"},
        {"force", "1", "by the remembered scheme; forces are over mu P0"},
        {"quasi_steady", "1", "by Carter's solution of each moment"},
        {"springs", "1", "by a foundation of springs"}}},
      {"means",
       "means over a large wave; the mean energy lost is the creepage times the mean force",
       {{"wavelength_ratio", "1", "L over the half-width under the mean load"},
        {"force", "1",
         "by the remembered scheme, over the mean of Carter's solution of each moment"},
        {"springs", "1", "by a foundation of springs, likewise"},
        {"swing", "1", "largest less least force by the remembered scheme, likewise"},
        {"dissipation_error", "1",
         "of the energy lost over a wave as the steps have it, to creepage times mean force",
         1e-9}}}};
  const double a = p.bound.half_width();
  const double creepage = creepage_of(p, p.large_stick_ratio);
  const Index n = p.sizes.back();
  const TransientRolling steady = settled(p, creepage, n);
  const double step = 2 * a / static_cast<double>(n);
  const double unit = full_sliding(p);
  std::vector<double> ratios = p.shown;
  for (const double ratio : p.wavelengths) {
    if (std::ranges::find(ratios, ratio) == ratios.end()) ratios.push_back(ratio);
  }
  std::ranges::sort(ratios);
  std::size_t done = 0;
  for (const double ratio : ratios) {
    const bool shown = std::ranges::find(p.shown, ratio) != p.shown.end();
    const std::vector<double> springs =
        roll_bristles(bristles_of(p, creepage), ratio * a, p.large_amplitude);
    const auto count = static_cast<double>(springs.size());
    const double mean_of_springs = std::accumulate(springs.begin(), springs.end(), 0.0) / count;
    double sum = 0, quasi_steady = 0, lost = 0;
    double most = -std::numeric_limits<double>::infinity(), least = -most;
    double most_steady = most, least_steady = least;
    TransientRolling rolling(steady);
    roll_waves(
        p, rolling, creepage, ratio * a, p.large_amplitude, step, [&](double q, double part) {
          const TransientState& state = rolling.state();
          const double load = load_at(p.large_amplitude, ratio * a, q);
          const double moment = quasi_steady_force(p, creepage, load);
          sum += part * state.mean_force;
          lost += part * state.dissipation;
          quasi_steady += part * moment;
          most = std::max(most, state.force);
          least = std::min(least, state.force);
          most_steady = std::max(most_steady, moment);
          least_steady = std::min(least_steady, moment);
          if (!shown) return;
          const auto bristle = static_cast<std::size_t>(std::lround(q / (ratio * a) * count));
          tables.waves.add({ratio, q / (ratio * a), load, state.force / unit, moment / unit,
                            springs[std::max<std::size_t>(bristle, 1) - 1] / unit});
        });
    tables.means.add({ratio, sum / quasi_steady, mean_of_springs / quasi_steady,
                      (most - least) / (most_steady - least_steady),
                      std::abs(lost + creepage * sum) / std::abs(creepage * sum)});
    progress(++done, ratios.size());
  }
  return tables;
}

/// Returns the least order for waves of ten elements or more.
double least_order(const VaryingLoadParameters& p, const Table& orders) {
  return extreme(orders, "order", true, [&](std::size_t i) {
    return orders.number(i, "wavelength_ratio") * static_cast<double>(p.sizes.front()) >= 20;
  });
}

/// Returns the largest difference of the response from Carter's solution under the current load,
/// for wavelengths of at least so many half-widths.
double from_quasi_steady(const VaryingLoadParameters& p, double wavelength_ratio) {
  double largest = 0;
  for (const double stick_ratio : p.stick_ratios) {
    const Complex h = force_by_normal_load(2 * pi / wavelength_ratio, stick_ratio,
                                           p.length / p.bound.half_width());
    largest = std::max(largest, std::abs(h + (1 - stick_ratio)) / (1 - stick_ratio));
  }
  return largest;
}

Table claims_of(const VaryingLoadParameters& p, const SmallWaves& small, const LargeWaves& large) {
  const double finest =
      most(small.measured, "error", {{"elements", static_cast<double>(p.sizes.back())}});
  return claims_table(
      {{"the scheme answers small waves of the normal load in second order, for any step", "none",
        2, least_order(p, small.orders), "1", ours_if({above(1.7)}),
        "least order over states, step ratios and waves of ten elements or more",
        "varying_load_error"},
       {"it is at most a thousandth off the linear theory, down to waves of half a half-width",
        "none", not_given, finest, "1", ours_if({below(1e-3)}),
        "largest relative error over states, wavelengths and step ratios, at the largest N",
        "varying_load_error"},
       {"Carter's solution of each moment is not the force, even for waves of 10 contact "
        "widths",
        "none", not_given, from_quasi_steady(p, 20), "1", ours_if({above(0.1)}),
        "largest difference of dF/dP over states at L = 20 a, relative", "varying_load_bode"},
       {"short waves hardly swing the force", "none", not_given, large.means.number(0, "swing"),
        "1", ours_if({below(0.5)}),
        "swing of the force at the shortest wavelength, over the swing of Carter's solution of "
        "each moment",
        "varying_load_waves"},
       {"the energy lost over a wave is the creepage times the mean force", "none", 0,
        most(large.means, "dissipation_error", {}), "1", ours_if({below(1e-3)}),
        "largest relative difference over wavelengths", no_figure, 1e-9}});
}

}  // namespace

VaryingLoadParameters read_varying_load(Scene& scene) {
  using P = VaryingLoadParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::length, "kernel.length"},
       {&P::stick_ratios, "small.stick_ratios", "a'/a of Carter's solution under the mean load",
        range(0.05, 0.99)},
       {&P::wavelengths, "small.wavelengths", "of small waves over the half-width",
        range(0.2, 1000), rising},
       {&P::amplitude, "small.amplitude", "of small waves, over the mean load", range(1e-6, 0.1)},
       {&P::alignments, "small.alignments", "of the stick-slip point in an element", range(1, 20)},
       {&P::sizes, "grid.sizes", "numbers N of nodes", range(5, 2000), two_or_more_rising},
       {&P::step_ratios, "step.ratios", "c", range(0.01, 10)},
       {&P::large_amplitude, "large.amplitude", "of large waves, over the mean load",
        range(0.01, 0.99)},
       {&P::large_stick_ratio, "large.stick_ratio", "a'/a of the state about which large waves are",
        range(0.05, 0.99)},
       {&P::shown, "large.wavelengths", "of waves of which the force is shown, over the half-width",
        range(0.2, 1000), rising},
       {&P::shortest, "curve.shortest", "shortest wavelength over the half-width", range(0.2, 100)},
       {&P::longest, "curve.longest", "longest wavelength over the half-width", range(0.3, 1e4),
        "more than curve.shortest"},
       {&P::points, "curve.points", "wavelengths of a curve", range(2, 10000)}});
  P p = keys.read({.material = read_material(scene), .bound = read_hertz_bound(scene)});
  scene.demand("curve.longest", p.longest, p.longest > p.shortest);
  require_definite(PlaneKernel(p.material, p.length), 2 * p.bound.half_width());
  return p;
}

std::vector<Table> varying_load(const VaryingLoadParameters& p, const Progress& progress) {
  const Table curves = curves_table(p);
  const SmallWaves small = small_waves(p, progress);
  const LargeWaves large = large_waves(p, progress);
  return {curves,      small.measured, small.orders,
          large.waves, large.means,    claims_of(p, small, large)};
}

}  // namespace microslip::experiments
