// SPDX-License-Identifier: GPL-3.0-or-later
#include "speed_accuracy_runs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <stdexcept>

#include "microslip/support/not_converged.hpp"
#include "microslip/support/work.hpp"

namespace microslip::experiments {

namespace {

/// A combination of a scheme with a basis or solver, of any size.
const std::string not_there = "does not exist: ";

/// Runs that take longer are not repeated  [s]
constexpr double long_run = 2;

std::string with_two_digits(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1e", value);
  return text.data();
}

/// The time, work and judgement of a run. Of the processor: what else it has to do does not count.
void measure(const RunSeries& series, double repeats, Run& run) {
  double total = 0;
  do {
    const WorkCount count;
    const std::clock_t start = std::clock();
    const auto judge = series.solve(run.elements);
    const double time = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    run.work = count.operations() / series.solutions;
    run.time = std::fmin(run.time, time / series.solutions);
    total += time;
    if (total >= repeats || total >= long_run) run.judgement = judge();
  } while (total < repeats && total < long_run);
}

}  // namespace

double expected_work(const std::vector<double>& sizes, const std::vector<double>& work,
                     double elements) {
  if (work.empty()) return 0;
  const std::size_t last = work.size() - 1;
  double power = 2;
  if (last > 0) {
    power = std::log(work[last] / work[last - 1]) / std::log(sizes[last] / sizes[last - 1]);
  }
  return work[last] * std::pow(elements / sizes[last], std::clamp(power, 1.0, 3.0));
}

std::vector<Run> runs_of(const RunSeries& series, double repeats) {
  std::vector<Run> runs;
  std::vector<double> sizes, work;
  for (const Eigen::Index elements : series.sizes) {
    Run run{series.contestant, elements, {}};
    if (!runs.empty() && runs.back().status.starts_with(not_there)) {
      run.status = runs.back().status;
      runs.push_back(run);
      continue;
    }
    const auto n = static_cast<double>(elements);
    const double expected = expected_work(sizes, work, n);
    if (expected > series.limit.operations) {
      run.status = "not run: about " + with_two_digits(expected) + " operations, limit " +
                   with_two_digits(series.limit.operations);
      runs.push_back(run);
      continue;
    }
    const WorkCount count;
    try {
      measure(series, repeats, run);
    } catch (const std::invalid_argument& error) {
      run.status = not_there + error.what();
    } catch (const NotConverged& error) {
      run.status = std::string("not converged: ") + error.what();
    }
    sizes.push_back(n);
    work.push_back(run.status == "ok" ? run.work : count.operations() / series.solutions);
    runs.push_back(run);
  }
  return runs;
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

}  // namespace microslip::experiments
