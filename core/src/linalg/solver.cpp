// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/solver.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

bool by_fft(const Solver& solver, Eigen::Index n) {
  if (solver.type != Solver::Type::automatic) return solver.type == Solver::Type::fft;
  return n >= Solver::crossover;
}

void require_dense(Eigen::Index n) {
  const double rows = static_cast<double>(n);
  require(n <= Solver::most_dense, "elements", rows, [&] {
    return fmt::format("at most {} where matrices are dense; one takes {:.0f} GB",
                       Solver::most_dense, std::ceil(8 * rows * rows / 1e9));
  });
}

void validate(const Solver& solver) {
  require(solver.tolerance >= 1e-12 && solver.tolerance <= 1e-3, "tolerance", solver.tolerance,
          "a number in [1e-12, 1e-3]");
}

}  // namespace microslip
