// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench.hpp"

#include <cmath>
#include <limits>

#include "growth.hpp"
#include "machine.hpp"
#include "peer.hpp"
#include "targets.hpp"

namespace microslip::bench {

namespace {

std::vector<Case> all_cases(const BenchParameters& p) {
  std::vector<Case> all;
  for (const auto& cases :
       {toeplitz_cases(p), steady_cases(p), transient_cases(p), patch_cases(p)}) {
    all.insert(all.end(), cases.begin(), cases.end());
  }
  return all;
}

Table times_table(const std::string& name, const std::string& description,
                  const std::vector<Measurement>& measurements) {
  Table table(
      name, description,
      {{"quantity", "1", "what is computed"},
       {"kernel", "1", "strip or plane; half_space of an ellipse"},
       {"method", "1", "by which way"},
       {"elements", "1", "number N of elements, of cells, or of unknowns of Chebyshev collocation"},
       {"time", "s", "of the processor"},
       {"real_time", "s", "the same unless others used the machine"},
       {"repeats", "1", "over which times are means"},
       {"iterations", "1", "of GMRES; partitions tried; evaluations of a curve"}});
  for (const auto& [subject, time, real_time, repeats, iterations] : measurements) {
    table.add({subject.quantity, subject.kernel, subject.method, subject.elements, time, real_time,
               repeats, iterations});
  }
  return table;
}

Table exponents_table(const std::vector<Series>& all) {
  Table table("exponents",
              "time ~ N^exponent: least squares of the logarithms over the largest decade of N",
              {{"quantity", "1", "what is computed"},
               {"kernel", "1", "strip or plane"},
               {"method", "1", "by which way"},
               {"from", "1", "least N in it"},
               {"to", "1", "largest N"},
               {"exponent", "1", "fitted"}});
  for (const Series& series : all) {
    if (const auto fitted = growth(series)) {
      table.add({series.quantity, series.kernel, series.method, fitted->from, fitted->to,
                 fitted->exponent});
    }
  }
  return table;
}

Table crossovers_table(const std::vector<Series>& all) {
  Table table("crossovers", "from which N on FFT takes less time than all entries",
              {{"quantity", "1", "what is computed"},
               {"kernel", "1", "strip or plane"},
               {"dense", "1", "the method with all entries"},
               {"fft", "1", "the method with FFT"},
               {"elements", "1", "N; 0 if FFT always does, nan if it never does"}});
  const auto add = [&](const std::string& quantity, const std::string& kernel,
                       const std::string& dense, const std::string& fft) {
    table.add({quantity, kernel, dense, fft,
               crossover(find(all, quantity, kernel, dense), find(all, quantity, kernel, fft))});
  };
  add("product", "strip", "dense", "fft");
  for (const std::string quantity : {"solve_plain", "solve_difference"}) {
    add(quantity, "strip", "lu", "gmres_circulant");
    add(quantity, "strip", "lu", "gohberg_semencul");
    add(quantity, "strip", "lu_apply", "gohberg_semencul_apply");
  }
  for (const std::string kernel : {"strip", "plane"}) {
    for (const std::string method : steady_by_elements) {
      add("steady", kernel, method + "_dense", method + "_fft");
    }
  }
  for (const std::string quantity : {"step", "rolling_by_force", "rolling_by_creepage"}) {
    for (const std::string scheme : transients) {
      add(quantity, "strip", scheme + "_dense", scheme + "_fft");
    }
  }
  return table;
}

}  // namespace

std::vector<Table> bench(const BenchParameters& p, const Progress& progress) {
  stay_on_one_core();
  // First, while this process is small.
  const Table memory = memory_table(p);
  const std::vector<Measurement> measured = by_series(measure(all_cases(p), p.timing, progress));
  const std::vector<Series> ours = series_of(measured);
  std::vector<Series> both = ours;
  for (const Series& series : series_of(peer_times())) both.push_back(series);
  return {machine_table(),
          times_table("times", "times on one core, see the table machine", measured),
          times_table("peer", peer_machine(), peer_times()),
          exponents_table(both),
          crossovers_table(ours),
          memory,
          targets_table(ours, memory)};
}

}  // namespace microslip::bench
