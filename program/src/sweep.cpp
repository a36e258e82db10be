// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/program/sweep.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <new>
#include <stdexcept>

#include "command_line.hpp"
#include "interrupts.hpp"
#include "microslip/support/parallel.hpp"
#include "microslip/support/shown.hpp"
#include "outputs.hpp"
#include "process.hpp"
#include "provenance.hpp"
#include "sweep_folder.hpp"
#include "sweep_options.hpp"
#include "sweep_plan.hpp"
#include "sweep_progress.hpp"

namespace microslip::program {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* sweep_purpose =
    "solves all cases of a scene with a section 'sweep', except for cases that are already solved";
constexpr const char* solved = "ok";  // status of a case
constexpr const char* merge_purpose = "puts the cases of a sweep into one table, sweep.tsv";

CaseResult solve(const Work& work, const Progress& progress) {
  try {
    return {work(progress), solved};
  } catch (const std::bad_alloc&) {  // not of the case, but of what else the machine does
    throw;
  } catch (const std::exception& error) {
    return {{}, one_line(error)};
  }
}

/// The cases of a shard, with the results that are known.
struct Outcome {
  std::vector<std::size_t> cases;
  std::vector<std::string> statuses;
  std::size_t finished_before = 0;
};

Outcome solve_cases(const Program& program, const SweepPlan& plan, const SweepFolder& folder,
                    const SweepSettings& settings, Interrupts& interrupts) {
  const Shard shard = settings.shard.value_or(Shard{1, 1});
  Outcome outcome;
  std::vector<std::size_t> open;
  for (std::size_t i = shard.number - 1; i < plan.cases.size(); i += shard.count) {
    const auto status = folder.finished(i, plan.cases[i].parameters, settings.keeps_tables);
    if (!status) open.push_back(outcome.cases.size());
    outcome.cases.push_back(i);
    outcome.statuses.push_back(status.value_or(""));
  }
  outcome.finished_before = outcome.cases.size() - open.size();
  const auto failed = static_cast<std::size_t>(std::ranges::count_if(
      outcome.statuses, [](const auto& status) { return !status.empty() && status != solved; }));
  SweepProgress progress(program.name, settings.quiet, outcome.finished_before, failed,
                         outcome.cases.size());
  const auto solve_open = [&](std::size_t k) {
    const std::size_t i = outcome.cases[open[k]];
    const CaseResult result = solve(plan.cases[i].work, progress.begin(i + 1));
    interrupts.critical([&] {
      folder.finish(i, plan.cases[i].parameters, result, settings.keeps_tables);
      outcome.statuses[open[k]] = result.status;
      progress.end(i + 1, result.status == solved);
    });
  };
  try {
    for_each_case(open.size(), settings.threads, solve_open);
  } catch (const std::bad_alloc&) {
    throw std::runtime_error(fmt::format(
        "not enough memory for {} cases at once; solved cases are kept, --threads 1 may continue",
        settings.threads));
  }
  return outcome;
}

/// Cases that are warned of alike.
struct WarnedCases {
  std::string kind;        ///< the warning's key and doubt, without its value
  std::size_t count = 0;   ///< of cases
  std::size_t latest = 0;  ///< number of the last one
  std::string first;       ///< the first one with its warning
};

/// A line on stderr for each kind of warning: how many cases have it, and the first of them.
void report_warnings(const Program& program, const SweepPlan& plan) {
  std::vector<WarnedCases> kinds;
  for (std::size_t i = 0; i < plan.cases.size(); ++i) {
    for (const auto& [name, line] : plan.cases[i].parameters) {
      if (name != "warning") continue;
      const std::string kind = kind_of_warning(line);
      auto found = std::ranges::find(kinds, kind, &WarnedCases::kind);
      if (found == kinds.end()) {
        const std::string first = fmt::format("{}: {}", case_label(plan.table, i), line);
        found = kinds.insert(kinds.end(), {.kind = kind, .first = first});
      }
      if (found->count == 0 || found->latest != i) ++found->count;
      found->latest = i;
    }
  }
  constexpr std::size_t most_lines = 10;
  for (std::size_t k = 0; k < std::min(most_lines, kinds.size()); ++k) {
    std::cerr << program.name << ": warning: " << kinds[k].count << " of " << plan.cases.size()
              << " cases, the first is " << kinds[k].first << '\n';
  }
  if (kinds.size() > most_lines) {
    std::cerr << program.name << ": warning: and " << kinds.size() - most_lines
              << " other warnings, which stand in the tables of the cases\n";
  }
}

/// The exit status, with one line on stderr if a case has no solution.
int report_failures(const Program& program, const Table& plan, const Outcome& outcome) {
  const auto failed = [](const std::string& status) { return status != solved; };
  const auto& statuses = outcome.statuses;
  const auto first = std::find_if(statuses.begin(), statuses.end(), failed);
  if (first == statuses.end()) return 0;
  std::cerr << program.name << ": " << std::count_if(first, statuses.end(), failed) << " of "
            << statuses.size() << " cases have no solution, the first is "
            << case_label(plan, outcome.cases[static_cast<std::size_t>(first - statuses.begin())])
            << ": " << *first << '\n';
  return 2;
}

/// Writes sweep.tsv, and returns what became of the cases.
/// \param origin  the text of provenance.txt, asked for when the rest is done
Outcome write_merged(const Program& program, const SweepFolder& folder, const fs::path& out,
                     const std::function<std::string()>& origin, Interrupts& interrupts) {
  const MergedSweep merged = folder.merged();
  const OutputFile table = output_of(merged.table, program.name, merged.parameters);
  const OutputFile provenance = provenance_of(origin(), {table});
  interrupts.last([&] { write_files(out, {table, provenance}); });
  Outcome outcome{.cases = {}, .statuses = merged.statuses};
  for (std::size_t i = 0; i < merged.statuses.size(); ++i) outcome.cases.push_back(i);
  return outcome;
}

int sweep_scene(const Program& program, const Given& given, int argc, const char* const* argv) {
  const auto start = Clock::now();
  const SweepSettings settings = sweep_settings(given);
  Interrupts interrupts(program.name +
                        ": interrupted; solved cases are kept, and the same command continues");
  require_writable(settings.out);
  const SweepPlan plan = plan_of(program, read_scene(program, given));
  std::optional<SweepFolder> folder;
  interrupts.critical(
      [&] { folder = SweepFolder::begin(settings.out, program.name, plan.table, plan.common); });
  const Outcome outcome = solve_cases(program, plan, *folder, settings, interrupts);
  const auto origin = [&] { return provenance(program.name, argc, argv, Clock::now() - start); };
  if (settings.shard) {
    const OutputFile file{
        fmt::format("provenance_{}_of_{}.txt", settings.shard->number, settings.shard->count),
        origin()};
    interrupts.last([&] { write_files(settings.out, {file}); });
  } else {
    write_merged(program, *folder, settings.out, origin, interrupts);
  }
  if (!settings.quiet) {
    std::cout << program.name << ": " << outcome.cases.size() << " cases, "
              << outcome.finished_before << " of them finished before; tables in "
              << shown(settings.out.string()) << '\n';
  }
  report_warnings(program, plan);
  return report_failures(program, plan.table, outcome);
}

}  // namespace

int sweep(const Program& program, int argc, const char* const* argv) {
  return run_process(program.name, [&] {
    const Options known = sweep_options(program);
    const Given given = parse(known, argc - 1, argv + 1, "scene");
    if (answers(given, known, program.name + " sweep", sweep_purpose)) return 0;
    return sweep_scene(program, given, argc, argv);
  });
}

int merge(const Program& program, int argc, const char* const* argv) {
  return run_process(program.name, [&] {
    const auto start = Clock::now();
    Options known("Options of merge");
    add_common_options(known, default_sweep_out);
    const Given given = parse(known, argc - 1, argv + 1);
    if (answers(given, known, program.name + " merge", merge_purpose)) return 0;
    const fs::path out = given["out"].as<std::string>();
    Interrupts interrupts(program.name + " merge: interrupted, nothing is written");
    const SweepFolder folder = SweepFolder::open(out, program.name);
    const auto origin = [&] { return provenance(program.name, argc, argv, Clock::now() - start); };
    const Outcome outcome = write_merged(program, folder, out, origin, interrupts);
    return report_failures(program, folder.plan(), outcome);
  });
}

}  // namespace microslip::program
