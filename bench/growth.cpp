// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "microslip/support/convergence.hpp"

namespace microslip::bench {

namespace {

/// Whether a subject or a series has these three names.
template <class Named>
bool is_of(const Named& one, const std::string& quantity, const std::string& kernel,
           const std::string& method) {
  return one.quantity == quantity && one.kernel == kernel && one.method == method;
}

}  // namespace

double Series::at(Eigen::Index n) const {
  const auto found = std::find(elements.begin(), elements.end(), static_cast<double>(n));
  if (found == elements.end()) return std::numeric_limits<double>::quiet_NaN();
  return times[static_cast<std::size_t>(found - elements.begin())];
}

std::vector<Measurement> by_series(const std::vector<Measurement>& measurements) {
  std::vector<Measurement> sorted;
  std::vector<Measurement> rest = measurements;
  while (!rest.empty()) {
    const Subject first = rest.front().subject;
    const auto others =
        std::stable_partition(rest.begin(), rest.end(), [&](const Measurement& one) {
          return is_of(one.subject, first.quantity, first.kernel, first.method);
        });
    sorted.insert(sorted.end(), rest.begin(), others);
    rest.erase(rest.begin(), others);
  }
  return sorted;
}

std::vector<Series> series_of(const std::vector<Measurement>& measurements) {
  std::vector<Series> all;
  for (const auto& [subject, time, real_time, repeats, iterations] : by_series(measurements)) {
    const auto& [quantity, kernel, method, elements] = subject;
    if (all.empty() || !is_of(all.back(), quantity, kernel, method)) {
      all.push_back({quantity, kernel, method, {}, {}});
    }
    all.back().elements.push_back(static_cast<double>(elements));
    all.back().times.push_back(time);
  }
  return all;
}

Series find(const std::vector<Series>& series, const std::string& quantity,
            const std::string& kernel, const std::string& method) {
  for (const Series& one : series) {
    if (is_of(one, quantity, kernel, method)) return one;
  }
  return {quantity, kernel, method, {}, {}};
}

std::optional<Growth> growth(const Series& series, double from, double to) {
  std::vector<double> elements, times;
  for (std::size_t i = 0; i < series.elements.size(); ++i) {
    if (series.elements[i] < from || series.elements[i] > to) continue;
    elements.push_back(series.elements[i]);
    times.push_back(series.times[i]);
  }
  if (elements.size() < 2) return std::nullopt;
  return Growth{elements.front(), elements.back(), -fitted_order(elements, times)};
}

std::optional<Growth> growth(const Series& series) {
  return growth(series, series.elements.back() / 10, series.elements.back());
}

double crossover(const Series& first, const Series& second) {
  double slower = 0, slower_ratio = 0;         // largest N at which the second is slower, so far
  double faster = HUGE_VAL, faster_ratio = 0;  // the next one
  for (std::size_t i = 0; i < first.elements.size(); ++i) {
    const double n = first.elements[i];
    const double ratio = std::log(second.at(static_cast<Eigen::Index>(n)) / first.times[i]);
    if (std::isnan(ratio)) continue;
    if (ratio >= 0) {
      slower = n;
      slower_ratio = ratio;
      faster = HUGE_VAL;
    } else if (faster == HUGE_VAL) {
      faster = n;
      faster_ratio = ratio;
    }
  }
  if (faster == HUGE_VAL) return std::numeric_limits<double>::quiet_NaN();
  if (slower == 0) return 0;
  return slower * std::pow(faster / slower, slower_ratio / (slower_ratio - faster_ratio));
}

}  // namespace microslip::bench
