// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "campaign.hpp"
#include "microslip/experiments/claims.hpp"
#include "microslip/experiments/extremes.hpp"
#include "microslip/rolling/steady.hpp"

namespace microslip::experiments::extremes_study {

/// Errors of a result at an extreme.
struct Finding {
  double error = not_given;   ///< relative, of a result that is not prescribed  [1]
  double wiggle = not_given;  ///< see wiggle_of()  [1]
  double condition = not_given;
  Evidence evidence;
  double iterations = not_given;
};

/// The finding of a solution, without the amplitude of waves.
/// \param error  of the result that is not prescribed, relative  [1]
Finding finding_of(const SteadySolution& found, double error);

/// Returns the creepage by so many calibrated elements.
double creepage_by_elements(SteadyProblem problem, Eigen::Index elements);

/// One scheme at one place of a map.
struct Case {
  std::string scheme;
  std::vector<double> place;  ///< coordinates
  double size;                ///< N
  bool goes_on = false;       ///< whether the case before is the same with fewer elements
  std::function<Finding()> solve;
};

/// A case with its result.
struct Outcome {
  Case at;
  Finding finding;
  /// ok, wiggles, inaccurate, refused (bad input), no_solution, or not_run (too much work)
  std::string verdict;
  std::string message;  ///< of the exception
};

/// A set of cases in one table.
struct Map {
  std::string name;
  std::string description;
  std::vector<Column> coordinates;
  /// Values of coordinates while another coordinate varies; not_given for a coordinate that follows
  /// from the others.
  std::vector<double> ordinary;
  std::vector<Case> cases;
  double rounding = 1e-12;  ///< an error up to this is rounding only
};

/// Runs a case.
/// \param smaller  runs of the same case with fewer elements
Outcome outcome_of(Runs& smaller, const Case& at, const ExtremesParameters::Limits& limits);

Table table_of(const Map& map, const std::vector<Outcome>& outcomes);

/// Makes an empty table of the ranges in which each scheme is safe: a row for each scheme and
/// coordinate.
Table empty_ranges();

/// Adds the ranges of one map. A range goes along one coordinate, while the others are ordinary,
/// from the ordinary value to the last case before one fails.
void add_ranges(Table& ranges, const Map& map, const std::vector<Outcome>& outcomes);

// These functions make the maps.
Map steps_map(const ExtremesParameters& p);
Map widths_map(const ExtremesParameters& p);
Map loads_map(const ExtremesParameters& p);
Map bounds_map(const ExtremesParameters& p);
Map kernels_map(const ExtremesParameters& p);
Map bodies_map(const ExtremesParameters& p);
Map offsets_map(const ExtremesParameters& p);
Map transient_map(const ExtremesParameters& p);
Map endurance_map(const ExtremesParameters& p);
Map cylinder_map(const ExtremesParameters& p);

/// Measures the errors of scale invariance.
Table scales_table(const ExtremesParameters& p);

}  // namespace microslip::experiments::extremes_study
