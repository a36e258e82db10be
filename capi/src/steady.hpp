// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "microslip.h"
#include "microslip/rolling/steady.hpp"
#include "status.hpp"

namespace microslip::capi {

/// Where values of one load at the nodes go; each may be null.
struct NodesOut {
  double* x;
  double* bound;
  double* traction;
  double* slip;
  double* displacement;

  /// \param nodes  may be null
  /// \param size   of a row
  NodesOut(const microslip_steady_nodes* nodes, std::size_t row, std::size_t size);
};

/// Says why the creepage that is largest in size is doubtful, as in "creepage = 1: ...". Empty if it
/// is not, and for forces.
std::string doubt_of_loads(const SteadyProblem& problem, int type, const double* loads,
                           std::size_t count);

/// Solves under a load of microslip_load. A load without a solution, or with none that is accepted,
/// has a status, a message, and no numbers.
/// \param problem  the load of which is replaced
microslip_steady solve_load(SteadyProblem problem, int type, double load, const NodesOut& nodes,
                            const Message& message) noexcept;

/// \throws std::invalid_argument unless it is one of microslip_load
void require_load_type(int type);

}  // namespace microslip::capi
