// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "microslip/patch/patch_shape.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// A scene that is solved by every scheme with several N, to see what an accuracy costs in it.
struct ConvergeScene {
  Scene scene;
  std::vector<Eigen::Index> elements;  ///< N, in rising order
  double error;                        ///< wanted of the answer, relative
  std::optional<double> step_time;     ///< that a step of a transient may last  [s]
  bool steady;                         ///< else a transient
  std::optional<PatchShape> shape;     ///< of an ellipse or another patch, none of a line contact
  bool under_force;                    ///< so that the creepage is the answer, else the force
  double memory;                       ///< that the reference takes  [bytes]
  std::string reference;               ///< best, chebyshev or fine
  /// Steps of an ellipse have the same lengths on all grids: these are dq over 2 a, so that N times
  /// as much is step.ratio. There are none if rows of load.file are the steps.
  std::vector<double> step_parts = {};
};

/// All keys of a steady or transient scene; converge.elements (15 31 63 127 255; of an ellipse six
/// from 0.3 to 1.4 times its default, up to 66), converge.error (1e-3), converge.step_time and
/// converge.reference best|chebyshev|fine (best).
/// \throws std::invalid_argument for a cylinder, target_error, start.type state, the reference
///         chebyshev of a transient, and a reference of more than 1e13 operations
ConvergeScene read_converge(Scene& scene);

/// Tables: converge (errors and work of every scheme and N), converge_timing (measured time),
/// summary (the reference) and advice_timing (a line of text for the error, and for the time of a
/// step). The best reference of steady rolling is the inversion where it holds; the best of all
/// else is fine: the default scheme of those by elements with 4 N + 3 elements for the largest N,
/// of which the difference to 2 N + 1 elements is the reference's error. An ellipse has rows that fit
/// its elements, and its reference 3 N/2 elements, of which the difference to one less is the error; its
/// steps have the same lengths with all N.
///
/// \throws std::invalid_argument if the answer is zero all the way, or chebyshev does not take it
/// \throws NotConverged         if the reference has no solution
std::vector<Table> converge_tables(const ConvergeScene& scene, const Progress& progress);

}  // namespace microslip::experiments
