// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>

#include "microslip/experiments/contact_tables.hpp"
#include "microslip/experiments/scene_tables.hpp"
#include "microslip/support/format.hpp"

namespace microslip::experiments {

namespace {

Table cells(const SteadyPatchSolution& solution) {
  Table table("traction",
              "steady rolling of a patch, values at the centres of cells, from the leading edge "
              "on, row by row",
              {{"x", "mm", "position along the rolling; the leading edge is at x > 0"},
               {"y", "mm", "position across the rolling"},
               {"traction_x", "N/mm^2", "tangential traction along the rolling"},
               {"traction_y", "N/mm^2", "tangential traction across the rolling"},
               {"bound", "N/mm^2", "traction bound g"},
               {"slip_x", "1", "relative slip along the rolling"},
               {"slip_y", "1", "relative slip across the rolling"},
               {"zone", "1", "A adhesion, S slip"},
               {"area", "mm^2", "area of the cell"}});
  for (Eigen::Index i = 0; i < solution.x.size(); ++i) {
    table.add({solution.x[i], solution.y[i], solution.traction(i, 0), solution.traction(i, 1),
               solution.bound[i], solution.slip(i, 0), solution.slip(i, 1),
               solution.slips[static_cast<std::size_t>(i)] ? "S" : "A", solution.area[i]});
  }
  return table;
}

/// Sides of rows, and some between them where there are few.
Table edges(const SteadyPatch& patch) {
  Table table("edges", "the edges of the contact, and the rows that lie between its sides",
              {{"lobe", "1", "number of a part of the contact, from 1 on"},
               {"row", "1", "the row above this side, from 1 on; of the last side that below"},
               {"y", "mm", "position across the rolling"},
               {"trailing", "mm", "x of the trailing edge"},
               {"leading", "mm", "x of the leading edge"}});
  const JoinedRows rows(patch.bound.shape(), patch.rows, patch.elements);
  const Eigen::Index strips = patch.rows < 30 ? 4 : 1;
  const auto add = [&](Eigen::Index k, double psi) {
    const std::size_t l = rows.lobe(k);
    const Lobe& lobe = rows.shape().lobes()[l];
    const Lobe::Row row = lobe.row(psi);
    table.add({static_cast<Eigen::Index>(l + 1), k + 1, lobe.y(psi), row.middle - row.half_length,
               row.middle + row.half_length});
  };
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    const double half = rows.height(k) / 2;
    for (Eigen::Index i = 0; i < strips; ++i) {
      const auto part = static_cast<double>(2 * i) / static_cast<double>(strips);
      add(k, rows.psi(k) + (part - 1) * half);
    }
    if (k + 1 == rows.rows() || rows.lobe(k + 1) != rows.lobe(k)) add(k, rows.psi(k) + half);
  }
  return table;
}

/// Warns of a result that other rows and elements change.
std::optional<std::string> doubt_of(const SteadyPatchSolution& solution) {
  constexpr double doubtful = 0.03;
  if (solution.evidence.change <= doubtful) return std::nullopt;
  return fmt::format(
      "the change of the result from rows and elements that are a third fewer is {} of full "
      "sliding, and the error may be as large: take more of them",
      format_roughly(solution.evidence.change));
}

}  // namespace

std::vector<Table> scene_tables(const SteadyPatch& patch, const Progress& progress) {
  progress(0, 1);
  const SteadyPatchSolution solution = solve_steady_with_change(patch);
  progress(1, 1);
  const double area = solution.area.sum();
  const double full_sliding = patch.bound.total();
  Table summary = empty_summary("steady rolling, the whole contact");
  summary.add({"force", solution.resultants[0], "N"});
  summary.add({"lateral_force", solution.resultants[1], "N"});
  summary.add({"spin_moment", solution.resultants[2], "N mm"});
  summary.add({"creepage", solution.motion[0], "1"});
  summary.add({"lateral_creepage", solution.motion[1], "1"});
  summary.add({"spin", solution.motion[2], "1/mm"});
  summary.add({"force_ratio", solution.force() / full_sliding, "1"});
  summary.add({"full_sliding_force", full_sliding, "N"});
  summary.add({"adhesion_share", std::max(0.0, 1 - solution.slip_area() / area), "1"});
  summary.add({"slip_share", solution.slip_area() / area, "1"});
  summary.add({"dissipation", solution.dissipation, "N"});
  summary.add({"half_width", patch.bound.half_width(), "mm"});
  summary.add({"lateral_half_width", patch.bound.lateral_half_width(), "mm"});
  summary.add({"rows", patch.rows, "1"});
  summary.add({"elements", patch.elements, "1"});
  summary.add({"iterations", solution.iterations, "1"});
  add_evidence(summary, solution.evidence,
               {.condition = solution.condition,
                .iterations = solution.iterations,
                .accepted = patch.accepted,
                .steady = true,
                .doubt = doubt_of(solution)});
  return {cells(solution), edges(patch), summary};
}

}  // namespace microslip::experiments
