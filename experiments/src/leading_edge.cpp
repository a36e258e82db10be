// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/leading_edge.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "leading_edge_series.hpp"
#include "microslip/experiments/claims.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "study_keys.hpp"

namespace microslip::experiments {

using namespace leading_edge_study;

namespace {

Table errors_table(const LeadingEdgeParameters& p, const std::vector<Series>& all) {
  Table table("errors", "errors against Carter, c = 1",
              {{"scheme", "1", "treatment of the leading edge, and basis"},
               {"leading_offset", "1", "from the last node to the leading edge, in elements"},
               {"trailing_offset", "1", "from the trailing edge to the first node, in elements"},
               {"stick_ratio", "1", "a'"},
               {"elements", "1", "N"},
               {"traction_error", "N/mm", "1-norm: dx times the sum of |p - exact| over the nodes"},
               {"force_error", "1", "|force / exact - 1|"}});
  for (const Series& s : all) {
    for (std::size_t i = 0; i < p.sizes.size(); ++i) {
      table.add({s.scheme, s.offset, s.trailing_offset, s.stick_ratio, p.sizes[i], s.traction[i],
                 s.force[i]});
    }
  }
  return table;
}

Table reductions_table(const std::vector<Series>& all) {
  Table table("reductions", "factors by which doubling N reduces the errors, over all doublings",
              {{"scheme", "1", "treatment of the leading edge, and basis"},
               {"leading_offset", "1", "from the last node to the leading edge, in elements"},
               {"trailing_offset", "1", "from the trailing edge to the first node, in elements"},
               {"stick_ratio", "1", "a'"},
               {"traction_mean", "1", "mean factor of the traction's 1-norm"},
               {"traction_best", "1", "largest factor of the same"},
               {"force_mean", "1", "mean factor of the force error"},
               {"force_best", "1", "largest factor of the same"}});
  for (const Series& s : all) {
    const std::vector<double> traction = reductions(s.traction);
    const std::vector<double> force = reductions(s.force);
    table.add({s.scheme, s.offset, s.trailing_offset, s.stick_ratio, mean(traction),
               largest(traction), mean(force), largest(force)});
  }
  return table;
}

/// Sorts all factors of a scheme.
std::vector<double> sorted_reductions(const std::vector<Series>& all, const std::string& scheme) {
  std::vector<double> factors;
  for (const Series& s : all) {
    if (s.scheme != scheme) continue;
    for (const double factor : reductions(s.traction)) factors.push_back(factor);
  }
  std::sort(factors.begin(), factors.end());
  return factors;
}

Table summary_table(const std::vector<Series>& all) {
  Table table("summary", "distribution of the traction's factors per doubling, over all settings",
              {{"scheme", "1", "treatment of the leading edge, and basis"},
               {"settings", "1", "number of offsets and stick ratios"},
               {"mean", "1", "mean factor"},
               {"smallest", "1", "smallest factor"},
               {"lower_quartile", "1", "a quarter is below"},
               {"median", "1", "half is below"},
               {"upper_quartile", "1", "three quarters are below"},
               {"largest", "1", "largest factor"}});
  for (const Scheme& scheme : schemes()) {
    const std::vector<double> f = sorted_reductions(all, scheme.name);
    if (f.empty()) continue;
    const auto count = std::count_if(all.begin(), all.end(),
                                     [&](const Series& s) { return s.scheme == scheme.name; });
    table.add({scheme.name, count, mean(f), f.front(), f[f.size() / 4], f[f.size() / 2],
               f[3 * f.size() / 4], f.back()});
  }
  return table;
}

/// The setting whose mean and best factor have the least relative distance from a pair of the
/// thesis.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  Series series;
  double mean = 0;
  double best = 0;
};

using Wanted = std::function<bool(const Series&)>;

Nearest nearest_setting(const std::vector<Series>& all, const Wanted& wanted, double thesis_mean,
                        double thesis_best) {
  Nearest nearest;
  for (const Series& s : all) {
    if (!wanted(s)) continue;
    const std::vector<double> f = reductions(s.traction);
    const double distance = std::hypot(mean(f) / thesis_mean - 1, largest(f) / thesis_best - 1);
    if (distance < nearest.distance) nearest = {distance, s, mean(f), largest(f)};
  }
  return nearest;
}

/// A pair of factors of the thesis, and the settings nearest to the pair: at one stick ratio, and
/// at any. The mean over all settings tells how far both are from an average setting.
struct Pair {
  double thesis_mean;
  double thesis_best;
  double stick_ratio;
  Nearest at_its_ratio;
  Nearest anywhere;
  double average_mean;
  double average_best;
};

Pair nearest_pair(const std::vector<Series>& all, const std::string& prefix, double stick_ratio,
                  double thesis_mean, double thesis_best) {
  const auto matches = [&](const Series& s) { return s.scheme.rfind(prefix, 0) == 0; };
  const auto at_ratio = [&](const Series& s) { return matches(s) && s.stick_ratio == stick_ratio; };
  std::vector<double> means, bests;
  for (const Series& s : all) {
    if (!matches(s)) continue;
    const std::vector<double> f = reductions(s.traction);
    means.push_back(mean(f));
    bests.push_back(largest(f));
  }
  return {thesis_mean,
          thesis_best,
          stick_ratio,
          nearest_setting(all, at_ratio, thesis_mean, thesis_best),
          nearest_setting(all, matches, thesis_mean, thesis_best),
          mean(means),
          mean(bests)};
}

Table settings_table(const std::vector<Pair>& pairs) {
  Table table(
      "settings",
      "the settings that come nearest to the thesis's factors (10.3): at the stick ratio of "
      "its test case, and among all",
      {{"scheme", "1", "treatment of the leading edge, and basis"},
       {"leading_offset", "1", "from the last node to the leading edge, in elements"},
       {"trailing_offset", "1", "from the trailing edge to the first node, in elements"},
       {"stick_ratio", "1", "a'"},
       {"mean", "1", "mean factor of the traction's 1-norm per doubling"},
       {"best", "1", "largest of the factors"},
       {"thesis_mean", "1", "the thesis's mean factor"},
       {"thesis_best", "1", "the thesis's largest factor"}});
  for (const Pair& pair : pairs) {
    for (const Nearest* nearest : {&pair.at_its_ratio, &pair.anywhere}) {
      const Series& s = nearest->series;
      table.add({s.scheme, s.offset, s.trailing_offset, s.stick_ratio, nearest->mean, nearest->best,
                 pair.thesis_mean, pair.thesis_best});
    }
  }
  return table;
}

bool same_setting(const Series& a, const Series& b) {
  return a.offset == b.offset && a.trailing_offset == b.trailing_offset &&
         a.stick_ratio == b.stick_ratio;
}

/// The gain by a better leading edge in one setting: for each N, the error of the plain scheme over
/// the error of the better one.
struct Gain {
  const Series* better;
  std::vector<double> factors;
};

std::vector<Gain> gains_over(const std::vector<Series>& all, const std::string& plain_scheme,
                             const std::string& better_scheme) {
  std::vector<Gain> gains;
  for (const Series& better : all) {
    if (better.scheme != better_scheme) continue;
    const auto plain = std::find_if(all.begin(), all.end(), [&](const Series& s) {
      return s.scheme == plain_scheme && same_setting(s, better);
    });
    gains.push_back({&better, {}});
    for (std::size_t i = 0; i < plain->traction.size(); ++i) {
      gains.back().factors.push_back(plain->traction[i] / better.traction[i]);
    }
  }
  return gains;
}

/// Returns the geometric mean over all settings and N.
double geometric_mean(const std::vector<Gain>& gains) {
  std::vector<double> logarithms;
  for (const Gain& gain : gains) {
    for (const double factor : gain.factors) logarithms.push_back(std::log(factor));
  }
  return std::exp(mean(logarithms));
}

std::string described(const Series& s) {
  return fmt::format("leading offset {}, trailing offset {}, a' = {}", format_short(s.offset),
                     format_short(s.trailing_offset), format_short(s.stick_ratio));
}

/// Divides p_N of trimmed hats by its exact value. Returns the smallest ratio over all offsets, at
/// one stick ratio.
double smallest_overestimate(const LeadingEdgeParameters& p) {
  double smallest = std::numeric_limits<double>::infinity();
  const Scheme trimmed = scheme_of("trimmed linear");
  for (const double offset : p.leading_offsets) {
    if (offset == 1) continue;  // nothing is trimmed
    const Compared s =
        solve(p, trimmed, {offset, offset, p.profile_stick_ratio, p.profile_elements});
    const Eigen::Index last = p.profile_elements - 1;
    smallest = std::min(smallest, s.solution.traction[last] / s.exact[last]);
  }
  return smallest;
}

Table profile_table(const LeadingEdgeParameters& p) {
  Table table("profile", "tractions with and without better leading edges, Figs. 10.1 and 10.3",
              {{"scheme", "1", "treatment of the leading edge, and basis"},
               {"leading_offset", "1", "from the last node to the leading edge, in elements"},
               {"x", "mm", "position"},
               {"traction", "N/mm^2", "tangential traction p"},
               {"exact", "N/mm^2", "Carter's traction at x"}});
  for (const Scheme& scheme : schemes()) {
    for (const double offset : {0.5, p.profile_offset}) {
      if (!applies(scheme, offset)) continue;
      const Compared s =
          solve(p, scheme, {offset, offset, p.profile_stick_ratio, p.profile_elements});
      for (Eigen::Index i = 0; i < s.exact.size(); ++i) {
        table.add({scheme.name, offset, s.solution.x[i], s.solution.traction[i], s.exact[i]});
      }
    }
  }
  return table;
}

Table exact_table(const LeadingEdgeParameters& p) {
  constexpr int points = 1001;
  const Carter carter = Carter::from_stick_ratio(p.material, p.bound, p.profile_stick_ratio);
  Table table("exact", "Carter's solution, thesis (10.1)",
              {{"x", "mm", "position"}, {"traction", "N/mm^2", "exact traction"}});
  for (int i = 0; i < points; ++i) {
    const double x = p.bound.half_width() * (2.0 * i / (points - 1) - 1);
    table.add({x, carter.traction(x)});
  }
  return table;
}

Table hats_table(double offset) {
  Table table("hats", "the general and the trimmed hat at the last node, Fig. 10.2",
              {{"s", "dx", "distance from the last node; the edge lies at leading_offset"},
               {"general", "1", "hat (6.4)"},
               {"trimmed", "1", "zero beyond the edge"}});
  const ShapeFunction general = linear_shape();
  const ShapeFunction trimmed = trimmed_linear_basis(offset).shapes()[1];
  for (int i = -150; i <= 150; ++i) {
    const double s = i / 100.0;
    table.add({s, general.value(s), trimmed.value(s)});
  }
  return table;
}

Table claims_of(const LeadingEdgeParameters& p, const std::vector<Series>& all,
                const Pair& standard, const Pair& known) {
  // The thesis does not name the alignment, so that the nearest alignment is compared with it.
  const auto factor_claim = [](const std::string& claim, double thesis, double Nearest::*factor,
                               double average, const Pair& pair) {
    const Range close = within_percent(5, thesis);
    const std::string ratio = "a' = " + format_short(pair.stick_ratio);
    const double at_its_ratio = pair.at_its_ratio.*factor;
    const double anywhere = pair.anywhere.*factor;
    const Series& s = pair.at_its_ratio.series;
    return Claim{claim,
                 "10.3",
                 thesis,
                 at_its_ratio,
                 "1",
                 holds_if({{"the nearest of all alignments and both bases at " + ratio, close}},
                          {{"the nearest at any a'", anywhere, close}}),
                 fmt::format("nearest at {}: {}, {}; at any: {} at {}; mean over all settings {}",
                             ratio, s.scheme, described(s), format_short(anywhere),
                             described(pair.anywhere.series), format_short(average)),
                 "leading_edge_reductions"};
  };
  const std::vector<Gain> gains = gains_over(all, "standard linear", "trimmed linear");
  std::vector<double> gain_values;
  for (const Gain& gain : gains) gain_values.push_back(mean(gain.factors));
  const auto far_from_thesis = [](double gain) { return std::abs(gain - 1.7146); };
  const auto nearest_gain =
      std::min_element(gain_values.begin(), gain_values.end(),
                       [&](double a, double b) { return far_from_thesis(a) < far_from_thesis(b); });
  const Series& nearest_trimmed =
      *gains[static_cast<std::size_t>(nearest_gain - gain_values.begin())].better;
  const double overestimate = smallest_overestimate(p);
  const auto mean_of = [&](const std::string& scheme) {
    return mean(sorted_reductions(all, scheme));
  };
  const double known_gain =
      geometric_mean(gains_over(all, "standard constant", "known edge constant"));
  const double known_factor = std::exp(
      0.5 * (std::log(mean_of("known edge constant")) + std::log(mean_of("known edge linear"))));
  const double trimmed_change = mean_of("trimmed linear") / mean_of("standard linear") - 1;
  return claims_table(
      {{"the solution is much closer to Carter's with the displacement at the leading edge known",
        "10.3", not_given, known_gain, "1", holds_if({above(2)}),
        "error of constant functions without over that with it, geometric mean over all settings",
        "leading_edge_profile"},
       factor_claim("doubling N reduces the traction's error by 1.83 on average", 1.83,
                    &Nearest::mean, standard.average_mean, standard),
       factor_claim("doubling N reduces the traction's error by 2.09 at best", 2.09, &Nearest::best,
                    standard.average_best, standard),
       factor_claim("with the displacement at the leading edge known: by 2.89 on average", 2.89,
                    &Nearest::mean, known.average_mean, known),
       factor_claim("with the displacement at the leading edge known: by 4.96 at best", 4.96,
                    &Nearest::best, known.average_best, known),
       {"the leading edge is the primary cause of first order", "10.4", 4, known_factor, "1",
        holds_if({above(3.6)}, {above(2.4)}),
        "mean factor per doubling with the displacement known; 4 is second order, and 2.83 the "
        "order 3/2 of the square roots that are left at the edge and at the stick-slip point",
        "leading_edge_reductions"},
       {"trimming the last hat makes the error 1.7146 times smaller on average", "10.4", 1.7146,
        mean(gain_values), "1",
        not_comparable(
            "the thesis does not give the alignment of its grids, on which this depends"),
        fmt::format("mean over all settings and N; {} at {}", format_short(*nearest_gain),
                    described(nearest_trimmed)),
        no_figure},
       {"the trimmed hat overestimates the traction at the last node", "10.4", not_given,
        overestimate, "1", holds_if({above(1)}),
        "smallest p_N over its exact value, over the offsets below 1", "leading_edge_profile"},
       {"the trimmed hat does not significantly improve the rate of convergence", "10.4", not_given,
        trimmed_change, "1", holds_if({below(0.2)}),
        "mean factor per doubling over the factor of plain hats, minus 1",
        "leading_edge_reductions"}});
}

}  // namespace

LeadingEdgeParameters read_leading_edge(Scene& scene) {
  using P = LeadingEdgeParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::length, "kernel.length"},
       {&P::sizes, "grid.sizes", "numbers N of nodes", range(3, 10000), two_or_more_doubling},
       {&P::leading_offsets, "grid.leading_offsets",
        "distances from the last node to the leading edge, in elements", range_above(0, 1)},
       {&P::trailing_offsets, "grid.trailing_offsets",
        "distances from the trailing edge to the first node, in elements", fraction},
       {&P::stick_ratios, "load.stick_ratios", "parts a' of the contact that stick",
        inner_fraction},
       {&P::profile_elements, "profile.elements", "N of the tractions shown",
        range(1, Grid::max_elements)},
       {&P::profile_stick_ratio, "profile.stick_ratio",
        "a' of the tractions shown, and of the numbers of the thesis", inner_fraction,
        "one of load.stick_ratios"},
       {&P::profile_offset, "profile.leading_offset", "leading offset of the trimmed hat shown",
        inner_fraction}});
  P p = keys.read({.material = read_material(scene), .bound = read_hertz_bound(scene)});
  scene.demand("profile.stick_ratio", p.profile_stick_ratio,
               std::ranges::count(p.stick_ratios, p.profile_stick_ratio) == 1);
  return p;
}

std::vector<Table> leading_edge(const LeadingEdgeParameters& p, const Progress& progress) {
  const std::vector<Series> all = solve_all(p, progress);
  const Pair standard = nearest_pair(all, "standard", p.profile_stick_ratio, 1.83, 2.09);
  const Pair known = nearest_pair(all, "known edge", p.profile_stick_ratio, 2.89, 4.96);
  return {errors_table(p, all),
          reductions_table(all),
          summary_table(all),
          settings_table({standard, known}),
          profile_table(p),
          exact_table(p),
          hats_table(p.profile_offset),
          claims_of(p, all, standard, known)};
}

}  // namespace microslip::experiments
