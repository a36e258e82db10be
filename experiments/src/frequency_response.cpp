// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/frequency_response.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "frequency_response_steps.hpp"
#include "frequency_response_waves.hpp"
#include "microslip/experiments/claims.hpp"
#include "microslip/rolling/frequency_response.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "study_keys.hpp"
#include "table_values.hpp"

namespace microslip::experiments {

using namespace frequency_response_study;
using Complex = std::complex<double>;
using std::numbers::pi;

namespace {

Table curves_table(const FrequencyResponseParameters& p) {
  Table table("curves", "exact answers of the force to small waves of the creepage",
              {{"case", "1",
                "plane or strip: the half-space; winkler: a foundation of springs with the same "
                "steady slope"},
               {"stick_ratio", "1", "a' of the state; 1 where everything adheres"},
               {"wavelength_ratio", "1", "L over the half-width"},
               {"size", "1", "|H|, H = dF/dw over its value at an infinite wavelength"},
               {"phase", "rad", "argument of H; below zero, the force comes after the creepage"},
               {"from_winkler", "1", "|H - H of the foundation|", 1e-12}});
  const double a = p.bound.half_width();
  const auto add = [&](const char* name, double stick_ratio, const auto& response) {
    for (int i = 0; i < p.points; ++i) {
      const double length = log_spaced(p.shortest, p.longest, i, p.points);
      const Complex h = response(length);
      const Complex springs = winkler_response(2 * pi * stick_ratio * a / length);
      table.add({name, stick_ratio, length / a, std::abs(h), std::arg(h), std::abs(h - springs)});
    }
  };
  const auto of_zone = [&](const char* name, const Kernel& kernel, double stick_ratio) {
    const FrequencyResponse response(kernel, a * (1 - 2 * stick_ratio), a, 0.99 * p.shortest);
    add(name, stick_ratio,
        [&](double length) { return response.slope(length) / response.steady_slope(); });
  };
  of_zone("plane", p.plane, all_adheres);
  of_zone("strip", p.strip, all_adheres);
  add("winkler", all_adheres, [&](double length) { return winkler_response(2 * pi * a / length); });
  for (const double stick_ratio : p.stick_ratios) of_zone("plane", p.plane, stick_ratio);
  return table;
}

std::string text(const Table& table, std::size_t row, const char* column) {
  return std::get<std::string>(table.at(row, column));
}

Table claims_of(const FrequencyResponseParameters& p, const Table& curves, const WaveTables& waves,
                const MotionTables& motions) {
  const auto adhering = [](const char* scheme) {
    return Cells{{"scheme", scheme}, {"stick_ratio", all_adheres}};
  };
  const double order_about_states = extreme(waves.orders, "order", true, [&](std::size_t i) {
    return text(waves.orders, i, "scheme") == "remembered" &&
           waves.orders.number(i, "step_ratio") == 1 &&
           waves.orders.number(i, "stick_ratio") != all_adheres;
  });
  const Cells half_space{{"case", "plane"}, {"stick_ratio", all_adheres}};
  const double elements = static_cast<double>(p.motion_sizes.back());
  const auto motion = [&](const char* scheme, const char* column) {
    return motions.errors.latest({{"scheme", scheme}, {"step_ratio", 1.0}, {"elements", elements}},
                                 column);
  };
  const double peak = motion("remembered", "peak") / motion("remembered", "exact_peak");
  return claims_table(
      {{"where everything adheres, the remembered scheme answers waves in second order, for any "
        "step",
        "none", 2, least(waves.orders, "order", adhering("remembered")), "1",
        ours_if({within(0.3, 2)}),
        "least order of the remembered scheme over kernels and step ratios",
        "frequency_response_errors"},
       {"where everything adheres, the scheme of the thesis answers waves in first order", "none",
        1, most(waves.orders, "order", adhering("direct")), "1", ours_if({within(0.3, 1)}),
        "largest order of the direct scheme over kernels and step ratios",
        "frequency_response_errors"},
       {"where the stick-slip point lies anywhere within an element, a state with slip answers in "
        "second order, too",
        "none", 2, order_about_states, "1", ours_if({above(1.7)}),
        "least order of the remembered scheme over states, c = 1", "frequency_response_errors"},
       {"a foundation of springs with the same steady slope, as in FASTSIM, has another frequency "
        "response",
        "none", not_given, most(curves, "from_winkler", half_space), "1", ours_if({above(0.2)}),
        fmt::format("largest difference of H where everything adheres, L0 = {} a",
                    format_short(p.plane.length() / p.bound.half_width())),
        "frequency_response_nyquist"},
       {"after a step of the force the creepage has a peak where the first traction peak leaves "
        "the "
        "contact, and the remembered scheme has it",
        "none", 1, peak, "1", ours_if({within(0.05, 1)}),
        fmt::format("largest mean over an element next to q = 2 a, over the exact solution's "
                    "mean there, c = 1, N = {}",
                    p.motion_sizes.back()),
        "frequency_response_steps"}});
}

}  // namespace

Complex winkler_response(double kappa) {
  const Complex i(0, 1);
  if (kappa < 1e-3) return 1.0 - 2.0 / 3 * i * kappa - kappa * kappa / 3;
  return (1.0 - (1.0 - std::polar(1.0, -2 * kappa)) / (2.0 * i * kappa)) / (i * kappa);
}

FrequencyResponseParameters read_frequency_response(Scene& scene) {
  using P = FrequencyResponseParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::period, "waves.period", "in half-widths, in which all waves return", range(1, 1000)},
       {&P::waves, "waves.numbers", "of waves in the period, all at once", range(1, 64)},
       {&P::amplitude, "waves.amplitude", "of all together, over the creepage of the state",
        range(1e-6, 0.1)},
       {&P::adhesion_amplitude, "waves.adhesion",
        "the same over the creepage of full sliding, where all adheres", range(1e-10, 1e-3)},
       {&P::sizes, "adhesion.sizes", "numbers N of nodes where all adheres", range(3, 2000),
        two_or_more_rising},
       {&P::stick_ratios, "states.stick_ratios", "parts a' of the contact that stick",
        range(0.1, 0.99)},
       {&P::state_sizes, "states.sizes",
        "numbers N of nodes of these, with c = 1; the first two with other c", range(3, 2000),
        two_or_more_rising},
       {&P::alignments, "states.alignments", "of the stick-slip point in an element", range(1, 20)},
       {&P::step_ratios, "step.ratios", "c", range(0.01, 1), "the first is 1"},
       {&P::motion_sizes, "motion.sizes", "numbers N of nodes, for steps of creepage and force",
        range(3, 2000), two_or_more_rising},
       {&P::shortest, "curve.shortest", "shortest wavelength over the half-width",
        range(0.05, 100)},
       {&P::longest, "curve.longest", "longest wavelength over the half-width", range(0.06, 1e6),
        "more than curve.shortest"},
       {&P::points, "curve.points", "wavelengths of a curve", range(2, 10000)},
       {&P::operations, "limit.operations",
        "of a run; one that is expected to take more is left out", range(1e6, 1e15)}});
  const Material material = read_material(scene);
  const HertzBound bound = read_hertz_bound(scene);
  const PlaneKernel plane(material, scene.number("kernel.length"));
  require(plane.length() >= 0.62 * bound.half_width(), "kernel.length", plane.length(),
          "at least 0.62 half-widths of the contact");
  const StripKernel strip(material, scene.number("kernel.width"));
  P p = keys.read({.bound = bound, .plane = plane, .strip = strip});
  scene.demand("step.ratios", p.step_ratios.front(), p.step_ratios.front() == 1);
  scene.demand("curve.longest", p.longest, p.longest > p.shortest);
  for (double* length : {&p.period, &p.shortest, &p.longest}) *length *= bound.half_width();
  return p;
}

std::vector<Table> frequency_response(const FrequencyResponseParameters& p,
                                      const Progress& progress) {
  const Table curves = curves_table(p);
  const WaveTables waves = wave_tables(p, progress);
  const MotionTables motions = motion_tables(p, progress);
  return {curves,
          waves.measured,
          waves.errors,
          waves.orders,
          motions.steps,
          motions.errors,
          claims_of(p, curves, waves, motions)};
}

}  // namespace microslip::experiments
