// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "microslip/experiments/claims.hpp"
#include "microslip/experiments/speed_accuracy.hpp"
#include "microslip/linalg/solver.hpp"

namespace microslip::experiments::speed_accuracy_study {

/// Identity of a run; a property without a role is "none" or nan.
struct Contestant {
  std::string problem;  ///< plane, strip, transient, creepage or cylinder
  std::string scheme;
  std::string edge;
  std::string basis;
  double step_ratio;
  std::string solver;

  /// The scheme as a reader knows it: its edge treatment, or what solves without elements, or
  /// `step.scheme`; of any basis, step ratio and solver.
  const std::string& family() const { return scheme == "collocation" ? edge : scheme; }

  /// Whether the thesis computes by this scheme.
  bool of_thesis() const;
};

enum class Quantity { force, creep, noise, traction, peak, energy, motion };
inline constexpr std::array quantity_names = {"force", "creep",  "noise", "traction",
                                              "peak",  "energy", "motion"};

/// Relative errors; nan if a problem does not have the quantity.
struct Errors {
  std::array<double, quantity_names.size()> values;

  Errors() { values.fill(not_given); }
  double& operator[](Quantity of) { return values[static_cast<std::size_t>(of)]; }
};

/// Errors of a solution; computed after the timing.
struct Judgement {
  Errors errors;
  double rounds = 0;  ///< partitions tried, or systems solved
};

/// Solves with N elements. The function that is returned compares the solution with the truth.
using Solve = std::function<std::function<Judgement()>(Eigen::Index elements)>;

struct RunSeries {
  Contestant contestant;
  std::vector<Eigen::Index> sizes;
  double operations;  ///< a run that is expected to take more is left out
  double solutions;   ///< number of solutions in a run
  Solve solve;
};

struct Run {
  Contestant contestant;
  Eigen::Index elements;
  Judgement judgement;
  double work = not_given;  ///< counted operations for a solution
  double time = not_given;  ///< for a solution, the least of the repeats  [s]
  std::string status = "ok";
};

/// Runs all sizes of a series, one after the other. The status of a run tells if it threw, or was
/// left out because it was expected to exceed the limit.
std::vector<Run> runs_of(const RunSeries& series, double repeats);

std::string name_of(Solver::Type type);

}  // namespace microslip::experiments::speed_accuracy_study
