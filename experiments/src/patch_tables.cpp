// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_tables.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "microslip/patch/joined_rows.hpp"
#include "microslip/support/format.hpp"

namespace microslip::experiments {

Table patch_traction_table(const std::string& description, const PatchValues& values) {
  Table table(
      "traction", description,
      {{"x", "mm", "position along the rolling; the leading edge is at x > 0"},
       {"y", "mm", "position across the rolling"},
       {"traction_x", "N/mm^2", "tangential traction along the rolling"},
       {"traction_y", "N/mm^2", "tangential traction across the rolling"},
       {"bound", "N/mm^2", "traction bound g"},
       {"slip_x", "1", "relative slip along the rolling"},
       {"slip_y", "1", "relative slip across the rolling"},
       {"zone", "1", "A adhesion, S slip"},
       {"area", "mm^2",
        "area of the cell; a sum of traction times area is a midpoint rule, and no resultant"}});
  for (Eigen::Index i = 0; i < values.x.size(); ++i) {
    table.add({values.x[i], values.y[i], values.traction(i, 0), values.traction(i, 1),
               values.bound[i], values.slip(i, 0), values.slip(i, 1),
               values.slips[static_cast<std::size_t>(i)] ? "S" : "A", values.area[i]});
  }
  return table;
}

namespace {

Table empty_edges() {
  return {"edges",
          "the edges of the contact, and the rows that lie between its sides",
          {{"lobe", "1", "number of a part of the contact, from 1 on"},
           {"row", "1", "the row above this side, from 1 on; of the last side that below"},
           {"y", "mm", "position across the rolling"},
           {"trailing", "mm", "x of the trailing edge"},
           {"leading", "mm", "x of the leading edge"}}};
}

}  // namespace

Table rectangles_edges_table(const Eigen::VectorXd& x, const Eigen::VectorXd& y, double dx,
                             double dy) {
  Table table = empty_edges();
  Eigen::Index row = 0;
  for (Eigen::Index first = 0, next = 0; first < x.size(); first = next) {
    while (next < x.size() && y[next] == y[first]) ++next;
    const auto of_row = x.segment(first, next - first);
    ++row;
    for (const double side : {-dy / 2, dy / 2}) {
      table.add({1, row, y[first] + side, of_row.minCoeff() - dx / 2, of_row.maxCoeff() + dx / 2});
    }
  }
  return table;
}

Table patch_edges_table(const SteadyPatch& patch, double size) {
  Table table = empty_edges();
  const JoinedRows rows(patch.bound.shape(), patch.rows, patch.elements);
  const Eigen::Index strips = patch.rows < 30 ? 4 : 1;
  const auto add = [&](Eigen::Index k, double psi) {
    const std::size_t l = rows.lobe(k);
    const Lobe& lobe = rows.shape().lobes()[l];
    const Lobe::Row row = lobe.row(psi);
    table.add({static_cast<Eigen::Index>(l + 1), k + 1, size * lobe.y(psi),
               size * (row.middle - row.half_length), size * (row.middle + row.half_length)});
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

void add_patch_load(Table& summary, const Eigen::Vector3d& resultants,
                    const Eigen::Vector3d& motion, const PatchBound& bound) {
  const Rounding of_force{"value", rounding_of_resultants * bound.total()};
  const Rounding of_moment{"value", of_force.bound * bound.size()};
  summary.add({"force", resultants[0], "N"}, of_force);
  summary.add({"lateral_force", resultants[1], "N"}, of_force);
  summary.add({"spin_moment", resultants[2], "N mm"}, of_moment);
  summary.add({"creepage", motion[0], "1"});
  summary.add({"lateral_creepage", motion[1], "1"});
  summary.add({"spin", motion[2], "1/mm"});
}

void add_patch_shares(Table& summary, double full_sliding, double force, double slip_share) {
  summary.add({"force_ratio", full_sliding > 0 ? force / full_sliding : 0, "1"});
  summary.add({"full_sliding_force", full_sliding, "N"});
  summary.add({"adhesion_share", full_sliding > 0 ? std::max(0.0, 1 - slip_share) : 0, "1"});
  summary.add({"slip_share", slip_share, "1"});
}

void add_patch_sizes(Table& summary, const SteadyPatch& patch, double size) {
  summary.add({"half_width", size * patch.bound.half_width(), "mm"});
  summary.add({"lateral_half_width", size * patch.bound.lateral_half_width(), "mm"});
  summary.add({"rows", patch.rows, "1"});
  summary.add({"elements", patch.elements, "1"});
}

std::optional<std::string> doubt_of_patch(const Evidence& evidence) {
  constexpr double doubtful = 0.03;
  if (evidence.change <= doubtful) return std::nullopt;
  return fmt::format(
      "the change of the result from rows and elements that are a third fewer is {} of full "
      "sliding, or of a motion that follows from resultants, and the error may be as large: take "
      "more of them",
      format_roughly(evidence.change));
}

}  // namespace microslip::experiments
