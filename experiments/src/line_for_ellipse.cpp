// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_for_ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

#include "microslip/patch/steady_patch.hpp"
#include "microslip/rolling/schemes.hpp"

namespace microslip::experiments {

using Eigen::Index;
using std::numbers::pi;

namespace {

constexpr Index size = 16;  ///< square root of the number of cells

/// The force of a line contact over full sliding.
double relative_force(const Kernel& kernel, const HertzBound& bound, double creepage) {
  const SteadyProblem problem = solved_by(
      steady_scheme("inversion"), {.contact = {kernel, bound},
                                   .grid = Grid({.half_width = bound.half_width(), .elements = 21}),
                                   .load = PrescribedCreepage{creepage}});
  return solve_steady(problem).force / bound.total();
}

}  // namespace

Table line_contacts_table(const std::vector<double>& aspects, double poisson_ratio,
                          const std::function<void()>& advance) {
  Table table(
      "lines",
      "line contacts in the place of ellipses: the half-width along the rolling, full "
      "sliding, and the area are the same",
      {{"aspect", "1", "a/b"},
       {"direction", "1", "of creepage and force: longitudinal or lateral"},
       {"load", "1", "creepage over that by which the sticking ellipse would slide"},
       {"ellipse", "1", "force of the ellipse over full sliding"},
       {"strip", "1", "the same, of a strip of the width pi b/2"},
       {"plane", "1", "the same, in plane strain, or across the rolling in antiplane shear"},
       {"strip_error", "1", "strip - ellipse"},
       {"plane_error", "1", "plane - ellipse"}});
  const Material material{1, poisson_ratio};
  std::vector<std::vector<Cell>> found;
  for (const double aspect : aspects) {
    const double a = std::sqrt(aspect), b = 1 / a, width = pi * b / 2;
    const EllipticBound ellipse(a, b, 1);
    const HertzBound line(a, ellipse.total() / width / (pi / 2 * a));
    const JoinedRows rows(aspect, std::max<Index>(4, std::lround(size / a)),
                          std::max<Index>(10, std::lround(size * a)));
    const PatchResponse response(rows, poisson_ratio);
    for (const Index along : {0, 1}) {
      const Material tangential = along == 0 ? material : lateral(material);
      const double sliding = ellipse.total() / -response.linear()(along, along);
      for (const double load : {0.01, 0.3, 0.6, 1.0, 1.5}) {
        SteadyPatch patch{.material = material,
                          .bound = ellipse,
                          .rows = rows.rows(),
                          .elements = rows.elements()};
        patch.load[static_cast<std::size_t>(along)].value = -load * sliding;
        const double force = solve_steady(patch, response).resultants[along] / ellipse.total();
        const double strip = relative_force(StripKernel(tangential, width), line, -load * sliding);
        const double plane =
            relative_force(PlaneKernel(tangential, 100 * a), line, -load * sliding);
        found.push_back({aspect, along == 0 ? "longitudinal" : "lateral", load, force, strip, plane,
                         strip - force, plane - force});
      }
    }
    advance();
  }
  // The rows of a curve over a/b follow one another.
  std::ranges::stable_sort(found, {}, [](const auto& row) {
    return std::pair(std::get<std::string>(row[1]), std::get<double>(row[2]));
  });
  for (const auto& row : found) table.add(row);
  return table;
}

}  // namespace microslip::experiments
