// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/rolling/advection.hpp"
#include "microslip/rolling/steady.hpp"

namespace microslip {

/// \file
/// The catalogue of schemes has one entry for every scheme that scenes can choose. Scenes,
/// explanations, studies and benchmarks use the catalogue.

/// The closed interval in which a scheme is safe: in the study `extremes`, errors of force,
/// creepage and tractions are below 10 %, and no node-to-node wave exceeds 1 % of the peak of the
/// bound. tests/study/extremes_test.cpp compares the interval with the study. Outside the interval,
/// a scene is solved with a warning.
struct SafeRange {
  double least = 0;
  double most = std::numeric_limits<double>::infinity();

  bool holds(double value) const { return value >= least && value <= most; }
};

/// Safe numbers of elements with a basis  [1]
/// \throws std::logic_error for a basis without a measurement
SafeRange safe_elements(const Basis& basis);

/// A way to solve steady rolling: a value of `leading_edge`, or `method chebyshev`.
struct SteadyEntry {
  std::string_view name;
  std::string_view text;    ///< description; {c} and {functions} are replaced by c and the basis of
                            ///< a problem
  std::string_view limits;  ///< requirements and limits
  double order;             ///< order of the force in dx; inf if the force has ten digits for any N
  bool by_elements;         ///< whether N elements carry the tractions; otherwise nodes only sample
                            ///< them
  SteadyMethod (*method)(double step_ratio);
  /// Safe c: below this range tractions wiggle, above it differences are too coarse. None where c
  /// has no role.
  std::optional<SafeRange> safe_steps = std::nullopt;
  std::string_view basis = "";                         ///< the only accepted basis; any if empty
  void (*complete)(SteadyProblem& problem) = nullptr;  ///< completes the method for a problem
};

/// All entries, the default first.
std::span<const SteadyEntry> steady_schemes();

/// The names that `leading_edge` takes, the default first.
std::vector<std::string_view> leading_edge_names();

/// \throws std::invalid_argument for another name
const SteadyEntry& steady_scheme(std::string_view name);

/// The only basis that the scheme accepts, or the default basis.
Basis basis_of(const SteadyEntry& entry);

/// The entry of the problem's method.
const SteadyEntry& entry_of(const SteadyProblem& problem);

/// The problem with the method of this scheme.
/// \param step_ratio  c, where it has a role
/// \throws std::invalid_argument if the scheme does not accept the basis; and as ChebyshevRolling,
///                               if the scheme takes the displacement at the leading edge from it
SteadyProblem solved_by(const SteadyEntry& entry, SteadyProblem problem, double step_ratio = 1);

/// A way to roll a transient: a value of `step.scheme`.
struct AdvectionEntry {
  std::string_view name;
  std::string_view text;    ///< description
  std::string_view limits;  ///< requirements and limits
  double order;             ///< order of the cumulative creep in dx
  /// Safe c: below this range tractions wiggle or are smeared, above it steps are too coarse.
  SafeRange safe_steps;
  AdvectionScheme (*scheme)(double relaxation);
  bool takes_relaxation = false;
};

/// All entries, the default first.
std::span<const AdvectionEntry> advection_schemes();

/// The names of the entries, in the same order.
std::vector<std::string_view> advection_names();

/// \throws std::invalid_argument for another name
const AdvectionEntry& advection_scheme(std::string_view name);

const AdvectionEntry& entry_of(const AdvectionScheme& scheme);

/// The scheme's name in scenes.
std::string name_of(const AdvectionScheme& scheme);

/// The least c for which rounding is below 1 % of the creepage, in a transient under a force of at
/// least 5 % of full sliding. The creepage is a shift over the length of a step, and the shift has
/// the rounding errors of the displacements. tests/unit/small_steps_test.cpp  [1]
double least_step_under_force(Eigen::Index elements);

}  // namespace microslip
