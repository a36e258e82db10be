// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/friction/active_set.hpp"
#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/kernel.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "suite.hpp"

namespace microslip::bench {

using Sizes = std::vector<Eigen::Index>;

struct NamedKernel {
  std::string name;
  Kernel kernel;
};

/// The problem, the numbers N of elements, and how long to measure.
struct BenchParameters {
  HertzBound bound;
  std::vector<NamedKernel> kernels;  ///< strip, plane
  PrescribedForce force;
  PrescribedCreepage creepage;
  double tolerance;  ///< of GMRES where it solves alone  [1]

  Sizes parts;     ///< of influence coefficients, products and solves
  Sizes steady;    ///< of steady rolling
  Sizes unknowns;  ///< of Chebyshev collocation
  Sizes step;      ///< of a transient step
  Sizes rolling;   ///< of N transient steps
  Sizes ellipse;   ///< of joined rows, and of cells of each
  Sizes memory;    ///< of steady rolling in a process of its own

  // The largest N with dense matrices.
  Eigen::Index dense_product, dense_solve, dense_steady, dense_step, dense_rolling;

  Timing timing;

  const Kernel& strip() const { return kernels.front().kernel; }
};

/// Keys as in study.info.
BenchParameters read_bench(Scene& scene);

/// Influence coefficients, products with them, and solves of systems of them.
std::vector<Case> toeplitz_cases(const BenchParameters& p);

/// Steady rolling, and points of creepage-force curves.
std::vector<Case> steady_cases(const BenchParameters& p);

/// Steps of transient rolling that leave the partition as it is, and N steps from a Cattaneo shift.
std::vector<Case> transient_cases(const BenchParameters& p);

/// Steady rolling of a circle by joined rows.
std::vector<Case> patch_cases(const BenchParameters& p);

/// Peak memory of steady rolling, each in a process of its own.
Table memory_table(const BenchParameters& p);

/// Tables: machine, times, peer (CONTACT's times), exponents, crossovers, memory, targets.
/// The process stays on one core.
std::vector<Table> bench(const BenchParameters& p, const Progress& progress);

}  // namespace microslip::bench
