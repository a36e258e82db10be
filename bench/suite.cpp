// SPDX-License-Identifier: GPL-3.0-or-later
#include "suite.hpp"

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace microslip::bench {

namespace {

std::string name_of(const Subject& subject) {
  return fmt::format("{}/{}/{}/{}", subject.quantity, subject.kernel, subject.method,
                     subject.elements);
}

/// Google Benchmark calls a benchmark several times with more and more repeats; what was prepared
/// is kept in between, and only for one case, because it may be large.
class Prepared {
 public:
  const Work& of(const Case& which) {
    if (which_ != &which) {
      work_ = nullptr;
      work_ = which.prepare();
      which_ = &which;
    }
    return work_;
  }

 private:
  const Case* which_ = nullptr;
  Work work_;
};

void repeat(benchmark::State& state, const Case& which, Prepared& prepared) {
  try {
    const Work& work = prepared.of(which);
    double iterations = 0;
    for ([[maybe_unused]] auto turn : state) iterations += work();
    state.counters["iterations"] = {iterations, benchmark::Counter::kAvgIterations};
  } catch (const std::exception& error) {
    state.SkipWithError(error.what());
  }
}

class Collector : public benchmark::BenchmarkReporter {
 public:
  Collector(const std::vector<Case>& cases, const Progress& progress) : progress_(progress) {
    for (const Case& one : cases) subjects_.emplace(name_of(one.subject), one.subject);
  }

  const std::vector<Measurement>& measurements() const { return measurements_; }

  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& reported) override {
    std::vector<Run> runs;
    for (const Run& run : reported) {
      if (run.error_occurred) {
        throw std::runtime_error(
            fmt::format("{}: {}", run.run_name.function_name, run.error_message));
      }
      if (run.run_type == Run::RT_Iteration) runs.push_back(run);
    }
    if (runs.empty()) return;  // means and the like of runs that were reported before
    std::sort(runs.begin(), runs.end(), [](const Run& one, const Run& other) {
      return one.GetAdjustedCPUTime() < other.GetAdjustedCPUTime();
    });
    const Run& median = runs.at((runs.size() - 1) / 2);
    measurements_.push_back({.subject = subjects_.at(median.run_name.function_name),
                             .time = median.GetAdjustedCPUTime(),
                             .real_time = median.GetAdjustedRealTime(),
                             .repeats = static_cast<double>(median.iterations),
                             .iterations = median.counters.at("iterations")});
    progress_(measurements_.size(), std::max(subjects_.size(), measurements_.size()));
  }

 private:
  std::map<std::string, Subject> subjects_;
  std::vector<Measurement> measurements_;
  Progress progress_;
};

}  // namespace

std::vector<Measurement> measure(const std::vector<Case>& cases, const Timing& timing,
                                 const Progress& progress) {
  Prepared prepared;
  for (const Case& one : cases) {
    const auto run = [&one, &prepared](benchmark::State& state) { repeat(state, one, prepared); };
    const bool once = one.subject.elements >= timing.once_from;
    benchmark::RegisterBenchmark(name_of(one.subject).c_str(), run)
        ->MinTime(timing.least_time)
        ->Repetitions(once ? 1 : timing.repetitions)
        ->Unit(benchmark::kSecond);
  }
  Collector collector(cases, progress);
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  return collector.measurements();
}

}  // namespace microslip::bench
