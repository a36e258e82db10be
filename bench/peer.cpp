// SPDX-License-Identifier: GPL-3.0-or-later
#include "peer.hpp"

#include <limits>

namespace microslip::bench {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

Measurement time(const char* quantity, Eigen::Index elements, double time,
                 double iterations = unknown, const char* kernel = "strip") {
  return {.subject = {quantity, kernel, "CONTACT", elements},
          .time = time,
          .real_time = time,
          .repeats = 1,
          .iterations = iterations};
}

}  // namespace

const char* peer_machine() {
  return "CONTACT (E. Vollebregt, open source, 2025), one thread of a 2-core AMD EPYC server, "
         "whole "
         "process, gfortran -O3, FFTW in place of MKL; steady to EPS 1e-5; it evaluates x and y "
         "tractions where 2D needs only x";
}

/// Times of the ellipse are those of one case within a process, with its normal contact, by the
/// faster one of both solvers; those of a step are means over 1.5 half-widths from rest under
/// prescribed motions, to EPS 1e-7, each with its normal contact.
/// Steady N = 100 is 2.4 ms a case in a long run; N = 12800 was not finished in 10 minutes.
const std::vector<Measurement>& peer_times() {
  static const std::vector<Measurement> all = {
      time("steady", 100, 8.8e-3, 24),
      time("steady", 400, 56e-3, 48),
      time("steady", 800, 0.26, 67),
      time("steady", 1600, 1.35, 91),
      time("steady", 3200, 7.4, 122),
      time("steady", 6400, 41, 159),
      time("step", 6400, 33e-3),
      time("step", 12800, 69e-3),
      time("rolling_by_force", 100, 41e-3),
      time("rolling_by_force", 400, 0.79),
      time("rolling_by_force", 800, 9.0),
      time("rolling_by_force", 1600, 23.8),
      time("rolling_by_creepage", 100, 36e-3),
      time("rolling_by_creepage", 400, 0.63),
      time("rolling_by_creepage", 800, 2.2),
      time("rolling_by_creepage", 1600, 6.6),
      time("ellipse_first", 316, 18e-3, 36, "half_space"),
      time("ellipse_first", 1272, 93e-3, 70, "half_space"),
      time("ellipse_first", 5048, 1.0, unknown, "half_space"),
      time("ellipse_step", 316, 3.4e-3, 13, "half_space"),
      time("ellipse_step", 1272, 10.5e-3, 17, "half_space"),
      time("ellipse_step", 5048, 55e-3, 21, "half_space"),
  };
  return all;
}

}  // namespace microslip::bench
