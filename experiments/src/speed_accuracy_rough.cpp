// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "microslip/experiments/claims.hpp"
#include "microslip/friction/rough_bound.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/support/work.hpp"
#include "speed_accuracy_problems.hpp"

namespace microslip::experiments::speed_accuracy_study {

namespace {

using Eigen::Index;

/// Stick zones of a contact whose leading edge comes last.
Index stick_zones(const std::vector<Zone>& zones) {
  Index count = 0;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const bool begins = i == 0 || zones[i - 1] != Zone::adhesion;
    count += begins && zones[i] == Zone::adhesion ? 1 : 0;
  }
  return count;
}

struct Solved {
  SteadySolution solution;
  double work;  ///< counted operations
};

Solved solved(const SpeedAccuracyParameters& p, const TractionBound& bound, Index elements) {
  const WorkCount count;
  SteadySolution solution =
      solve_steady({.contact = {PlaneKernel(p.material, p.length), bound},
                    .grid = Grid({.half_width = half_width_of(bound), .elements = elements}),
                    .method = Calibrated{},
                    .load = PrescribedForce{-p.rough_load * full_sliding_force(bound)}});
  return {std::move(solution), count.operations()};
}

}  // namespace

Table rough_table(const SpeedAccuracyParameters& p) {
  Table table("rough",
              "steady rolling in plane strain by calibrated elements, under Hertz's bound times a "
              "self-affine profile; the truth has rough.reference elements",
              {{"hurst", "1", "Hurst exponent of the profile"},
               {"elements", "1", "N"},
               {"creepage_error", "1", "relative, under a force"},
               {"zones", "1", "stick zones"},
               {"rounds", "1", "stick/slip partitions tried on the last grid"},
               {"work", "1", "counted floating-point operations"}});
  const HertzBound smooth(p.bound.half_width(), 1);
  for (const double hurst : p.hursts) {
    const TractionBound bound = rough_bound(smooth, {p.roughness, hurst, p.seed, p.rough_rows});
    const double truth = solved(p, bound, p.rough_reference).solution.creepage;
    for (const Index elements : p.rough_sizes) {
      const auto [found, work] = solved(p, bound, elements);
      table.add({hurst, elements, std::abs(found.creepage / truth - 1), stick_zones(found.zones),
                 found.iterations, work});
    }
  }
  return table;
}

}  // namespace microslip::experiments::speed_accuracy_study
