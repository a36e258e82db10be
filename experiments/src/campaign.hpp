// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "microslip/experiments/cattaneo_to_carter.hpp"
#include "microslip/experiments/rule.hpp"
#include "microslip/reference/carter.hpp"
#include "microslip/rolling/chebyshev_rolling.hpp"
#include "microslip/rolling/steady.hpp"

namespace microslip::experiments {

/// \file
/// A campaign solves cases by schemes, each with several N, and holds what comes out against the
/// truth. What studies that do so have in common is here.

/// What a steady contact has, without the errors of a scheme.
struct Truth {
  double creepage;
  double force;                              ///< [N/mm]
  std::function<double(double x)> traction;  ///< [N/mm^2]

  Eigen::VectorXd at(const Eigen::VectorXd& x) const { return x.unaryExpr(traction); }
};

Truth truth_of(const Carter& carter);

/// By Chebyshev collocation, where that part of the contact sticks, under its creepage.
Truth truth_of(const ChebyshevRolling& rolling, double half_width, double stick_ratio);

/// A solution beside the truth.
struct Compared {
  SteadySolution solution;
  Eigen::VectorXd exact;  ///< traction at its nodes  [N/mm^2]
  double traction_error;  ///< integral of |p - exact| by the midpoint rule  [N/mm]
  double mean_error;      ///< of the tractions at the nodes, over the peak of the bound
  double force_error;     ///< relative
};

Compared compared(const SteadyProblem& problem, const Truth& truth);

/// What is left of a Cattaneo shift after rolling, and the creep on the way.
struct Rolled {
  Eigen::VectorXd x;
  Eigen::VectorXd traction;  ///< absolute values at the nodes
  Eigen::VectorXd distance;  ///< after each step, and 0
  Eigen::VectorXd creep;     ///< integral of |w| until there  [mm]
  double rounds = 0;         ///< partitions tried
};

/// \param elements  distance, in elements
Rolled roll(const CattaneoToCarter& start, const AdvectionScheme& scheme, double step_ratio,
            double elements);

enum class Status {
  ok,
  refused,      ///< as bad input
  no_solution,  ///< it did not converge
  not_run       ///< it would take too long
};

/// How a run with some N went.
struct Attempt {
  Status status = Status::not_run;
  std::string message;      ///< of what was thrown
  double expected = 0;      ///< operations, from those of smaller N; 0 without any
  double work = not_given;  ///< counted operations for a solution
  double time = not_given;  ///< of the processor for a solution, least of the repeats  [s]
};

/// Runs of one scheme on one case that differ in N, from few to many.
class Runs {
 public:
  struct Limits {
    double operations;     ///< of a run; what is expected to take more is not run
    double repeats = 0;    ///< runs are repeated until they took so long together  [s]
    double solutions = 1;  ///< that a run consists of
  };

  explicit Runs(const Limits& limits) : limits_(limits) {}

  Attempt run(double size, const std::function<void()>& solve);

 private:
  void measure(const std::function<void()>& solve, Attempt& attempt) const;

  Limits limits_;
  std::vector<double> sizes_;
  std::vector<double> work_;
};

}  // namespace microslip::experiments
