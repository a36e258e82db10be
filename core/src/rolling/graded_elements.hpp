// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/rolling/steady.hpp"

namespace microslip {

/// Elements of unequal lengths that fill the contact: ends of the elements, ascending  [mm]
using ElementEnds = std::vector<double>;

/// The solution on given elements: constant tractions, differences of the displacement from node to
/// node, the nodes being the middles of the elements, and exact means of the bound.
struct GradedState {
  ElementEnds ends;
  ContactState state;
};

/// The elements to begin with: they end at the rows of a table and where the bound begins and ends;
/// a piece has several elements, and neighbours have similar lengths.
/// \param fewest  elements over the contact
ElementEnds graded_elements(const TractionBound& bound, Eigen::Index fewest);

/// Solves, and halves the elements at the ends of zones until they resolve the zones, or until
/// there are `most` elements.
/// \throws NotConverged as ActiveSet
GradedState solve_graded(const SteadyProblem& problem, ElementEnds ends, Eigen::Index most);

/// The solution as a result: values at the middles of the elements.
SteadySolution graded_solution(const SteadyProblem& problem, const GradedState& graded);

}  // namespace microslip
