// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "suite.hpp"

namespace microslip::bench {

/// A time against N.
struct Series {
  std::string quantity;
  std::string kernel;
  std::string method;
  std::vector<double> elements;  ///< ascending
  std::vector<double> times;     ///< [s]

  /// At this N; nan if it was not measured  [s]
  double at(Eigen::Index n) const;
};

/// With the rows of each series together, in the order in which these begin.
std::vector<Measurement> by_series(const std::vector<Measurement>& measurements);

/// In the order in which they begin.
std::vector<Series> series_of(const std::vector<Measurement>& measurements);

/// Without times if there is no such series.
Series find(const std::vector<Series>& series, const std::string& quantity,
            const std::string& kernel, const std::string& method);

/// Time ~ N^exponent, by least squares of the logarithms.
struct Growth {
  double from;  ///< least N in it
  double to;    ///< largest
  double exponent;
};

/// The growth over from <= N <= to; none for fewer than two times.
std::optional<Growth> growth(const Series& series, double from, double to);

/// The growth over the largest decade.
std::optional<Growth> growth(const Series& series);

/// The N above which the second series takes less time. It is interpolated as a power law, between
/// the largest N at which the first series is faster and the next N; 0 if the second series is
/// always faster, and nan if it is slower at the last common N.
double crossover(const Series& first, const Series& second);

}  // namespace microslip::bench
