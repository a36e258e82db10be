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
/// A campaign solves cases by schemes, each with several N, and compares the solutions with the
/// truth. The studies extremes, speed_accuracy, frequency_response, open_problems and leading_edge
/// are campaigns.

/// The Hertzian bound with the same half-width and force of full sliding.
HertzBound hertz_like(const PolynomialBound& bound);

/// The exact solution of a steady contact.
struct Truth {
  double creepage;
  double force;                              ///< [N/mm]
  std::function<double(double x)> traction;  ///< [N/mm^2]

  Eigen::VectorXd at(const Eigen::VectorXd& x) const { return x.unaryExpr(traction); }
};

Truth truth_of(const Carter& carter);

/// The solution by Chebyshev collocation.
/// \param stick_ratio  fraction of the contact that sticks
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

/// The amplitude of an error that alternates over four or more nodes in a row: half the least
/// difference between a node and the mean of its neighbours. It is 0 for a smooth error, an error
/// at an edge, and a flattened peak.
double wiggle_of(const Eigen::VectorXd& error);

/// A run from a Cattaneo shift on: the tractions at its end, creep and force on the way.
struct Rolled {
  Eigen::VectorXd x;
  Eigen::VectorXd traction;  ///< absolute values at the nodes
  Eigen::VectorXd distance;  ///< after each step, and 0
  Eigen::VectorXd creep;     ///< integral of |w| until there  [mm]
  Eigen::VectorXd force;     ///< at the same places  [N/mm]
  double rounds = 0;         ///< stick/slip partitions tried
};

/// \param elements  distance, in elements
Rolled roll(const CattaneoToCarter& start, const AdvectionScheme& scheme, double step_ratio,
            double elements, const Load& load);

/// The same under the force of the shift.
Rolled roll(const CattaneoToCarter& start, const AdvectionScheme& scheme, double step_ratio,
            double elements);

enum class Status {
  ok,
  refused,      ///< as bad input
  no_solution,  ///< no convergence
  not_run       ///< expected to take too long
};

/// ok, refused, no_solution or not_run
std::string name_of(Status status);

/// The outcome of a run.
struct Attempt {
  Status status = Status::not_run;
  std::string message;      ///< of the exception
  double expected = 0;      ///< operations, extrapolated from smaller N; 0 without any
  double work = not_given;  ///< counted operations for a solution
  double time = not_given;  ///< of the processor for a solution, least of the repeats  [s]
};

/// The runs of one scheme on one case, from few elements to many.
class Runs {
 public:
  struct Limits {
    double operations;     ///< a run that is expected to take more is left out
    double repeats = 0;    ///< a run is repeated until all repeats have taken so long  [s]
    double solutions = 1;  ///< number of solutions in a run
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
