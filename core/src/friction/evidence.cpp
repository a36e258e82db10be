// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/evidence.hpp"

#include <string>

#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip {

void require_evidence(const Evidence& evidence, double condition, int iterations,
                      const Solver& accepted) {
  const auto check = [&](const std::string& name, double value, const std::string& key,
                         double limit) {
    if (value <= limit) return;
    throw NotConverged("the result's " + name + " is " + format_short(value) +
                           ": expected at most " + key + " = " + format_short(limit),
                       iterations, evidence.violation());
  };
  check("residual", evidence.residual, "solver.tolerance", accepted.tolerance);
  check("bound_violation", evidence.bound_violation, "solver.violation", accepted.violation);
  check("slip_violation", evidence.slip_violation, "solver.violation", accepted.violation);
  check("condition", condition, "solver.condition", accepted.condition);
}

}  // namespace microslip
