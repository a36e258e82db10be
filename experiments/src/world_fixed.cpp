// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/world_fixed.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "microslip/experiments/claims.hpp"
#include "microslip/experiments/creepage_noise.hpp"
#include "microslip/experiments/cut_elements.hpp"
#include "microslip/support/convergence.hpp"
#include "microslip/support/format.hpp"
#include "study_keys.hpp"

namespace microslip::experiments {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Parameters = WorldFixedParameters;

/// The largest noise of the creepage that is wanted.
constexpr double target = 0.01;

struct Tables {
  Table creepage{"creepage",
                 "creepage step by step, in a contact that is longer than N elements by a part",
                 {{"treatment", "1", "of the elements at the edges"},
                  {"q", "dx", "distance rolled"},
                  {"creepage", "1", "w of the step"},
                  {"relative", "1", "w over its mean"},
                  {"change", "1", "of that from the step before"},
                  {"entered", "1", "elements that entered at the leading edge in the step"},
                  {"left", "1", "elements that left at the trailing edge"},
                  {"released", "1", "elements that began to slip"}}};
  Table events{"events",
               "what changes the creepage: its jumps in the steps of an event and the next",
               {{"treatment", "1", "of the elements at the edges"},
                {"event", "1", "left before released before entered, if they coincide, or none"},
                {"steps", "1", "number of them"},
                {"largest_change", "1", "of the relative creepage in a step"},
                {"share", "1", "of the sum of all squared changes"}}};
  Table noise{"noise",
              "noise of the creepage over one element's travel",
              {{"treatment", "1", "of the elements at the edges"},
               {"series", "1", "against elements or step_ratio"},
               {"elements", "1", "N"},
               {"step_ratio", "1", "c = dq/dx"},
               {"steps", "1", "steps measured, 1/c rounded up"},
               {"creepage", "1", "mean w"},
               {"deviation", "1", "standard deviation of w over its mean"},
               {"largest", "1", "largest deviation over an element's travel within the last four"},
               {"drift", "1", "change of the mean in an element's travel, over the mean"},
               {"noise", "1", "the deviation without the drift"},
               {"predicted", "1", "of at_node, from the force of the trailing element; else nan"}}};
  Table errors{"errors",
               "error of the traction against a finer grid",
               {{"treatment", "1", "of the elements at the edges"},
                {"step_ratio", "1", "c = dq/dx"},
                {"error", "N/mm", "integral of |p - reference|, means over elements"}}};
  Table orders{"orders",
               "order of decay of the noise in N, fitted",
               {{"treatment", "1", "of the elements at the edges"},
                {"elements", "1", "largest N of the fit"},
                {"deviation_order", "1", "order of the deviation"},
                {"noise_order", "1", "order of the noise, without the drift"},
                {"largest", "1", "largest one of the series against c"}}};
};

CattaneoToCarter on_grid(const CattaneoToCarter& rolling, Index elements) {
  CattaneoToCarter other = rolling;
  other.grid = Grid({.half_width = rolling.grid.half_width(), .elements = elements});
  return other;
}

/// Rounds the distance to a whole number of elements.
double distance_on(const Parameters& p, Index elements) {
  return std::round(p.distance * static_cast<double>(elements) / 2);
}

/// A step of the creepage shown.
struct Step {
  double q;
  double creepage;
  Index entered;
  Index left;
  Index released;
};

std::vector<Step> steps_of(const Parameters& p, EdgeElements treatment) {
  const auto elements = static_cast<double>(p.rolling.grid.size()) + p.part;
  CutElementRolling contact(p.rolling, treatment, elements);
  const double distance = distance_on(p, p.rolling.grid.size());
  const auto count = static_cast<int>(std::round(distance / p.step_ratio));
  std::vector<Step> steps;
  for (int k = 1; k <= count; ++k) {
    contact.step(p.step_ratio);
    steps.push_back({k * p.step_ratio, contact.creepage(), contact.entered(), contact.left(),
                     contact.released()});
  }
  return steps;
}

std::vector<Step> direct_steps(const Parameters& p) {
  TransientRolling contact(p.rolling.problem(Direct{}), CattaneoShift{p.rolling.force});
  const double dx = p.rolling.grid.spacing();
  std::vector<Step> steps;
  std::vector<Zone> before = contact.state().zones;
  contact.roll(distance_on(p, p.rolling.grid.size()) * dx, {p.step_ratio * dx},
               PrescribedForce{p.rolling.force}, [&](const TransientState& state) {
                 Index released = 0;
                 for (std::size_t i = 0; i < before.size(); ++i) {
                   released += before[i] == Zone::adhesion && state.zones[i] != Zone::adhesion;
                 }
                 before = state.zones;
                 steps.push_back({state.distance / dx, state.creepage, 0, 0, released});
               });
  return steps;
}

std::string event_of(const Step& before, const Step& now) {
  if (before.left + now.left > 0) return "left";
  if (before.released + now.released > 0) return "released";
  return before.entered + now.entered > 0 ? "entered" : "none";
}

void add_creepage(Tables& tables, const Parameters& p, const std::string& treatment,
                  const std::vector<Step>& steps) {
  const double end = steps.back().q;
  const auto is_shown = [&](const Step& step) { return step.q > end - p.shown - 1e-9; };
  double mean = 0;
  const auto first = std::find_if(steps.begin() + 1, steps.end(), is_shown);
  for (auto step = first; step != steps.end(); ++step) {
    mean += step->creepage / static_cast<double>(steps.end() - first);
  }
  struct Sum {
    double steps = 0, largest = 0, squares = 0;
  };
  std::map<std::string, Sum> sums;
  double squares = 0;
  for (auto step = first; step != steps.end(); ++step) {
    const double change = (step->creepage - (step - 1)->creepage) / mean;
    tables.creepage.add({treatment, step->q, step->creepage, step->creepage / mean, change,
                         step->entered, step->left, step->released});
    Sum& sum = sums[event_of(*(step - 1), *step)];
    ++sum.steps;
    sum.largest = std::max(sum.largest, std::abs(change));
    sum.squares += change * change;
    squares += change * change;
  }
  for (const auto& [event, sum] : sums) {
    tables.events.add({treatment, event, sum.steps, sum.largest, sum.squares / squares});
  }
}

Noise add_noise(Tables& tables, const Parameters& p, const std::string& treatment,
                const std::string& series, Index elements, double step_ratio) {
  const CattaneoToCarter rolling = on_grid(p.rolling, elements);
  const double distance = distance_on(p, elements);
  const Noise noise = creepage_noise(rolling, treatment, distance, step_ratio);
  const double predicted =
      treatment == "at_node" ? predicted_noise(rolling, noise, distance, step_ratio) : not_given;
  tables.noise.add({treatment, series, elements, step_ratio, noise.steps, noise.mean,
                    noise.deviation, noise.largest, noise.drift, noise.noise, predicted});
  return noise;
}

void add_errors(Tables& tables, const Parameters& p) {
  const Index n = p.rolling.grid.size();
  const CattaneoToCarter fine = on_grid(p.rolling, n * p.refinement);
  const VectorXd on_fine = rolled_traction(fine, "cell_mean", p.error_distance * p.refinement, 1);
  const VectorXd reference = VectorXd::NullaryExpr(
      n, [&](Index i) { return on_fine.segment(i * p.refinement, p.refinement).mean(); });
  for (const std::string treatment : treatments) {
    for (const double c : p.error_step_ratios) {
      const VectorXd traction = rolled_traction(p.rolling, treatment, p.error_distance, c);
      const double error = (traction - reference).lpNorm<1>() * p.rolling.grid.spacing();
      tables.errors.add({treatment, c, error});
    }
  }
}

double noise_at(const Tables& tables, const std::string& treatment, double step_ratio,
                const std::string& column = "deviation") {
  return tables.noise.latest(
      {{"treatment", treatment}, {"series", "step_ratio"}, {"step_ratio", step_ratio}}, column);
}

/// Returns the share of an event in the jumps of a treatment.
double share_of(const Tables& tables, const std::string& treatment, const std::string& event) {
  const double share = tables.events.latest({{"treatment", treatment}, {"event", event}}, "share");
  return std::isnan(share) ? 0 : share;
}

double rounded(double value) { return std::round(1e4 * value) / 1e4; }

Table claims_of(const Tables& tables, const Parameters& p) {
  const double c = p.noise_step_ratio;
  const std::string where = fmt::format("N = {}, c = {}", p.noise_elements, format_short(c));
  const double at_node = noise_at(tables, "at_node", c);
  const double direct = noise_at(tables, "direct", c);
  const double whole = noise_at(tables, "at_node", 1, "drift");
  const double direct_whole = noise_at(tables, "direct", 1, "drift");
  const double leaving = share_of(tables, "at_node", "left");
  const double mean = noise_at(tables, "cell_mean", c, "largest");
  const double cut = noise_at(tables, "cut", c, "largest");
  const double releasing = share_of(tables, "cell_mean", "released");
  return claims_table(
      {{"the world-fixed implementation shows odd behaviour", "9, 11", not_given, at_node, "1",
        holds_if({{"its ratio to the one of the direct scheme", at_node / direct, above(10)}}),
        fmt::format("noise of the creepage, nodes switched on and off, {}; direct scheme {}; the "
                    "thesis does not say what it saw",
                    where, format_short(rounded(direct))),
        "world_fixed_noise"},
       {"the odd behaviour appears in certain cases only", "9, 11", not_given, whole, "1",
        holds_if({{"its difference to the one of the direct scheme", whole - direct_whole,
                   within(1e-6, 0)},
                  {"the noise at c = " + format_short(c), at_node, above(target)}}),
        "relative change of the creepage from step to step at c = 1: the change by the direct "
        "scheme",
        "world_fixed_noise"},
       {"the cause of the odd behaviour is still unknown", "11", not_given, leaving, "1",
        corrected_if({above(0.9)}, "not_comparable"),
        "part of the squared jumps of the creepage where an element leaves at the trailing edge, "
        "and gives up its force at once",
        "world_fixed_creepage"},
       {"the odd behaviour stays unexplained if its supposed cause is removed", "11", not_given,
        std::max(mean, cut), "1", corrected_if({below(target)}, "not_comparable"),
        fmt::format("the largest noise of averaged bounds ({}) and cut elements ({}), {}; {} of "
                    "the jumps of the former where an element begins to slip",
                    format_short(rounded(mean)), format_short(rounded(cut)), where,
                    format_short(rounded(releasing))),
        "world_fixed_creepage"}});
}

}  // namespace

WorldFixedParameters read_world_fixed(Scene& scene) {
  using P = WorldFixedParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::step_ratio, "creepage.step_ratio", "c of the creepage shown", range(1e-3, 0.5)},
       {&P::shown, "creepage.elements_rolled", "end of the way that is shown, in elements",
        above_zero, "less than are rolled"},
       {&P::part, "creepage.part",
        "of an element by which the contact is longer, so that edges reach elements in turn",
        range_below(0, 1)},
       {&P::distance, "noise.distance", "rolled before, in half-widths", above_zero,
        "four elements or more, on every grid"},
       {&P::elements, "noise.sizes", "numbers N of nodes, for the noise against N",
        range(10, Grid::max_elements), two_or_more_rising},
       {&P::largest_cut, "noise.largest_cut",
        "largest N of elements that are cut, whose steps cost O(N^3)",
        range(10, Grid::max_elements), "at least the second of noise.sizes"},
       {&P::noise_step_ratio, "noise.step_ratio", "c of the noise against N", range(1e-3, 0.5)},
       {&P::noise_elements, "noise.elements", "N of the noise against c",
        range(10, Grid::max_elements)},
       {&P::step_ratios, "noise.step_ratios", "c of the noise against c", range(1e-3, 1),
        "1 and noise.step_ratio among them"},
       {&P::error_step_ratios, "error.step_ratios", "c of the errors", range(1e-3, 1)},
       {&P::error_distance, "error.elements_rolled",
        "distance before errors are measured, in elements", range(1, 1000000)},
       {&P::refinement, "error.refinement", "elements of the reference for each one",
        range(2, 1000)}});
  P p = keys.read({.rolling = read_cattaneo_to_carter(scene)});
  for (const double c : {1.0, p.noise_step_ratio}) {
    scene.demand("noise.step_ratios", c, std::ranges::count(p.step_ratios, c) > 0);
  }
  scene.demand("noise.largest_cut", static_cast<double>(p.largest_cut),
               p.largest_cut >= p.elements[1]);
  const Index fewest = std::min(p.elements.front(), p.noise_elements);
  scene.demand("noise.distance", p.distance, distance_on(p, fewest) >= 4);
  scene.demand("creepage.elements_rolled", p.shown,
               p.shown < distance_on(p, p.rolling.grid.size()));
  return p;
}

std::vector<Table> world_fixed(const Parameters& p, const Progress& progress) {
  Tables tables;
  add_creepage(tables, p, "at_node", steps_of(p, EdgeElements::at_node));
  add_creepage(tables, p, "cell_mean", steps_of(p, EdgeElements::cell_mean));
  add_creepage(tables, p, "cut", steps_of(p, EdgeElements::cut));
  add_creepage(tables, p, "direct", direct_steps(p));
  const std::size_t total = treatments.size() * (p.elements.size() + p.step_ratios.size()) + 1;
  add_errors(tables, p);
  std::size_t done = 0;
  progress(++done, total);
  for (const std::string treatment : treatments) {
    std::vector<double> sizes, deviations, noises;
    for (const Index n : p.elements) {
      progress(++done, total);
      if (treatment == "cut" && n > p.largest_cut) continue;
      const Noise noise = add_noise(tables, p, treatment, "elements", n, p.noise_step_ratio);
      sizes.push_back(static_cast<double>(n));
      deviations.push_back(noise.deviation);
      noises.push_back(noise.noise);
    }
    double largest = 0;
    for (const double c : p.step_ratios) {
      largest = std::max(
          largest, add_noise(tables, p, treatment, "step_ratio", p.noise_elements, c).largest);
      progress(++done, total);
    }
    tables.orders.add({treatment, sizes.back(), fitted_order(sizes, deviations),
                       fitted_order(sizes, noises), largest});
  }
  return {tables.creepage, tables.events, tables.noise,
          tables.errors,   tables.orders, claims_of(tables, p)};
}

}  // namespace microslip::experiments
