// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/rolling/steady.hpp"

namespace microslip {

/// Makes a result of the contact of elements. The caller adds the displacement, the condition
/// number, and the evidence that belongs to its elements.
/// \param x       nodes of the elements  [mm]
/// \param values  of the elements, with tractions and slip of the contact
SteadySolution element_solution(const SteadyProblem& problem, const Eigen::VectorXd& x,
                                const ElementValues& values, const ContactState& contact);

}  // namespace microslip
