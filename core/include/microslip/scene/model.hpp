// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "microslip/dynamics/cylinder.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/target_error.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip {

/// \file
/// Parts of a model from the keys of a scene. Each throws std::invalid_argument that names the key.

/// material.shear_modulus or material.youngs_modulus, material.poisson_ratio
Material read_material(Scene& scene);

/// The same as constants of both bodies or of the first; material.dundurs_beta, or
/// material.shear_modulus_2 or material.youngs_modulus_2, and material.poisson_ratio_2, of bodies of
/// different material
Bodies read_bodies(Scene& scene);

/// direction longitudinal|lateral (longitudinal): the constants with which a kernel is that of this
/// direction
Material read_tangential(Scene& scene, const Material& material);

/// contact.friction, above 0, at most 10
double read_friction(Scene& scene);

/// kernel.type strip|plane; kernel.width of a strip, kernel.length of plane strain
Kernel read_kernel(Scene& scene, const Material& material);

/// contact.half_width, contact.peak_traction
HertzBound read_hertz_bound(Scene& scene);

/// contact.half_width, contact.bound_polynomial, contact.peak_traction (1)
PolynomialBound read_polynomial_bound(Scene& scene);

/// Either of these, or contact.half_width and contact.bound_file (columns x bound)
TractionBound read_bound(Scene& scene);

/// The same, or instead of all that contact.normal_load, contact.radius_1, contact.radius_2 (none
/// for a plane) and contact.friction, from which half-width and peak follow by Hertz.
TractionBound read_bound(Scene& scene, const Material& material);

/// grid.elements, grid.leading_offset (0.5), grid.trailing_offset (0.5)
Grid read_grid(Scene& scene, double half_width);

/// basis constant|linear|quadratic (constant); the last for an odd number of elements
Basis read_basis(Scene& scene, const Grid& grid);

/// solver.type auto|dense|fft (auto), solver.tolerance (1e-10)
Solver read_solver(Scene& scene);

/// solver.tolerance (1e-10), solver.violation (0.05), solver.condition (1e13)
Acceptance read_acceptance(Scene& scene);

/// Warns of a creepage above 0.2 in size: the theory is one of small creepages. Normalised contacts,
/// whose mean bound is above 0.1 of the shear modulus, have no such limit.
void warn_of_large_creepage(Scene& scene, const std::string& key, double creepage,
                            const TractionBound& bound);

/// load.creepage, load.force, load.force_ratio or, for Hertz's bound in plane strain,
/// load.stick_ratio
Load read_load(Scene& scene, const Kernel& kernel, const TractionBound& bound);

/// method collocation|chebyshev (collocation), and of the first leading_edge
/// inversion|calibrated|standard|exact|trimmed (inversion):
///   inversion   `Inversion`
///   calibrated  `Calibrated`
///   standard    `Differences` with step.ratio (1)
///   exact       the same, with the displacement at the leading edge from Chebyshev collocation
///   trimmed     the same as standard, with the last of linear functions trimmed
/// All of the above, but the grid's offsets in the last three only, and no basis and solver with
/// chebyshev.
SteadyProblem read_steady(Scene& scene);

/// All of the above, with a given method.
SteadyProblem read_steady(Scene& scene, const SteadyMethod& method);

/// Steady rolling to a given error; how is left to the program.
struct SteadyTarget {
  SteadyContact contact;
  double error;  ///< [1]
};

/// material.*, contact.*, kernel.*, load.* and target_error; but none of the keys that it picks.
SteadyTarget read_steady_target(Scene& scene);

/// A transient problem with all that happens to it.
struct TransientScene {
  TransientProblem problem;
  Start start;
  std::vector<ShiftLoad> shifts;    ///< without rolling, one after the other from the start on
  double distance;                  ///< rolled at the end, above `from`  [mm]
  std::vector<double> step_ratios;  ///< dq/dx, taken in turn, each (0, inf)  [1]
  LoadHistory loads;
  double from = 0;  ///< distance at the start, 0 except for a saved state  [mm]

  std::vector<double> step_lengths() const;  ///< dq, taken in turn  [mm]
};

/// The contact of a transient: all of a steady scene except for leading_edge and load.*, and
/// step.scheme with step.relaxation as read_transient() takes them.
TransientProblem read_transient_problem(Scene& scene);

/// All of a steady scene except for leading_edge, with load.file as another load, and:
/// step.ratio (one or more numbers; with load.file, its rows), step.scheme
/// remembered|direct|relaxed|relaxed_traction|fractional (remembered), step.relaxation (1)
/// of the relaxed ones, motion.distance (that of load.file), start.type rest|cattaneo|file|state;
/// start.force (load.force) or start.shift of cattaneo; start.file of file: columns x traction, at
/// the nodes, or at any positions for remembered. One start.force makes a
/// CattaneoShift; several, or any start.shift, are shifts from rest. start.state of state.
TransientScene read_transient(Scene& scene);

/// A cylinder that rolls down a slope, from rest or from free rolling.
struct CylinderScene {
  TransientProblem contact;
  Cylinder cylinder;
  Integrator integrator;
  double step_ratio;                     ///< c, (0, inf)  [1]
  double distance;                       ///< (0, inf)  [mm]
  std::optional<double> tolerance = {};  ///< of the steps, (0, 1], for the midpoint rule  [1]
};

/// All of a steady scene but load.*; cylinder.mass, cylinder.inertia, cylinder.radius,
/// cylinder.slope_force, cylinder.velocity (0), step.ratio (1), motion.distance, motion.integrator
/// midpoint|verlet|leapfrog (midpoint), with midpoint motion.tolerance, and step.scheme and
/// step.relaxation as in a transient.
CylinderScene read_cylinder(Scene& scene);

/// The same from rest, with a given scheme and integrator, and without a tolerance.
CylinderScene read_cylinder(Scene& scene, const AdvectionScheme& scheme, Integrator integrator);

/// The problem that a scene describes.
using Model = std::variant<SteadyProblem, SteadyTarget, TransientScene, CylinderScene>;

/// problem steady|transient|cylinder, and the keys of that; of a steady one with target_error,
/// those of read_steady_target.
Model read_model(Scene& scene);

/// N; 0 with target_error.
Eigen::Index elements_of(const Model& model);

}  // namespace microslip
