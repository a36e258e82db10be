// SPDX-License-Identifier: GPL-3.0-or-later
#include "speed_accuracy_runs.hpp"

#include <fmt/core.h>

#include "campaign.hpp"

namespace microslip::experiments::speed_accuracy_study {

namespace {

/// Begins the message about a combination of scheme, basis and solver that does not exist for any
/// number of elements.
const std::string not_there = "does not exist: ";

std::string status_of(const Attempt& attempt, double limit) {
  switch (attempt.status) {
    case Status::refused:
      return not_there + attempt.message;
    case Status::no_solution:
      return "not converged: " + attempt.message;
    case Status::not_run:
      return fmt::format("not run: about {:.1e} operations, limit {:.1e}", attempt.expected, limit);
    default:
      return "ok";
  }
}

}  // namespace

bool Contestant::of_thesis() const {
  const std::string& name = family();
  return name == "standard" || name == "direct" || name.starts_with("direct ");
}

std::vector<Run> runs_of(const RunSeries& series, double repeats) {
  std::vector<Run> all;
  Runs runs({.operations = series.operations, .repeats = repeats, .solutions = series.solutions});
  for (const Eigen::Index elements : series.sizes) {
    Run run{series.contestant, elements, {}};
    if (!all.empty() && all.back().status.starts_with(not_there)) {
      run.status = all.back().status;
    } else {
      std::function<Judgement()> judge;
      const Attempt attempt =
          runs.run(static_cast<double>(elements), [&] { judge = series.solve(elements); });
      run.status = status_of(attempt, series.operations);
      run.work = attempt.work;
      run.time = attempt.time;
      if (attempt.status == Status::ok) run.judgement = judge();
    }
    all.push_back(run);
  }
  return all;
}

std::string name_of(Solver::Type type) {
  switch (type) {
    case Solver::Type::dense:
      return "dense";
    case Solver::Type::fft:
      return "fft";
    case Solver::Type::automatic:
      break;
  }
  return "auto";
}

}  // namespace microslip::experiments::speed_accuracy_study
