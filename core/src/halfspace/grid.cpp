// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/grid.hpp"

#include <fmt/core.h>

#include "microslip/support/require.hpp"

namespace microslip {

Grid::Grid(const Parameters& parameters) : parameters_(parameters) {
  const auto& [half_width, elements, leading, trailing] = parameters_;
  require_positive("half_width", half_width);
  require(elements >= 1 && elements <= max_elements, "elements", static_cast<double>(elements),
          "a whole number in [1, 4000000]");
  require(leading >= 0 && leading <= 1, "leading_offset", leading, "a number in [0, 1]");
  require(trailing >= 0 && trailing <= 1, "trailing_offset", trailing, "a number in [0, 1]");
  const double intervals = static_cast<double>(elements - 1) + leading + trailing;
  require(intervals > 0, "elements", static_cast<double>(elements),
          "at least 2 where both offsets are 0");
  spacing_ = 2 * half_width / intervals;
}

Grid Grid::with_elements(Eigen::Index elements) const {
  Parameters parameters = parameters_;
  parameters.elements = elements;
  return Grid(parameters);
}

Eigen::VectorXd Grid::nodes() const {
  // Positions are computed from the nearer edge, so that the grid is symmetric to rounding if the
  // offsets are equal.
  return Eigen::VectorXd::NullaryExpr(size(), [this](Eigen::Index i) {
    const double from_trailing = static_cast<double>(i) + parameters_.trailing_offset;
    const double from_leading = static_cast<double>(size() - 1 - i) + parameters_.leading_offset;
    return from_trailing < from_leading ? -half_width() + spacing_ * from_trailing
                                        : half_width() - spacing_ * from_leading;
  });
}

void require_filling(const Grid& grid, Eigen::Index fewest, const std::string& where) {
  require(grid.size() >= fewest, "elements", static_cast<double>(grid.size()),
          fmt::format("at least {} {}", fewest, where));
  require(grid.leading_offset() == 0.5, "leading_offset", grid.leading_offset(), "0.5 " + where);
  require(grid.trailing_offset() == 0.5, "trailing_offset", grid.trailing_offset(), "0.5 " + where);
}

}  // namespace microslip
