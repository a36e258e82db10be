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

/// Identity of a run; "none" or nan for a property without a role.
struct Contestant {
  std::string problem;  ///< plane, strip, transient or cylinder
  std::string scheme;
  std::string edge;
  std::string basis;
  double step_ratio;
  std::string solver;
};

enum class Quantity { force, creep, traction, peak, energy, motion };
inline constexpr std::array quantity_names = {"force", "creep",  "traction",
                                              "peak",  "energy", "motion"};

/// Relative errors, nan where a problem does not have the quantity.
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

/// Solves with N elements; calling the result judges.
using Solve = std::function<std::function<Judgement()>(Eigen::Index elements)>;

struct RunSeries {
  Contestant contestant;
  std::vector<Eigen::Index> sizes;
  WorkLimit limit;
  double solutions;  ///< that a run consists of
  Solve solve;
};

struct Run {
  Contestant contestant;
  Eigen::Index elements;
  Judgement judgement;
  double work = not_given;  ///< counted operations for a solution
  double time = not_given;  ///< least of the repeats, for a solution  [s]
  std::string status = "ok";
};

/// All sizes of a series, one after the other. What throws says so in its status; what is not run
/// because it is expected to exceed the limit, too.
std::vector<Run> runs_of(const RunSeries& series, double repeats);

std::string name_of(Solver::Type type);

}  // namespace microslip::experiments::speed_accuracy_study
