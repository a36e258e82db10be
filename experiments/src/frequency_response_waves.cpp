// SPDX-License-Identifier: GPL-3.0-or-later
#include "frequency_response_waves.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "campaign.hpp"
#include "microslip/reference/carter.hpp"
#include "microslip/rolling/frequency_response.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/convergence.hpp"
#include "table_values.hpp"

namespace microslip::experiments::frequency_response_study {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using std::numbers::pi;

/// A steady state, and the amplitude of the waves about it.
struct State {
  std::string kernel_name;
  Kernel kernel;
  double stick_ratio;  ///< as written into the table
  double creepage;
  double amplitude;  ///< of each wave
  double begin;      ///< of the stick zone, which ends at the leading edge  [mm]
};

/// The waves of the creepage. The creepage of a step from a to b is the mean over the step of the
/// state's creepage plus all waves, W exp(i (K q + phase)).
class Waves {
 public:
  Waves(const FrequencyResponseParameters& p, const State& state) : state_(state) {
    for (std::size_t j = 0; j < p.waves.size(); ++j) {
      numbers_.push_back(2 * pi * static_cast<double>(p.waves[j]) / p.period);
      phases_.push_back(2 * static_cast<double>(j * j));  // so that their crests do not meet
    }
  }

  std::size_t size() const { return numbers_.size(); }

  double mean(double a, double b) const {
    double sum = 0;
    for (std::size_t j = 0; j < size(); ++j) {
      sum += (std::sin(numbers_[j] * b + phases_[j]) - std::sin(numbers_[j] * a + phases_[j])) /
             numbers_[j];
    }
    return state_.creepage + state_.amplitude * sum / (b - a);
  }

  /// Returns the contribution of the force at q to dF/dw of wave j, over a whole period of `steps`.
  Complex part(std::size_t j, double force, double q, double steps) const {
    return 2 / steps * force / state_.amplitude * std::polar(1.0, -numbers_[j] * q - phases_[j]);
  }

 private:
  State state_;
  std::vector<double> numbers_;
  std::vector<double> phases_;
};

/// Measures dF/dw of each wave. The effect of the start decays as exp(-0.4 q/a) or faster. It is
/// rolled off over 40 half-widths in steps of an element and 15 half-widths in the given steps,
/// which leaves 2e-3 of the difference between both kinds of steps.
std::vector<Complex> measured_slopes(const FrequencyResponseParameters& p, const State& state,
                                     const AdvectionEntry& entry, double step_ratio, Index n) {
  const Grid grid({.half_width = p.bound.half_width(), .elements = n});
  TransientRolling rolling({.contact = {state.kernel, p.bound},
                            .grid = grid,
                            .basis = constant_basis(),
                            .scheme = entry.scheme(1)});
  const Waves waves(p, state);
  const double a = p.bound.half_width();
  // All steps of a run have one length, because a scheme computes new coefficients for another
  // length.
  const auto roll = [&](double from, double length, long steps, const auto& after) {
    for (long i = 0; i < steps; ++i) {
      const double q = from + static_cast<double>(i) * length;
      rolling.step(length, PrescribedCreepage{waves.mean(q, q + length)});
      after(q + length);
    }
  };
  const auto nothing = [](double) {};
  const long steps = std::lround(p.period / (step_ratio * grid.spacing()));
  const double length = p.period / static_cast<double>(steps);
  const long settling = std::lround(15 * a / length);
  const long first = std::lround(40 * a / grid.spacing());
  const double begin = -static_cast<double>(settling) * length;
  roll(begin - static_cast<double>(first) * grid.spacing(), grid.spacing(), first, nothing);
  roll(begin, length, settling, nothing);
  std::vector<Complex> slopes(waves.size());
  roll(0, length, steps, [&](double q) {
    for (std::size_t j = 0; j < slopes.size(); ++j) {
      slopes[j] += waves.part(j, rolling.state().force, q, static_cast<double>(steps));
    }
  });
  return slopes;
}

/// Sums over alignments for one wave.
struct WaveError {
  Complex ratio = 0;  ///< of dF/dw to its value at an infinite wavelength
  double squares = 0;
};

class Campaign {
 public:
  Campaign(const FrequencyResponseParameters& p, const Progress& progress)
      : p_(p),
        progress_(progress),
        tables_{.measured = {"measured",
                             "the force that answers small waves of the creepage, by each scheme",
                             {{"kernel", "1", "plane or strip"},
                              {"stick_ratio", "1", "a' of the state; 1 where everything adheres"},
                              {"scheme", "1", "step.scheme"},
                              {"step_ratio", "1", "c = dq/dx"},
                              {"elements", "1", "N"},
                              {"wavelength_ratio", "1", "L over the half-width"},
                              {"wavelength_elements", "1", "L over dx"},
                              {"size", "1",
                               "|H|, H = dF/dw over the exact one of an infinite "
                               "wavelength; mean of H over the alignments"},
                              {"phase", "rad", "argument of H"},
                              {"error", "1",
                               "of dF/dw, relative; root of the mean square over the alignments"},
                              {"status", "1", "ok, refused, no_solution or not_run"}}},
                .errors = {"errors",
                           "errors of dF/dw, root of the mean square over waves and alignments",
                           {{"kernel", "1", "plane or strip"},
                            {"stick_ratio", "1", "as in measured"},
                            {"scheme", "1", "step.scheme"},
                            {"step_ratio", "1", "c"},
                            {"elements", "1", "N"},
                            {"error", "1", "relative"}}},
                .orders = {"orders",
                           "these errors as powers of dx",
                           {{"kernel", "1", "plane or strip"},
                            {"stick_ratio", "1", "as in measured"},
                            {"scheme", "1", "step.scheme"},
                            {"step_ratio", "1", "c"},
                            {"order", "1", "fitted"}}}} {}

  WaveTables run() {
    const auto schemes = advection_schemes().size();
    total_ = schemes * p_.step_ratios.size() * (2 + p_.stick_ratios.size());
    for (const Kernel& kernel : {Kernel(p_.plane), Kernel(p_.strip)}) {
      const double amplitude = p_.adhesion_amplitude * sliding();
      const State state{.kernel_name = kernel_name(kernel),
                        .kernel = kernel,
                        .stick_ratio = all_adheres,
                        .creepage = 0,
                        .amplitude = amplitude / waves(),
                        .begin = -p_.bound.half_width()};
      for (const AdvectionEntry& entry : advection_schemes()) {
        for (const double c : p_.step_ratios) {
          sizes(entry, c, p_.sizes, [&](Index) { return std::vector<State>{state}; });
        }
      }
    }
    for (const double stick_ratio : p_.stick_ratios) {
      for (const AdvectionEntry& entry : advection_schemes()) {
        for (const double c : p_.step_ratios) {
          const std::vector<Index> few(p_.state_sizes.begin(), p_.state_sizes.begin() + 2);
          sizes(entry, c, c == 1 ? p_.state_sizes : few,
                [&](Index n) { return aligned(stick_ratio, n); });
        }
      }
    }
    return tables_;
  }

 private:
  static std::string kernel_name(const Kernel& kernel) {
    return kernel.is_plane() ? "plane" : "strip";
  }

  double sliding() const { return compliance(p_.plane.material()) * p_.bound.peak(); }
  double waves() const { return static_cast<double>(p_.waves.size()); }

  /// Lists states of about the given stick ratio, whose stick zones end at different positions
  /// within an element.
  std::vector<State> aligned(double stick_ratio, Index n) const {
    std::vector<State> states;
    for (const double moved : aligned_stick_ratios(stick_ratio, p_.alignments, n)) {
      const Carter carter = Carter::from_stick_ratio(p_.plane.material(), p_.bound, moved);
      states.push_back({.kernel_name = "plane",
                        .kernel = p_.plane,
                        .stick_ratio = stick_ratio,
                        .creepage = carter.creepage(),
                        .amplitude = p_.amplitude * carter.creepage() / waves(),
                        .begin = p_.bound.half_width() * (1 - 2 * carter.stick_ratio())});
    }
    return states;
  }

  template <class States>
  void sizes(const AdvectionEntry& entry, double c, const std::vector<Index>& all,
             const States& states_of) {
    Runs runs({.operations = p_.operations});
    std::vector<double> elements, errors;
    for (const Index n : all) {
      const std::vector<State> states = states_of(n);
      std::vector<WaveError> waves(p_.waves.size());
      const Attempt attempt = runs.run(static_cast<double>(n), [&] {
        for (const State& state : states) add(state, entry, c, n, waves);
      });
      const double mean_square = write(states, entry, c, n, waves, attempt.status);
      if (attempt.status != Status::ok) continue;
      elements.push_back(static_cast<double>(n));
      errors.push_back(std::sqrt(mean_square));
      tables_.errors.add({states.front().kernel_name, states.front().stick_ratio,
                          std::string(entry.name), c, elements.back(), errors.back()});
    }
    progress_(++done_, total_);
    if (elements.size() < 2) return;
    const State first = states_of(all.front()).front();
    tables_.orders.add({first.kernel_name, first.stick_ratio, std::string(entry.name), c,
                        fitted_order(elements, errors)});
  }

  void add(const State& state, const AdvectionEntry& entry, double c, Index n,
           std::vector<WaveError>& waves) const {
    const double shortest =
        p_.period / static_cast<double>(*std::max_element(p_.waves.begin(), p_.waves.end()));
    const FrequencyResponse exact(state.kernel, state.begin, p_.bound.half_width(), shortest);
    const std::vector<Complex> slopes = measured_slopes(p_, state, entry, c, n);
    for (std::size_t j = 0; j < waves.size(); ++j) {
      const double length = p_.period / static_cast<double>(p_.waves[j]);
      waves[j].ratio += slopes[j] / exact.steady_slope();
      waves[j].squares += std::norm(slopes[j] / exact.slope(length) - 1.0);
    }
  }

  /// \return the mean of the squared errors over waves and alignments
  double write(const std::vector<State>& states, const AdvectionEntry& entry, double c, Index n,
               const std::vector<WaveError>& waves, Status status) {
    const double count = static_cast<double>(states.size());
    const bool ok = status == Status::ok;
    double squares = 0;
    for (std::size_t j = 0; j < waves.size(); ++j) {
      const double length = p_.period / static_cast<double>(p_.waves[j]);
      const double spacing = 2 * p_.bound.half_width() / static_cast<double>(n);
      squares += waves[j].squares / count;
      tables_.measured.add({states.front().kernel_name, states.front().stick_ratio,
                            std::string(entry.name), c, n, length / p_.bound.half_width(),
                            length / spacing, ok ? std::abs(waves[j].ratio) / count : not_given,
                            ok ? std::arg(waves[j].ratio) : not_given,
                            ok ? std::sqrt(waves[j].squares / count) : not_given, name_of(status)});
    }
    return squares / static_cast<double>(waves.size());
  }

  const FrequencyResponseParameters& p_;
  const Progress& progress_;
  WaveTables tables_;
  std::size_t done_ = 0;
  std::size_t total_ = 0;
};

}  // namespace

WaveTables wave_tables(const FrequencyResponseParameters& p, const Progress& progress) {
  return Campaign(p, progress).run();
}

}  // namespace microslip::experiments::frequency_response_study
