// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "ellipse_wiggles_tables.hpp"
#include "microslip/experiments/claims.hpp"
#include "table_values.hpp"

namespace microslip::experiments::ellipse_wiggles_study {

namespace {

double least_peak(const Table& wiggles, const char* scheme) {
  const Cell first = wiggles.at(0, "distance");
  return least(wiggles, "peak", {{"load", "creepage"}, {"scheme", scheme}, {"distance", first}});
}

double least_error(const Table& wiggles) {
  return least(wiggles, "force_error", {{"load", "spin"}, {"scheme", "direct"}});
}

}  // namespace

Table claims_of(const EllipseWigglesParameters& p, const Tables& tables, double from_contact) {
  constexpr double settled = 1.5, soon = 2;  // q/a
  const char *by_error = "ellipse_wiggles_error", *by_traction = "ellipse_wiggles_traction";
  const Table &of = tables.wiggles, &dependence = tables.dependence;
  const double least = p.step_ratios.back(), last = p.distances.back();
  const auto wave = [&](const char* scheme, const auto& wanted) {
    return extreme(of, "wave", false, [&](std::size_t i) {
      return has(of, i, {{"load", "creepage"}, {"scheme", scheme}}) && wanted(i);
    });
  };
  const auto is_settled = [&](std::size_t i) { return of.number(i, "distance") >= settled; };
  const auto spread = [&](const char* scheme, const char* column) {
    return extreme(dependence, column, false, [&](std::size_t i) {
      return has(dependence, i, {{"scheme", scheme}}) && dependence.number(i, "distance") <= soon;
    });
  };
  const auto small_step = [&](const char* scheme, const char* column, double distance) {
    return most(
        of, column,
        {{"load", "creepage"}, {"scheme", scheme}, {"step_ratio", least}, {"distance", distance}});
  };
  return claims_table(
      {{"the standard scheme has CONTACT's tractions after a shift and steps of any length", "none",
        not_given, from_contact, "1", ours_if({below(1e-4)}),
        "largest difference over mu p0 in the row at the centre, c = 1, 0.5, 0.1; CONTACT iterates "
        "to 1e-7",
        by_traction},
       {"small steps of the standard scheme make waves of a tenth of mu p0 or more", "7.1",
        not_given,
        wave("direct", [&](std::size_t i) { return of.number(i, "step_ratio") == least; }), "1",
        ours_if({above(0.1)}), "largest wave in adhesion at the smallest c", by_error},
       {"what remembers has no waves, however small the step", "7.1", not_given,
        wave("remembered", is_settled), "1", ours_if({below(0.025)}),
        "largest wave in adhesion over c, from q = 1.5 a on, when the peak has left", by_error},
       {"under-relaxed steps have none, either", "7.1", not_given, wave("relaxed", is_settled), "1",
        ours_if({below(0.025)}), "the same", by_error},
       {"under-relaxation leaves the error of the force that steps of an element have", "7.1",
        not_given,
        small_step("relaxed", "force_error", last) / most(of, "force_error",
                                                          {{"load", "creepage"},
                                                           {"scheme", "direct"},
                                                           {"step_ratio", p.step_ratios.front()},
                                                           {"distance", last}}),
        "1", ours_if({above(0.8), below(1.3)}),
        "error at the smallest c and the last distance, over that of the standard scheme at the "
        "largest c",
        by_error},
       {"forces of the standard scheme are percents off long after a shift, if steps are small",
        "none", not_given, small_step("direct", "force_error", last), "1", ours_if({above(0.02)}),
        "of full sliding, at the smallest c and the last distance", by_error},
       {"forces of what remembers are not", "none", not_given,
        most(of, "force_error",
             {{"load", "creepage"}, {"scheme", "remembered"}, {"distance", last}}),
        "1", ours_if({below(2.5e-3)}), "the largest over c at the last distance", by_error},
       {"forces and moment of what remembers depend on the step by a thousandth", "none", not_given,
        spread("remembered", "force"), "1", ours_if({below(1.5e-3)}),
        "largest difference from the smallest c, over loads, c and distances up to 2 a", by_error},
       {"forces and moment of the standard scheme depend on the step by a percent", "none",
        not_given, spread("direct", "force"), "1", ours_if({above(0.01)}), "the same", by_error},
       {"tractions of what remembers depend on the step by a percent, most of it in the cells "
        "where slip begins",
        "none", not_given, spread("remembered", "traction"), "1", ours_if({below(0.015)}),
        "root of the mean square over cells, largest over loads, c and distances up to 2 a",
        by_error},
       {"tractions of the standard scheme depend on the step by a tenth", "none", not_given,
        spread("direct", "traction"), "1", ours_if({above(0.07)}), "the same", by_error},
       {"what remembers keeps a travelling peak", "8", not_given, least_peak(of, "remembered"), "1",
        ours_if({above(0.94)}),
        "least height over that of the reference at the first distance, over c", by_traction},
       {"small steps of the standard scheme smear it", "8", not_given, least_peak(of, "direct"),
        "1", ours_if({below(0.88)}), "the same", by_traction},
       {"under-relaxed steps smear it as much", "7.1", not_given, least_peak(of, "relaxed"), "1",
        ours_if({below(0.88)}), "the same", by_traction},
       {"under a held force the creepage of what remembers is closer to the reference than that of "
        "the standard scheme",
        "none", not_given,
        most(tables.noise, "error", {{"scheme", "remembered"}}) /
            most(tables.noise, "error", {{"scheme", "direct"}}),
        "1", ours_if({below(0.7)}), "ratio of the largest errors over c",
        "ellipse_wiggles_creepage"},
       {"when the peak has left, the creepage of what remembers has no noise", "none", not_given,
        most(tables.noise, "settled_noise", {{"scheme", "remembered"}}), "1",
        ours_if({below(1e-3)}), "largest over c, over the mean", "ellipse_wiggles_creepage"},
       {"from rest under spin the standard scheme has percents of error in the lateral force",
        "none", not_given, least_error(of), "1", ours_if({above(0.005)}),
        "least error over c and distances, over full sliding", by_error}});
}

}  // namespace microslip::experiments::ellipse_wiggles_study
