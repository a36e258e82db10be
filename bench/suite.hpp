// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "microslip/support/progress.hpp"

namespace microslip::bench {

/// Schemes that are timed by FFT and with all entries, as the catalogue names them.
inline constexpr std::array steady_by_elements = {"standard", "calibrated"};
inline constexpr std::array transients = {"direct", "remembered"};

/// The subject of a measurement.
struct Subject {
  std::string quantity;  ///< what is computed
  std::string kernel;    ///< strip or plane
  std::string method;    ///< the algorithm or scheme
  Eigen::Index elements;
};

/// The timed work. Returns the number of iterations, of any kind; 0 without iterations.
using Work = std::function<double()>;

/// A case to time. `prepare` makes the data for the work, and is not timed.
struct Case {
  Subject subject;
  std::function<Work()> prepare;
};

struct Measurement {
  Subject subject;
  double time;        ///< of the processor  [s]
  double real_time;   ///< the same unless others use the machine  [s]
  double repeats;     ///< over which they are means
  double iterations;  ///< mean, see Work
};

struct Timing {
  double least_time;       ///< of a measurement, > 0  [s]
  int repetitions;         ///< >= 1; the one with the median time counts
  Eigen::Index once_from;  ///< from this N on there is one repetition
};

/// Runs the cases in turn, by Google Benchmark.
/// \throws std::runtime_error if one fails
std::vector<Measurement> measure(const std::vector<Case>& cases, const Timing& timing,
                                 const Progress& progress);

}  // namespace microslip::bench
