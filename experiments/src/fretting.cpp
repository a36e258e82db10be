// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/fretting.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "campaign.hpp"
#include "fretting_run.hpp"
#include "microslip/experiments/claims.hpp"
#include "microslip/experiments/superposed_shift.hpp"
#include "microslip/reference/fretting_cycle.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/convergence.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "study_keys.hpp"

namespace microslip::experiments {

using Eigen::Index;
using namespace fretting_study;

namespace {

using Parameters = FrettingParameters;

/// Relative rounding of the energies of closed cycles, and of the change by L0.
constexpr double energy_rounding = 1e-10;
constexpr double length_rounding = 1e-9;

/// A slip zone of at least so many elements counts as resolved.
constexpr double resolved = 5;

TransientRolling at_rest(const Parameters& p, const TractionBound& bound, const std::string& scheme,
                         Index elements) {
  return TransientRolling({.contact = {PlaneKernel(p.material, p.length), bound},
                           .grid = Grid({.half_width = p.bound.half_width(), .elements = elements}),
                           .basis = constant_basis(),
                           .scheme = advection_scheme(scheme).scheme(1)});
}

/// A force that rises from nothing, and then goes back and forth once.
struct Cycle {
  double shift;        ///< until the force has risen, positive with the force  [mm]
  double dissipation;  ///< of the closed cycle  [N]
  double work;         ///< of the force over the closed cycle  [N]
};

Cycle cycle_of(TransientRolling rolling, double force) {
  const double shift = -rolling.shift(PrescribedForce{force}).distance;
  const Shift back = rolling.shift(PrescribedForce{-force});
  const Shift forth = rolling.shift(PrescribedForce{force});
  return {.shift = shift,
          .dissipation = back.dissipation + forth.dissipation,
          .work = back.work + forth.work};
}

Table loops_table(const Parameters& p) {
  Table table("loops", "force and displacement of cycles, Hertz's bound, remembered scheme",
              {{"amplitude", "1", "of the force, part of full sliding"},
               {"way", "1", "out from no tractions, back, forth"},
               {"elements", "1", "N"},
               {"force", "1", "part of full sliding"},
               {"displacement", "mm", "of the surface where it sticks: minus the rigid shift"},
               {"exact", "mm", "by Mindlin"},
               {"adhesion", "mm", "of a contact that sticks everywhere, k F ln(2 L0/a)"},
               {"error", "1", "difference over the displacement at the amplitude"}});
  const HertzBound bound = hertz_like(p.bound);
  const double sticking =
      compliance(p.material) / std::numbers::pi * std::log(2 * p.length / bound.half_width());
  const Index n = p.sizes.back();
  for (const double amplitude : p.forces) {
    const double most = amplitude * bound.total();
    const FrettingCycle cycle(p.material, bound, most);
    const double scale = -cycle.shift(most, p.length);
    TransientRolling rolling = at_rest(p, bound, "remembered", n);
    double displacement = 0;
    const auto go = [&](const char* way, double from, double to, const auto& exact) {
      for (int i = 0; i <= p.points; ++i) {
        const double force = i == p.points ? to : from + (to - from) * i / p.points;
        displacement -= rolling.shift(PrescribedForce{force}).distance;
        table.add({amplitude, way, n, force / bound.total(), displacement, exact(force),
                   sticking * force, (displacement - exact(force)) / scale});
      }
    };
    go("out", 0, most,
       [&](double f) { return Cattaneo(p.material, bound, f).displacement(p.length); });
    go("back", most, -most, [&](double f) { return -cycle.shift(f, p.length); });
    go("forth", -most, most, [&](double f) { return cycle.shift(-f, p.length); });
  }
  return table;
}

struct Errors {
  Table cycles, errors, orders;
};

double root_mean_square(std::span<const double> values) {
  double squares = 0;
  for (const double value : values) squares += value * value;
  return std::sqrt(squares / static_cast<double>(values.size()));
}

/// Exact shift and dissipation of each amplitude.
struct Exact {
  std::vector<double> shifts, dissipations;
};

Exact exact_of(const Parameters& p, bool hertz) {
  Exact exact;
  const SuperposedShift other(p.bound, compliance(p.material), p.length);
  for (const double amplitude : p.error_forces) {
    const double force = amplitude * p.bound.total();
    const FrettingCycle cycle(p.material, hertz_like(p.bound), force);
    exact.shifts.push_back(hertz ? -cycle.shift(force, p.length) : other.shift(force));
    exact.dissipations.push_back(hertz ? cycle.dissipation() : other.dissipation(force));
  }
  return exact;
}

Errors errors_of(const Parameters& p, const Progress& progress) {
  Errors tables{
      {"cycles",
       "cycles of the force, against Mindlin's and against superposition",
       {{"bound", "1", "hertz or polynomial"},
        {"scheme", "1", "direct or remembered"},
        {"elements", "1", "N"},
        {"amplitude", "1", "of the force, part of full sliding"},
        {"dissipation", "N", "of a closed cycle"},
        {"exact", "N", "the same"},
        {"dissipation_error", "1", "relative"},
        {"shift_error", "1", "of the shift to the first amplitude, relative"},
        {"imbalance", "1", "work less dissipation of a closed cycle, over the dissipation",
         energy_rounding}}},
      {"errors",
       "their root mean squares over the amplitudes",
       {{"bound", "1", "hertz or polynomial"},
        {"scheme", "1", "direct or remembered"},
        {"elements", "1", "N"},
        {"dissipation", "1", "relative error"},
        {"shift", "1", "relative error"}}},
      {"orders",
       "fitted to them",
       {{"bound", "1", "hertz or polynomial"},
        {"scheme", "1", "direct or remembered"},
        {"dissipation", "1", "order in the number of elements"},
        {"shift", "1", "likewise"}}}};
  std::size_t done = 0;
  for (const std::string bound : {"hertz", "polynomial"}) {
    const bool hertz = bound == "hertz";
    const TractionBound of = hertz ? TractionBound(hertz_like(p.bound)) : TractionBound(p.bound);
    const Exact exact = exact_of(p, hertz);
    for (const std::string scheme : {"direct", "remembered"}) {
      std::vector<double> sizes, lost, shifted;
      for (const Index n : p.sizes) {
        const TransientRolling start = at_rest(p, of, scheme, n);
        std::vector<double> lost_errors, shift_errors;
        for (std::size_t k = 0; k < p.error_forces.size(); ++k) {
          const Cycle cycle = cycle_of(start, p.error_forces[k] * p.bound.total());
          lost_errors.push_back(cycle.dissipation / exact.dissipations[k] - 1);
          shift_errors.push_back(cycle.shift / exact.shifts[k] - 1);
          tables.cycles.add({bound, scheme, n, p.error_forces[k], cycle.dissipation,
                             exact.dissipations[k], lost_errors.back(), shift_errors.back(),
                             cycle.work / cycle.dissipation - 1});
        }
        sizes.push_back(static_cast<double>(n));
        lost.push_back(root_mean_square(lost_errors));
        shifted.push_back(root_mean_square(shift_errors));
        tables.errors.add({bound, scheme, sizes.back(), lost.back(), shifted.back()});
        progress(++done, 4 * p.sizes.size());
      }
      tables.orders.add({bound, scheme, fitted_order(sizes, lost), fitted_order(sizes, shifted)});
    }
  }
  return tables;
}

Table curve_table(const Parameters& p) {
  Table table("curve", "dissipation of a cycle against the amplitude, Hertz's bound",
              {{"scheme", "1", "direct, remembered, or exact"},
               {"elements", "1", "N; nan if exact"},
               {"amplitude", "1", "of the force, part of full sliding"},
               {"slip_elements", "1", "exact length of a slip zone, in elements; nan if exact"},
               {"dissipation", "1",
                "of a closed cycle, over k times the square of full sliding, "
                "k = 2 (1 - nu)/(pi G)",
                1e-13},
               {"cubes", "1", "the same over a third of the cube of the amplitude", 1e-7}});
  const HertzBound bound = hertz_like(p.bound);
  const double unit = compliance(p.material) / std::numbers::pi * bound.total() * bound.total();
  const auto row = [&](const std::string& scheme, double n, double tau, double dissipation) {
    const double slip_zone = n / 2 * tau / (1 + std::sqrt(1 - tau));
    table.add({scheme, n, tau, slip_zone, dissipation / unit,
               dissipation / unit / (tau * tau * tau / 3)});
  };
  for (const double tau : p.all_forces) {
    row("exact", not_given, tau,
        FrettingCycle(p.material, bound, tau * bound.total()).dissipation());
  }
  for (const std::string scheme : {"direct", "remembered"}) {
    for (const Index n : p.sizes) {
      const TransientRolling start = at_rest(p, bound, scheme, n);
      for (const double tau : p.all_forces) {
        row(scheme, static_cast<double>(n), tau, cycle_of(start, tau * bound.total()).dissipation);
      }
    }
  }
  return table;
}

Table lengths_table(const Parameters& p) {
  Table table("lengths", "a cycle with other L0, half of full sliding, Hertz's bound",
              {{"scheme", "1", "direct or remembered"},
               {"length", "1", "L0 in half-widths"},
               {"shift", "mm", "to the amplitude, positive with the force"},
               {"dissipation", "N", "of a closed cycle"},
               {"difference", "1", "of the dissipation to its value at the first length, relative",
                length_rounding}});
  const HertzBound bound = hertz_like(p.bound);
  for (const std::string scheme : {"direct", "remembered"}) {
    double first = 0;
    for (const double length : p.lengths) {
      Parameters other = p;
      other.length = length * bound.half_width();
      const Cycle cycle =
          cycle_of(at_rest(other, bound, scheme, p.run_elements), bound.total() / 2);
      if (first == 0) first = cycle.dissipation;
      table.add({scheme, length, cycle.shift, cycle.dissipation, cycle.dissipation / first - 1});
    }
  }
  return table;
}

double largest(const Table& table, const std::string& column) {
  double most = 0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    most = std::max(most, std::abs(table.number(i, column)));
  }
  return most;
}

/// Returns the least amplitude whose slip zones have enough elements, and the ratio of its
/// dissipation to the exact dissipation.
std::array<double, 2> smallest_resolved(const Table& curve, double elements) {
  for (std::size_t i = 0; i < curve.rows(); ++i) {
    if (curve.at(i, "scheme") != Cell("remembered") || curve.number(i, "elements") != elements ||
        curve.number(i, "slip_elements") < resolved) {
      continue;
    }
    const double tau = curve.number(i, "amplitude");
    return {tau, curve.number(i, "cubes") /
                     curve.latest({{"scheme", "exact"}, {"amplitude", tau}}, "cubes")};
  }
  return {not_given, not_given};
}

Table claims_of(const Parameters& p, const Table& loops, const Errors& errors, const Table& curve,
                const Table& lengths, const Table& run) {
  const auto order = [&](const char* bound, const char* scheme, const char* column) {
    return errors.orders.latest({{"bound", bound}, {"scheme", scheme}}, column);
  };
  const auto n = static_cast<double>(p.sizes.back());
  const auto [tau, ratio] = smallest_resolved(curve, n);
  const double least = p.all_forces.front();
  const std::string finest = fmt::format("N = {}", p.sizes.back());
  const auto error = [&](const char* bound) {
    return errors.errors.latest({{"bound", bound}, {"scheme", "remembered"}, {"elements", n}},
                                "dissipation");
  };
  return claims_table(
      {{"loops of force and displacement agree with Mindlin's solution", "none", 0,
        largest(loops, "error"), "1", ours_if({within(2e-4, 0)}),
        "largest error over the displacement at the amplitude, remembered scheme, " + finest,
        "fretting_loops"},
       {"the shift is of second order by the remembered scheme", "none", 2,
        order("hertz", "remembered", "shift"), "1", ours_if({within(0.3, 2)}),
        "order of the root mean square over the amplitudes, Hertz's bound", "fretting_error"},
       {"the shift is of order 3/2 on the grid of the contact", "none", 1.5,
        order("hertz", "direct", "shift"), "1", ours_if({within(0.2, 1.5)}),
        "order of the root mean square over the amplitudes, direct scheme, Hertz's bound",
        "fretting_error"},
       {"a cycle loses 2 (1 - t) ln(1 - t) + 2 t - t^2", "none", 0, error("hertz"), "1",
        ours_if({within(1e-3, 0)}),
        "relative error, root mean square over the amplitudes, remembered, " + finest,
        "fretting_error"},
       {"the dissipation is of first order by the remembered scheme", "none", 1,
        order("hertz", "remembered", "dissipation"), "1", ours_if({within(0.3, 1)}),
        "order of the root mean square of the dissipation error, remembered scheme, Hertz's bound",
        "fretting_error"},
       {"the dissipation is of order 3/2 on the grid of the contact", "none", 1.5,
        order("hertz", "direct", "dissipation"), "1", ours_if({within(0.3, 1.5)}),
        "order of the root mean square of the dissipation error, direct scheme, Hertz's bound",
        "fretting_error"},
       {"any bound: superposition of two full slidings", "none", 0, error("polynomial"), "1",
        ours_if({within(1e-3, 0)}),
        "relative error of the dissipation, root mean square over the amplitudes, for an "
        "asymmetric bound that is not Hertz's",
        "fretting_error"},
       {"the loss of a small force grows as its cube", "none", 1, ratio, "1",
        ours_if({within_percent(5, 1)}),
        fmt::format("dissipation over the exact, a third of the cube of the amplitude, at {}, the "
                    "least with {} elements in a slip zone",
                    format_short(tau), format_short(resolved)),
        "fretting_dissipation"},
       {"slip zones that no element resolves lose nothing", "none", 0,
        curve.latest({{"scheme", "direct"}, {"elements", n}, {"amplitude", least}}, "cubes"), "1",
        ours_if({within(1e-7, 0)}),
        fmt::format(
            "dissipation over the exact at the least amplitude, {}, grid of the contact, {}",
            format_short(least), finest),
        "fretting_dissipation", 1e-7},
       {"L0 changes the shift, not the dissipation", "none", 0, largest(lengths, "difference"), "1",
        ours_if({within(length_rounding, 0)}), "largest relative difference", no_figure},
       {"a closed cycle loses the work of its force", "none", 0,
        largest(errors.cycles, "imbalance"), "1", ours_if({within(energy_rounding, 0)}),
        "largest relative difference", no_figure},
       {"standstill, rolling and standstill in one run balance energy", "none", 0,
        largest(run, "imbalance"), "1", ours_if({within(run_rounding, 0)}),
        "largest sum of all energies over the work done in all", "fretting_run"}});
}

}  // namespace

FrettingParameters read_fretting(Scene& scene) {
  using P = FrettingParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::sizes, "grid.sizes", "numbers N of nodes", range(8, 2000), two_or_more_rising},
       {&P::forces, "cycle.force_ratios", "amplitudes of the loops, over full sliding",
        inner_fraction, rising},
       {&P::points, "cycle.points", "of a loop, on each way", range(2, 1000)},
       {&P::error_forces, "cycle.error_force_ratios",
        "amplitudes over which errors are taken, over full sliding", inner_fraction, rising},
       {&P::all_forces, "cycle.all_force_ratios",
        "amplitudes of the curve of dissipation, over full sliding", inner_fraction, rising},
       {&P::lengths, "cycle.lengths", "L0, in half-widths", range(1, 1e9)},
       {&P::run_elements, "run.elements", "N of the run, and of other L0", range(8, 2000)},
       {&P::run_force, "run.force_ratio", "force under which the bodies roll, over full sliding",
        range_inside(-1, 1), Demand("not 0", [](double force) { return force != 0; })},
       {&P::run_swing, "run.swing", "amplitude about it at standstill, over full sliding",
        above_zero, "less than 1 together with the size of run.force_ratio"},
       {&P::run_distance, "run.elements_rolled", "distance rolled each time, in elements",
        range_above(0, 1e4)},
       {&P::run_step_ratio, "run.step_ratio", "c of the run", range(1e-3, 5)}});
  P p = keys.read({.material = read_material(scene),
                   .length = scene.number("kernel.length"),
                   .bound = read_polynomial_bound(scene)});
  require(p.length >= p.bound.half_width(), "kernel.length", p.length, [&] {
    return fmt::format("at least half_width = {} mm", format_short(p.bound.half_width()));
  });
  scene.demand("run.swing", p.run_swing, std::abs(p.run_force) + p.run_swing < 1);
  return p;
}

std::vector<Table> fretting(const FrettingParameters& p, const Progress& progress) {
  const Table loops = loops_table(p);
  const Errors errors = errors_of(p, progress);
  const Table curve = curve_table(p);
  const Table lengths = lengths_table(p);
  const Table run = run_table(p, at_rest(p, hertz_like(p.bound), "remembered", p.run_elements));
  return {loops, errors.cycles, errors.errors, errors.orders,
          curve, lengths,       run,           claims_of(p, loops, errors, curve, lengths, run)};
}

}  // namespace microslip::experiments
