// SPDX-License-Identifier: GPL-3.0-or-later
#include "start_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "microslip/support/format.hpp"
#include "microslip/support/interpolation.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Tolerance for positions, as a table may have been printed with few digits  [dx, or the distance
/// of two rows]
constexpr double printed_place = 1e-3;

bool are_nodes(const VectorXd& x, const VectorXd& nodes, double tolerance) {
  return x.size() == nodes.size() && (x - nodes).lpNorm<Eigen::Infinity>() <= tolerance;
}

/// The table's bound may have been an element mean, so that a traction is only rejected above the
/// largest bound within an element.
void require_within_bound_nearby(const VectorXd& x, const VectorXd& traction,
                                 const TransientProblem& problem) {
  const double half = problem.grid.spacing() / 2;
  const auto at = [&](double shift) {
    return bound_at(problem.contact.bound, x + VectorXd::Constant(x.size(), shift));
  };
  require_within_bound(x, at(-half).cwiseMax(at(0)).cwiseMax(at(half)), traction);
}

/// \param row     the first or the last within the contact
/// \param beyond  distance from that row to the outermost node beyond it
void require_reach(const VectorXd& x, Index row, Index neighbour, double beyond, double node) {
  const double distance = std::abs(x[row] - x[neighbour]);
  require(beyond <= (1 + printed_place) * distance, "x", x[row], [&] {
    return fmt::format(
        "rows up to the edges: the node at {} is farther from this one than the next row, {} mm",
        format_short(node), format_short(distance));
  });
}

void require_cover(const VectorXd& x, const std::vector<Index>& within,
                   const TransientProblem& problem) {
  const VectorXd nodes = problem.grid.nodes();
  const VectorXd bound = bound_at(problem.contact.bound, nodes);
  Index first = 0, last = nodes.size() - 1;
  while (first < last && bound[first] <= 0) ++first;
  while (last > first && bound[last] <= 0) --last;
  const Index begin = within.front(), end = within.back();
  require_reach(x, begin, std::min(begin + 1, x.size() - 1), x[begin] - nodes[first], nodes[first]);
  require_reach(x, end, std::max<Index>(end - 1, 0), nodes[last] - x[end], nodes[last]);
}

}  // namespace

VectorXd traction_at_nodes(const VectorXd& x, const VectorXd& traction,
                           const TransientProblem& problem) {
  const VectorXd nodes = problem.grid.nodes();
  for (Index i = 1; i < x.size(); ++i) {
    require(x[i] > x[i - 1], "x", x[i], "ascending positions");
  }
  if (are_nodes(x, nodes, printed_place * problem.grid.spacing())) {
    require_within_bound(nodes, bound_at(problem.contact.bound, nodes), traction);
    return traction;
  }
  require_within_bound_nearby(x, traction, problem);
  const VectorXd bound = bound_at(problem.contact.bound, x);
  std::vector<Index> within;
  for (Index i = 0; i < x.size(); ++i) {
    if (bound[i] > 0) within.push_back(i);
  }
  require(!within.empty(), "number of rows", 0, "at least one where the bound is not zero");
  require_cover(x, within, problem);
  const VectorXd ratios = (traction.array() / bound.array()).cwiseMax(-1).cwiseMin(1);
  return bound_at(problem.contact.bound, nodes)
      .cwiseProduct(interpolated(x(within), ratios(within), nodes));
}

}  // namespace microslip
