// SPDX-License-Identifier: GPL-3.0-or-later
#include "graded_elements.hpp"

#include <algorithm>
#include <cmath>

#include "bound_rows.hpp"
#include "element_solution.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double most_growth = 2.5;    ///< of the length from an element to its neighbour
constexpr double part_of_zone = 0.06;  ///< longest element next to the end of a zone
constexpr double shortest = 1.5e-8;    ///< element, over the half-width
constexpr Index parts_of_piece = 4;
constexpr Index most_pieces = 200;  ///< which have so many parts

VectorXd middles(const ElementEnds& ends) {
  VectorXd x(static_cast<Index>(ends.size()) - 1);
  for (Index i = 0; i < x.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    x[i] = (ends[k] + ends[k + 1]) / 2;
  }
  return x;
}

VectorXd lengths(const ElementEnds& ends) {
  VectorXd l(static_cast<Index>(ends.size()) - 1);
  for (Index i = 0; i < l.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    l[i] = ends[k + 1] - ends[k];
  }
  return l;
}

/// Distance to the next node ahead; ahead of the last one, to the place that a node of an equal
/// element would have.
VectorXd steps(const VectorXd& x, const VectorXd& l) {
  VectorXd steps(x.size());
  const Index n = x.size();
  for (Index i = 0; i < n; ++i) steps[i] = i + 1 < n ? x[i + 1] - x[i] : l[i];
  return steps;
}

/// Halves elements until none is much longer than its neighbour.
void smooth(ElementEnds& ends) {
  for (bool again = true; again;) {
    again = false;
    ElementEnds next{ends[0]};
    const std::size_t n = ends.size() - 1;
    const auto length = [&](std::size_t i) { return ends[i + 1] - ends[i]; };
    for (std::size_t i = 0; i < n; ++i) {
      const double behind = i > 0 ? length(i - 1) : HUGE_VAL;
      const double ahead = i + 1 < n ? length(i + 1) : HUGE_VAL;
      if (length(i) > most_growth * std::min(behind, ahead)) {
        next.push_back((ends[i] + ends[i + 1]) / 2);
        again = true;
      }
      next.push_back(ends[i + 1]);
    }
    ends = std::move(next);
  }
}

/// Displacements at a place by unit tractions on each element of a half-space.
VectorXd influences(const Kernel& half_space, double place, const VectorXd& x, const VectorXd& l) {
  count_work(2 * kernel_work * static_cast<double>(x.size()));
  return visit_half_space(
      [&](const auto& kernel) {
        VectorXd values(x.size());
        for (Index j = 0; j < x.size(); ++j) {
          values[j] =
              kernel.integral(place - x[j] + l[j] / 2) - kernel.integral(place - x[j] - l[j] / 2);
        }
        return values;
      },
      half_space);
}

/// (A - A')/dq: displacements of constant tractions at the nodes, less those at the next nodes,
/// over the steps.
MatrixXd strain_matrix(const Kernel& kernel, const VectorXd& x, const VectorXd& l) {
  const Index n = x.size();
  const VectorXd step = steps(x, l);
  const Kernel half_space = kernel.without_layer();
  const double layer = kernel.layer_compliance();
  MatrixXd strain(n, n);
  VectorXd at = influences(half_space, x[0], x, l);
  for (Index i = 0; i < n; ++i) {
    VectorXd next = influences(half_space, x[i] + step[i], x, l);
    strain.row(i) = (at - next) / step[i];
    strain(i, i) += layer / step[i];
    if (i + 1 < n) strain(i, i + 1) -= layer / step[i];
    at.swap(next);
  }
  return strain;
}

VectorXd displacement(const Kernel& kernel, const VectorXd& x, const VectorXd& l,
                      const VectorXd& traction) {
  const Kernel half_space = kernel.without_layer();
  VectorXd u = kernel.layer_compliance() * traction;
  for (Index i = 0; i < x.size(); ++i) u[i] += influences(half_space, x[i], x, l).dot(traction);
  return u;
}

SlipConditions conditions_of(const SteadyProblem& problem, const VectorXd& x, const VectorXd& l) {
  const Index n = x.size();
  SlipConditions conditions{
      .bound = VectorXd(n), .offset = VectorXd::Zero(n), .reference = VectorXd::Zero(n)};
  const VectorXd step = steps(x, l);
  for (Index i = 0; i < n; ++i) {
    conditions.bound[i] =
        std::visit([&](const auto& g) { return g.mean_around(x[i], l[i]); }, problem.contact.bound);
    if (!problem.contact.has_unlike_bodies()) continue;
    const double middle = x[i] + step[i] / 2;
    conditions.offset[i] = -problem.contact.pressure_strain *
                           std::visit([&](const auto& g) { return g.mean_around(middle, step[i]); },
                                      problem.contact.bound);
  }
  return conditions;
}

/// The zones of elements on finer ones.
std::vector<Zone> zones_on(const ElementEnds& finer, const GradedState& found) {
  const VectorXd x = middles(finer);
  std::vector<Zone> zones;
  std::size_t i = 0;
  for (const double place : x) {
    while (i + 2 < found.ends.size() && found.ends[i + 1] <= place) ++i;
    zones.push_back(found.state.zones[i]);
  }
  return zones;
}

GradedState solve_on(const SteadyProblem& problem, ElementEnds ends, const GradedState* before) {
  const VectorXd x = middles(ends), l = lengths(ends);
  ActiveSet active_set(strain_matrix(problem.contact.kernel, x, l), l, problem.solver);
  const SlipConditions conditions = conditions_of(problem, x, l);
  const std::vector<Zone> first =
      before ? zones_on(ends, *before) : std::vector<Zone>(ends.size() - 1, Zone::adhesion);
  ContactState state = active_set.solve(conditions, problem.load, first);
  return {std::move(ends), std::move(state)};
}

/// Halves the elements at the ends of zones that are too long for the narrower zone, or for the
/// distance to the nearest zero of the bound.
/// \return whether there was one
bool refine(const GradedState& found, const BoundRows& rows, ElementEnds& ends) {
  const auto& zones = found.state.zones;
  const std::size_t n = zones.size();
  std::vector<std::size_t> begins{0};
  for (std::size_t i = 1; i < n; ++i) {
    if (zones[i] != zones[i - 1]) begins.push_back(i);
  }
  begins.push_back(n);
  std::vector<char> halved(n, 0);
  const double least = shortest * rows.half_width();
  const auto to_zero = [&](double x) {
    double nearest = HUGE_VAL;
    for (std::size_t r = 0; r < rows.size() && !rows.smooth(); ++r) {
      if (rows.value(r) > 0) continue;
      const double away = std::abs(rows.x(r) - x);
      if (away > 0) nearest = std::min(nearest, away);
    }
    return nearest;
  };
  for (std::size_t k = 1; k + 1 < begins.size(); ++k) {
    const std::size_t at = begins[k];
    const double behind = found.ends[at] - found.ends[begins[k - 1]];
    const double ahead = found.ends[begins[k + 1]] - found.ends[at];
    const double longest =
        std::max(least, part_of_zone * std::min({behind, ahead, to_zero(found.ends[at])}));
    for (const std::size_t i : {at - 1, at}) {
      if (found.ends[i + 1] - found.ends[i] > longest) halved[i] = 1;
    }
  }
  // A slip zone next to a gap of the bound, or to an edge, is shorter than an element that sticks
  // there.
  const auto carries = [&](std::size_t i) {
    return rows.bound(rows.place_of((found.ends[i] + found.ends[i + 1]) / 2)) > 0;
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (zones[i] != Zone::adhesion || !carries(i)) continue;
    const bool behind = i == 0 || !carries(i - 1);
    const bool ahead = i + 1 == n ? rows.value(rows.size() - 1) == 0 : !carries(i + 1);
    if ((behind || ahead) && found.ends[i + 1] - found.ends[i] > least) halved[i] = 1;
  }
  if (std::ranges::find(halved, 1) == halved.end()) return false;
  ends = {found.ends[0]};
  for (std::size_t i = 0; i < n; ++i) {
    if (halved[i] != 0) ends.push_back((found.ends[i] + found.ends[i + 1]) / 2);
    ends.push_back(found.ends[i + 1]);
  }
  smooth(ends);
  return true;
}

}  // namespace

ElementEnds graded_elements(const TractionBound& bound, Index fewest) {
  const BoundRows rows(bound);
  ElementEnds ends;
  const double longest = 2 * rows.half_width() / static_cast<double>(fewest);
  const Index parts = static_cast<Index>(rows.size()) > most_pieces ? 1 : parts_of_piece;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const double width = rows.x(i + 1) - rows.x(i);
    const auto count = std::max<Index>(parts, static_cast<Index>(std::ceil(width / longest)));
    for (Index k = 0; k < count; ++k) {
      ends.push_back(rows.x(i) + width * static_cast<double>(k) / static_cast<double>(count));
    }
  }
  ends.push_back(rows.x(rows.size() - 1));
  smooth(ends);
  return ends;
}

GradedState solve_graded(const SteadyProblem& problem, ElementEnds ends, Index most) {
  const BoundRows rows(problem.contact.bound);
  GradedState found = solve_on(problem, std::move(ends), nullptr);
  ElementEnds finer;
  while (refine(found, rows, finer) && static_cast<Index>(finer.size()) <= most) {
    found = solve_on(problem, finer, &found);
  }
  return found;
}

SteadySolution graded_solution(const SteadyProblem& problem, const GradedState& graded) {
  const VectorXd x = middles(graded.ends), l = lengths(graded.ends);
  const SlipConditions conditions = conditions_of(problem, x, l);
  const ContactState& state = graded.state;
  SteadySolution solution = element_solution(
      problem, x, {l, conditions.bound, conditions.bound, state.traction, state.slip}, state);
  solution.displacement = displacement(problem.contact.kernel, x, l, state.traction);
  solution.scheme = SteadyScheme::graded;
  return solution;
}

}  // namespace microslip
