// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/ellipse_convergence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "contact_ellipse.hpp"
#include "line_for_ellipse.hpp"
#include "microslip/experiments/claims.hpp"
#include "microslip/patch/patch_grid.hpp"
#include "study_keys.hpp"
#include "table_values.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::Vector3d;

namespace {

constexpr double up_to_rounding = 1e-9;

EllipticBound bound_of(double aspect) {
  const double root = std::sqrt(aspect);
  return {root, 1 / root, 1};
}

/// Rows and elements of some size^2 cells, in the proportion of fitting_grid().
struct Cut {
  Index rows, elements;

  Cut(double aspect, Index size) {
    const PatchShape shape = PatchBound(bound_of(aspect)).shape();
    constexpr double side = 32;
    const PatchGrid known = fitting_grid(shape, side);
    const double of_known = std::sqrt(static_cast<double>(known.rows * known.elements));
    const PatchGrid grid = fitting_grid(shape, side * static_cast<double>(size) / of_known);
    rows = grid.rows;
    elements = grid.elements;
  }
  Index cells() const { return rows * elements; }
};

/// Forces over full sliding, and the moment over full sliding times the size.
Vector3d relative(const SteadyPatch& patch, const Vector3d& resultants) {
  const double full = patch.bound.total();
  return resultants.cwiseQuotient(full * Vector3d(1, 1, patch.bound.size()));
}

Vector3d relative(const SteadyPatch& patch, const SteadyPatchSolution& solution) {
  return relative(patch, solution.resultants);
}

Vector3d relative(const SteadyPatch& patch, const ContactState& state, const ContactResult& of) {
  const bool along = std::string(state.kind) == "longitudinal";
  return relative(patch, Vector3d(along ? of.force : 0, along ? 0 : of.force, of.moment));
}

double force_error(const Vector3d& error) { return error.head<2>().cwiseAbs().maxCoeff(); }

/// A load of the ellipses, over mu p0/G.
struct Load3 {
  const char* kind;
  Vector3d motion;  ///< xi, eta, phi c
};

const std::array<Load3, 13>& loads() {
  static const std::array<Load3, 13> all{{{"creepage", {0.15, 0, 0}},
                                          {"creepage", {0.4, 0, 0}},
                                          {"creepage", {0.9, 0, 0}},
                                          {"creepage", {0, 0.15, 0}},
                                          {"creepage", {0, 0.4, 0}},
                                          {"creepage", {0, 0.9, 0}},
                                          {"creepage", {0.3, 0.3, 0}},
                                          {"spin", {0, 0, 0.2}},
                                          {"spin", {0, 0, 0.7}},
                                          {"spin", {0, 0, 2}},
                                          {"spin", {0, -0.25, 0.4}},
                                          {"spin", {0.3, -0.2, 0.5}},
                                          {"spin", {0.6, 0.3, 1.5}}}};
  return all;
}

SteadyPatch ellipse(double aspect, double nu, const Cut& cut, const Vector3d& motion) {
  SteadyPatch patch{
      .material = {1, nu}, .bound = bound_of(aspect), .rows = cut.rows, .elements = cut.elements};
  for (std::size_t j = 0; j < 3; ++j) patch.load[j].value = motion[static_cast<Index>(j)];
  return patch;
}

PatchResponse response_of(double aspect, double nu, const Cut& cut) {
  return {JoinedRows(aspect, cut.rows, cut.elements), nu};
}

constexpr const char* schemes_of_circle =
    "joined: rows; standard: equal rectangles; contact: CONTACT's printed results, which are of "
    "the standard scheme";

struct Circle {
  Table errors;
  Table limits;
  double from_contact = 0;  ///< largest difference of the standard scheme from CONTACT's results
};

Circle circle(const EllipseConvergenceParameters& p, const auto& advance) {
  Circle found{
      {"circle",
       "errors of the resultants on a circle, against the finest joined rows",
       {{"scheme", "1", schemes_of_circle},
        {"kind", "1", "longitudinal or lateral creepage, or spin"},
        {"level", "1", "creepage over 0.07, 0.08 or 0.2/mm, where mu p0/G = 0.143"},
        {"cells", "1", "number of cells or elements in the contact"},
        {"force_error", "1", "of the force, over full sliding", up_to_rounding},
        {"moment_error", "1", "of the moment, over full sliding times a", up_to_rounding}}},
      {"limits",
       "resultants over full sliding, of the finest joined rows and extrapolated from "
       "CONTACT's results",
       {{"kind", "1", "longitudinal or lateral creepage, or spin"},
        {"level", "1", "creepage over 0.07, 0.08 or 0.2/mm"},
        {"force", "1", "by joined rows; along the creepage, for spin the lateral one"},
        {"contact_force", "1", "by CONTACT"},
        {"moment", "1", "by joined rows"},
        {"contact_moment", "1", "by CONTACT"},
        {"difference", "1", "the larger one of both differences"}}}};
  const double nu = patch_of(contact_states().front(), 1, 1).material.poisson_ratio;
  std::map<const ContactState*, Vector3d> exact;
  const auto add = [&](const char* scheme, const ContactState& state, Index cells,
                       const Vector3d& value) {
    const Vector3d error = value - exact.at(&state);
    found.errors.add(
        {scheme, state.kind, state.level, cells, force_error(error), std::abs(error[2])});
  };
  const auto solve = [&](Index size, const auto& use) {
    const Cut cut(1, size);
    const PatchResponse response = response_of(1, nu, cut);
    for (const ContactState& state : contact_states()) {
      const SteadyPatch patch = patch_of(state, cut.rows, cut.elements);
      use(state, patch, relative(patch, solve_steady(patch, response)));
      advance();
    }
  };
  solve(p.reference, [&](const ContactState& state, const SteadyPatch& patch, const Vector3d& of) {
    exact[&state] = of;
    const Vector3d limit = relative(patch, state, state.limit);
    const Index along = std::string(state.kind) == "longitudinal" ? 0 : 1;
    found.limits.add({state.kind, state.level, of[along], limit[along], of[2], limit[2],
                      (of - limit).cwiseAbs().maxCoeff()});
  });
  for (const Index size : p.sizes) {
    solve(size, [&](const ContactState& state, const SteadyPatch&, const Vector3d& of) {
      add("joined", state, size * size, of);
    });
  }
  for (std::size_t k = 0; k < contact_diameters.size(); ++k) {
    RectangleRolling rectangles(contact_rectangles(contact_diameters[k]));
    for (const ContactState& state : contact_states()) {
      const SteadyPatch patch = patch_of(state, 1, 1);
      rectangles.roll_steadily(patch.load);
      const Vector3d value = relative(patch, rectangles.resultants());
      const Vector3d by_contact = relative(patch, state, state.results[k]);
      add("standard", state, rectangles.size(), value);
      add("contact", state, contact_elements[k], by_contact);
      found.from_contact = std::max(found.from_contact, (value - by_contact).cwiseAbs().maxCoeff());
      advance();
    }
  }
  return found;
}

Table ellipses(const EllipseConvergenceParameters& p, const auto& advance) {
  Table table(
      "ellipses", "errors of the resultants, against the finest joined rows",
      {{"scheme", "1", "joined: rows; standard: equal rectangles"},
       {"aspect", "1", "a/b"},
       {"kind", "1", "creepage without spin, or any with spin"},
       {"creepage", "1", "xi over mu p0/G"},
       {"lateral_creepage", "1", "eta over mu p0/G"},
       {"spin", "1", "phi c over mu p0/G"},
       {"rows", "1", "M"},
       {"elements", "1", "N of a row, or of the longest row of rectangles"},
       {"cells", "1", "number of cells or elements in the contact"},
       {"force_error", "1", "the larger one of both forces', over full sliding", up_to_rounding},
       {"moment_error", "1", "of the moment, over full sliding times c", up_to_rounding}});
  for (const double aspect : p.aspects) {
    std::vector<Vector3d> exact;
    const auto solve = [&](Index size, const auto& use) {
      const Cut cut(aspect, size);
      const PatchResponse response = response_of(aspect, p.poisson_ratio, cut);
      for (std::size_t l = 0; l < loads().size(); ++l) {
        const SteadyPatch patch = ellipse(aspect, p.poisson_ratio, cut, loads()[l].motion);
        use(l, cut, relative(patch, solve_steady(patch, response)));
        advance();
      }
    };
    solve(p.reference,
          [&](std::size_t, const Cut&, const Vector3d& value) { exact.push_back(value); });
    const auto add = [&](const char* scheme, std::size_t l, const Cut& cut, Index cells,
                         const Vector3d& value) {
      const Vector3d error = value - exact[l];
      const Vector3d& motion = loads()[l].motion;
      table.add({scheme, aspect, loads()[l].kind, motion[0], motion[1], motion[2], cut.rows,
                 cut.elements, cells, force_error(error), std::abs(error[2])});
    };
    for (const Index size : p.sizes) {
      solve(size, [&](std::size_t l, const Cut& cut, const Vector3d& value) {
        add("joined", l, cut, cut.cells(), value);
      });
    }
    for (const Index size : p.rectangles) {
      const Cut cut(aspect, size);
      const SteadyPatch any = ellipse(aspect, p.poisson_ratio, cut, Vector3d::Zero());
      RectangleRolling rectangles({.material = any.material,
                                   .bound = bound_of(aspect),
                                   .elements = cut.elements,
                                   .rows = cut.rows});
      for (std::size_t l = 0; l < loads().size(); ++l) {
        rectangles.roll_steadily(ellipse(aspect, p.poisson_ratio, cut, loads()[l].motion).load);
        add("standard", l, cut, rectangles.size(), relative(any, rectangles.resultants()));
        advance();
      }
    }
  }
  return table;
}

double root_mean_square(const Table& table, const char* column, const auto& wanted) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (!wanted(i)) continue;
    sum += std::pow(table.number(i, column), 2);
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : not_given;
}

/// Over all states of a kind, by numbers of cells.
Table summary_of(const Circle& found) {
  Table table("summary", "errors on the circle, over the levels of a kind",
              {{"scheme", "1", schemes_of_circle},
               {"kind", "1", "creepage without spin, or spin"},
               {"cells", "1", "number of cells or elements in the contact"},
               {"force_error", "1", "of the force over full sliding, root of the mean square"},
               {"moment_error", "1", "of the moment, the same, over full sliding times a"},
               {"largest", "1", "the largest error of a force"}});
  const Table& errors = found.errors;
  for (const char* scheme : {"joined", "standard", "contact"}) {
    for (const bool spin : {false, true}) {
      std::vector<double> numbers;
      for (std::size_t i = 0; i < errors.rows(); ++i) {
        const double cells = errors.number(i, "cells");
        if (has(errors, i, {{"scheme", scheme}}) &&
            std::ranges::find(numbers, cells) == numbers.end())
          numbers.push_back(cells);
      }
      for (const double cells : numbers) {
        const auto wanted = [&](std::size_t i) {
          return has(errors, i, {{"scheme", scheme}}) && errors.number(i, "cells") == cells &&
                 has(errors, i, {{"kind", "spin"}}) == spin;
        };
        table.add({scheme, spin ? "spin" : "creepage", cells,
                   root_mean_square(errors, "force_error", wanted),
                   root_mean_square(errors, "moment_error", wanted),
                   extreme(errors, "force_error", false, wanted)});
      }
    }
  }
  return table;
}

Table claims_of(const EllipseConvergenceParameters& p, const Circle& found, const Table& summary,
                const Table& ellipses, const Table& lines) {
  const auto largest = [&](const char* kind, double least_cells) {
    return extreme(ellipses, "force_error", false, [&](std::size_t i) {
      return has(ellipses, i, {{"scheme", "joined"}, {"kind", kind}}) &&
             ellipses.number(i, "cells") >= least_cells;
    });
  };
  const auto at = [&](const char* scheme, const char* kind, bool last) {
    double value = not_given;
    for (std::size_t i = 0; i < summary.rows(); ++i) {
      if (!has(summary, i, {{"scheme", scheme}, {"kind", kind}})) continue;
      if (last || std::isnan(value)) value = summary.number(i, "force_error");
    }
    return value;
  };
  const auto of_hundred = [&](const char* kind) {
    return most(summary, "force_error", {{"scheme", "joined"}, {"kind", kind}, {"cells", 100.0}});
  };
  const auto order = [&](const char* kind, Index first, double error) {
    const double ratio = static_cast<double>(p.sizes.back()) / static_cast<double>(first);
    return std::log(error / at("joined", kind, true)) / std::log(ratio);
  };
  const auto off = [&](const char* column) {
    return std::fmax(most(lines, column, {}), -least(lines, column, {}));
  };
  constexpr double hundred = 85, four_hundred = 380;  // cells, as they fit a/b
  return claims_table(
      {{"some 100 cells give forces without spin to two thousandths of full sliding", "none",
        not_given, largest("creepage", hundred), "1", ours_if({below(2e-3)}),
        "largest error over a/b, from 85 cells on", "ellipse_convergence_aspects"},
       {"some 100 cells give forces with any spin to one percent of full sliding", "none",
        not_given, largest("spin", hundred), "1", ours_if({below(1e-2)}),
        "largest error over a/b, from 85 cells on", "ellipse_convergence_aspects"},
       {"some 400 cells give forces with any spin to a thousandth of full sliding", "none",
        not_given, std::fmax(largest("spin", four_hundred), largest("creepage", four_hundred)), "1",
        ours_if({below(1e-3)}), "largest error over a/b, from 380 cells on",
        "ellipse_convergence_aspects"},
       {"the order of forces without spin is above two, as slip begins within cells", "none", 2,
        order("creepage", p.sizes.front(), at("joined", "creepage", false)), "1",
        ours_if({above(2)}),
        "order in the number of cells along an axis, of the root mean square on the circle",
        "ellipse_convergence_error"},
       {"the order of forces under spin is two", "none", 2, order("spin", 10, of_hundred("spin")),
        "1", ours_if({above(1.7)}),
        "order in the number of cells along an axis from 10 on, of the root mean square on the "
        "circle",
        "ellipse_convergence_error"},
       {"the standard scheme has CONTACT's results", "none", not_given, found.from_contact, "1",
        ours_if({below(3e-6)}),
        "largest difference of a force or moment, over full sliding; CONTACT's are rounded to 1e-6 "
        "N",
        "ellipse_convergence_error"},
       {"316 elements of the standard scheme have ten times the error of 100 cells without spin, "
        "or "
        "more",
        "none", not_given, at("standard", "creepage", false) / of_hundred("creepage"), "1",
        ours_if({above(10)}), "ratio of the root mean squares on the circle",
        "ellipse_convergence_error"},
       {"under spin 100 cells have a smaller error than 316 elements of the standard scheme",
        "none", not_given, of_hundred("spin") / at("standard", "spin", false), "1",
        ours_if({below(0.8)}), "ratio of the root mean squares on the circle",
        "ellipse_convergence_error"},
       {"a strip of the same area has the force of the ellipse without spin to three hundredths of "
        "full sliding",
        "none", not_given, off("strip_error"), "1", ours_if({below(0.03)}),
        "largest difference over a/b and load", "ellipse_convergence_lines"},
       {"plane strain is up to half of full sliding off where the ellipse is longer than wide",
        "none", not_given, off("plane_error"), "1", ours_if({above(0.3)}),
        "largest difference over a/b and load", "ellipse_convergence_lines"},
       {"joined rows and CONTACT have the same limits", "none", not_given,
        most(found.limits, "difference", {}), "1", ours_if({below(2e-3)}),
        "largest difference of a force or moment, over full sliding",
        "ellipse_convergence_error"}});
}

}  // namespace

EllipseConvergenceParameters read_ellipse_convergence(Scene& scene) {
  using P = EllipseConvergenceParameters;
  const StudyKeys<P> keys(
      scene, {{&P::aspects, "ellipse.aspects", "a/b, a along the rolling", range(0.2, 5)},
              {&P::lines, "ellipse.lines", "a/b of ellipses beside line contacts", range(0.05, 10)},
              {&P::poisson_ratio, "ellipse.poisson_ratio", "nu of the ellipses", range(0, 0.5)},
              {&P::sizes, "convergence.sizes",
               "square roots of the numbers of cells; rows and elements fit a/b", range(5, 30),
               two_or_more_rising},
              {&P::rectangles, "convergence.rectangles",
               "the same of the rectangles around an ellipse, by the standard scheme", range(5, 60),
               two_or_more_rising},
              {&P::reference, "convergence.reference", "the same, of the reference", range(6, 40),
               "above convergence.sizes"}});
  const P p = keys.read({});
  scene.demand("convergence.reference", static_cast<double>(p.reference),
               p.reference > p.sizes.back());
  return p;
}

std::vector<Table> ellipse_convergence(const EllipseConvergenceParameters& p,
                                       const Progress& progress) {
  const std::size_t steps =
      (p.sizes.size() + 1) * (contact_states().size() + p.aspects.size() * loads().size()) +
      contact_diameters.size() * contact_states().size() +
      p.rectangles.size() * p.aspects.size() * loads().size();
  std::size_t done = 0;
  const auto advance = [&] { progress(++done, steps); };
  const Circle found = circle(p, advance);
  const Table summary = summary_of(found);
  const Table of_ellipses = ellipses(p, advance);
  const Table lines = line_contacts_table(p.lines, p.poisson_ratio, advance);
  return {found.errors, found.limits, of_ellipses,
          summary,      lines,        claims_of(p, found, summary, of_ellipses, lines)};
}

}  // namespace microslip::experiments
