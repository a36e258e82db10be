// SPDX-License-Identifier: GPL-3.0-or-later
#include "targets.hpp"

#include <cmath>
#include <string>

namespace microslip::bench {

namespace {

class Targets {
 public:
  void add(const std::string& target, const std::string& kernel, const std::string& method,
           double measured, double limit, const std::string& unit) {
    if (std::isnan(measured)) return;
    table_.add({target, kernel, method, measured, limit, unit, measured <= limit ? "yes" : "no"});
  }

  const Table& table() const { return table_; }

 private:
  Table table_{"targets",
               "what was aimed at, on one thread, and what was measured",
               {{"target", "1", "what is limited"},
                {"kernel", "1", "strip or plane; half_space of an ellipse"},
                {"method", "1", "by which way"},
                {"measured", "1", "in the unit of the row"},
                {"limit", "1", "likewise"},
                {"unit", "1", "of both"},
                {"met", "1", "yes or no"}}};
};

void add_steady(Targets& targets, const std::vector<Series>& all, const std::string& kernel,
                const std::string& method) {
  const Series series = find(all, "steady", kernel, method + "_fft");
  targets.add("steady, N = 800", kernel, method, series.at(800), 3e-3, "s");
  targets.add("steady, N = 6400", kernel, method, series.at(6400), 50e-3, "s");
  targets.add("steady, N = 10^6", kernel, method, series.at(1000000), 60, "s");
  if (const auto fitted = growth(series, 1e4, 1e6); fitted && fitted->to == 1e6) {
    targets.add("steady, exponent from N = 10^4 to 10^6", kernel, method, fitted->exponent, 1.2,
                "1");
  }
}

}  // namespace

Table targets_table(const std::vector<Series>& series, const Table& memory) {
  Targets targets;
  for (const std::string kernel : {"strip", "plane"}) {
    for (const std::string method : steady_by_elements) {
      add_steady(targets, series, kernel, method);
    }
  }
  for (const std::string method : steady_by_elements) {
    const double peak = memory.latest({{"method", method}, {"elements", 1e6}}, "peak_memory");
    targets.add("steady, N = 10^6, memory", "strip", method, peak / std::pow(2, 30), 2, "GiB");
  }
  for (const std::string scheme : transients) {
    const auto time = [&](const std::string& quantity, Eigen::Index n) {
      return find(series, quantity, "strip", scheme + "_fft").at(n);
    };
    targets.add("step, partition unchanged, N = 12800", "strip", scheme, time("step", 12800), 5e-3,
                "s");
    targets.add("N steps by force, N = 1600", "strip", scheme, time("rolling_by_force", 1600), 1,
                "s");
    targets.add("N steps by creepage, N = 1600", "strip", scheme, time("rolling_by_creepage", 1600),
                1, "s");
  }
  const Series step = find(series, "ellipse_step", "half_space", "remembered");
  targets.add("ellipse, step, partition unchanged, 100 cells", "half_space", "remembered",
              step.at(100), 1e-4, "s");
  targets.add("ellipse, step, partition unchanged, 196 cells", "half_space", "remembered",
              step.at(196), 5e-4, "s");
  return targets.table();
}

}  // namespace microslip::bench
