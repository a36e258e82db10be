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
/// The catalogue: every scheme that scenes can choose has one entry here, from which scenes,
/// explanations, studies and timings take it.

/// A closed interval, where a scheme is safe: the force, the creepage and the tractions of the
/// study `extremes` are within 10 % there, and no wave from node to node exceeds 1 % of the peak of
/// the bound. Measured; tests/study/extremes_test.cpp holds it against the study. Outside, a scene
/// is solved as it was asked for, with a warning.
struct SafeRange {
  double least = 0;
  double most = std::numeric_limits<double>::infinity();

  bool holds(double value) const { return value >= least && value <= most; }
};

/// N of elements, by the order of the functions  [1]
SafeRange safe_elements(const Basis& basis);

/// A way to solve steady rolling: a value of `leading_edge`, or `method chebyshev`.
struct SteadyEntry {
  std::string_view name;
  std::string_view text;    ///< what it is; {c} and {functions} stand for those of a problem
  std::string_view limits;  ///< what it needs, or does not do
  double order;             ///< of the force in dx; inf if it has ten digits for any N
  bool by_elements;         ///< N elements carry the tractions; else nodes only show them
  SteadyMethod (*method)(double step_ratio);
  /// c: below, differences wiggle, above, they are too coarse; nothing where c has no role.
  std::optional<SafeRange> safe_steps = std::nullopt;
  std::string_view basis = "";  ///< the only one that it goes with; any if empty
  void (*complete)(SteadyProblem& problem) = nullptr;  ///< adds what else the method needs
};

/// The default first.
std::span<const SteadyEntry> steady_schemes();

/// Those of `leading_edge`, the default first.
std::vector<std::string_view> leading_edge_names();

/// \throws std::invalid_argument for another name
const SteadyEntry& steady_scheme(std::string_view name);

/// The only functions that it goes with, or else the default.
Basis basis_of(const SteadyEntry& entry);

/// The entry by which a problem is solved.
const SteadyEntry& entry_of(const SteadyProblem& problem);

/// The same problem, to be solved by this scheme.
/// \param step_ratio  c, where it has a role
/// \throws std::invalid_argument if the scheme does not go with the basis, and as ChebyshevRolling
///                               where that gives the displacement at the leading edge
SteadyProblem solved_by(const SteadyEntry& entry, SteadyProblem problem, double step_ratio = 1);

/// A way to roll a transient: a value of `step.scheme`.
struct AdvectionEntry {
  std::string_view name;
  std::string_view text;    ///< what it is
  std::string_view limits;  ///< what it needs, or does not do
  double order;             ///< of the cumulative creep in dx
  /// c: below, tractions wiggle or are smeared; above, steps are too coarse.
  SafeRange safe_steps;
  AdvectionScheme (*scheme)(double relaxation);
  bool takes_relaxation = false;
};

/// The default first.
std::span<const AdvectionEntry> advection_schemes();

/// Their names, in that order.
std::vector<std::string_view> advection_names();

/// \throws std::invalid_argument for another name
const AdvectionEntry& advection_scheme(std::string_view name);

const AdvectionEntry& entry_of(const AdvectionScheme& scheme);

/// As scenes name it.
std::string name_of(const AdvectionScheme& scheme);

/// c of a transient under a force, of 5 % of full sliding or more, from which on rounding leaves 1
/// % of the creepage or less: that is a shift over the length of a step, and the shift has the
/// rounding of the displacements. On a grid that is fixed to the material those of the bound are
/// among them, and nodes enter to 1e-9 of an element. tests/unit/small_steps_test.cpp  [1]
double least_step_under_force(const AdvectionScheme& scheme, Eigen::Index elements);

}  // namespace microslip
