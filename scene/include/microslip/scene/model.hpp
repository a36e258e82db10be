// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "microslip/dynamics/cylinder.hpp"
#include "microslip/patch/patch_target.hpp"
#include "microslip/patch/steady_patch.hpp"
#include "microslip/patch/traction_table.hpp"
#include "microslip/rolling/patch_history.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/target_error.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip {

/// \file
/// These functions read parts of a model from the keys of a scene. Each throws
/// std::invalid_argument that names the key. scene/keys.cpp has unit, range, words and default of
/// each key.

/// Reads material.poisson_ratio, and material.shear_modulus or material.youngs_modulus.
Material read_material(Scene& scene);

/// Reads the same where the scene needs a material. A kernel of springs or of a table has none,
/// unless Hertz's contact needs one: the constants then have no meaning, and no key is read.
Material read_material_if_any(Scene& scene);

/// Reads the constants of both bodies. Bodies of different material have material.dundurs_beta; or
/// the constants of the second one have keys with the ending _2, beside the keys of
/// read_material().
Bodies read_bodies(Scene& scene);

/// Reads `direction`, and returns the constants with which a kernel is the kernel of this
/// direction.
Material read_tangential(Scene& scene, const Material& material);

/// Reads contact.friction.
double read_friction(Scene& scene);

/// Reads kernel.type and the keys of that kernel: kernel.width of a strip, kernel.length of plane
/// strain, both with kernel.compliance if they have a layer; kernel.compliance of springs; and
/// kernel.table of a table, with columns wave_number and symbol.
Kernel read_kernel(Scene& scene, const Material& material);

/// Reads contact.half_width and contact.peak_traction.
HertzBound read_hertz_bound(Scene& scene);

/// Reads contact.half_width, contact.bound_polynomial and contact.peak_traction.
PolynomialBound read_polynomial_bound(Scene& scene);

/// Reads a bound of Hertz, a polynomial, or the table of contact.bound_file with columns x and
/// bound.
TractionBound read_bound(Scene& scene);

/// Reads a bound, or contact.normal_load, contact.radius_1, contact.radius_2 (none for a plane) and
/// contact.friction, from which half-width and peak follow by Hertz.
TractionBound read_bound(Scene& scene, const Material& material);

/// Reads grid.elements, grid.leading_offset and grid.trailing_offset.
Grid read_grid(Scene& scene, double half_width);

/// Reads `basis`.
Basis read_basis(Scene& scene, const Grid& grid);

/// Reads solver.type and solver.tolerance.
Solver read_solver(Scene& scene);

/// Reads solver.tolerance, solver.violation and solver.condition.
Acceptance read_acceptance(Scene& scene);

/// Warns of a creepage above 0.2 in size: the theory is one of small creepages. Normalised
/// contacts, whose mean bound is above 0.1 of the shear modulus, have no such limit.
void warn_of_large_creepage(Scene& scene, const std::string& key, double creepage,
                            const TractionBound& bound);

/// The keys of a load, of which a scene has one; load.stick_ratio is for Hertz's bound in plane
/// strain.
extern const std::vector<std::string> load_keys;

/// Reads the one of `load_keys` that the scene has.
Load read_load(Scene& scene, const Kernel& kernel, const TractionBound& bound);

/// Reads a problem of steady rolling: all of the above, with `method` and `leading_edge`, which
/// name an entry of steady_schemes(). Offsets of the grid are for the schemes that make
/// Differences; method chebyshev has neither basis nor solver.
SteadyProblem read_steady(Scene& scene);

/// Reads a problem of steady rolling with a given method.
SteadyProblem read_steady(Scene& scene, const SteadyMethod& method);

/// Steady rolling to a given error; the program chooses method, basis and grid.
struct SteadyTarget {
  SteadyContact contact;
  double error;  ///< [1]
};

/// Reads material.*, contact.*, kernel.*, load.* and target_error. The keys of method, basis and
/// grid have no role.
SteadyTarget read_steady_target(Scene& scene);

/// Reads steady rolling of an ellipse: material.*, contact.*, grid.rows and grid.elements, and
/// load.* of all three components.
SteadyPatch read_steady_patch(Scene& scene);

/// Steady rolling of a patch to a given error; the program chooses the grid.
struct PatchTarget {
  SteadyPatch patch;  ///< with the finest grid that is tried
  double error;       ///< [1]
};

/// Reads the keys of read_steady_patch() but for the grid, and target_error.
PatchTarget read_patch_target(Scene& scene);

/// A contact patch that rolls by steps.
struct PatchTransient {
  SteadyPatch patch;                      ///< its load is not used
  AdvectionScheme scheme = Remembered{};  ///< Remembered; Direct or Relaxed on rectangles
  std::vector<PatchLoad> shifts = {};    ///< without rolling, one after the other from the start on
  double distance = 0;                   ///< rolled at the end, above `from`  [mm]
  std::vector<double> step_ratios = {};  ///< dq over spacing(), taken in turn, each (0, inf)  [1]
  PatchHistory loads;
  std::optional<SavedState> state = {};     ///< the start, if it is one
  std::optional<TractionTable> start = {};  ///< tractions of the start, on the patch's own size
  double from = 0;                          ///< distance at the start, that of the state  [mm]
  /// Steps at whose ends tractions are wanted, rising; 0 is the start.
  std::vector<std::size_t> instants = {};

  double spacing() const;                    ///< the mean length of cells, 2 a/N  [mm]
  std::vector<double> step_lengths() const;  ///< dq, taken in turn  [mm]
};

/// Reads steps of an ellipse or another patch: the keys of read_steady_patch(), step.scheme
/// `remembered`, `direct` or `relaxed`, load.file, whose columns go before load.*, step.ratio (one or more
/// numbers; the rows of load.file by default), motion.distance, and start.type `rest`, `cattaneo`
/// or `state`. `cattaneo` has start.force or start.shift, and the same of the other components, of
/// which all have as many numbers; without them, the bodies are shifted to the resultants of the
/// load. `state` has start.state. Also reads motion.instants or motion.instants_at.
PatchTransient read_patch_transient(Scene& scene);

/// Refuses an ellipse where only a line contact can be.
void require_line_contact(const Scene& scene);

/// A transient problem with all that happens to it.
struct TransientScene {
  TransientProblem problem;
  Start start;
  std::vector<ShiftLoad> shifts;    ///< without rolling, one after the other from the start on
  double distance;                  ///< rolled at the end, above `from`  [mm]
  std::vector<double> step_ratios;  ///< dq/dx, taken in turn, each (0, inf)  [1]
  LoadHistory loads;
  double from = 0;  ///< distance at the start, 0 except for a saved state  [mm]
  /// Steps at whose ends tractions are wanted, rising; 0 is the start.
  std::vector<std::size_t> instants = {};

  std::vector<double> step_lengths() const;  ///< dq, taken in turn  [mm]
};

/// Reads the contact of a transient: the keys of a steady scene except for leading_edge and load.*,
/// and step.scheme with step.relaxation. Friction that falls with slip has load.speed.
TransientProblem read_transient_problem(Scene& scene);

/// Reads a transient: the contact as read_transient_problem(), a load or load.file, step.ratio (one
/// or more numbers; the rows of load.file by default) and motion.distance (the distance of
/// load.file by default). The start is by start.type: `cattaneo` has start.force (load.force by
/// default) or start.shift; one start.force makes a CattaneoShift; several, or any start.shift, are
/// shifts from rest. `file` has start.file with columns x and traction, at the nodes, or at any
/// positions for the scheme remembered. `state` has start.state. Also reads motion.instants or
/// motion.instants_at.
TransientScene read_transient(Scene& scene);

/// A cylinder that rolls down a slope, from rest or from free rolling.
struct CylinderScene {
  TransientProblem problem;
  Cylinder cylinder;
  Integrator integrator;
  double step_ratio;                     ///< c, (0, inf)  [1]
  double distance;                       ///< (0, inf)  [mm]
  std::optional<double> tolerance = {};  ///< of the steps, (0, 1], for the midpoint rule  [1]
};

/// Reads a cylinder: the contact as read_transient_problem(), cylinder.*, step.ratio,
/// motion.distance, motion.integrator and, for the midpoint rule, motion.tolerance.
CylinderScene read_cylinder(Scene& scene);

/// Reads a cylinder that starts from rest, with a given scheme and integrator, and without a
/// tolerance.
CylinderScene read_cylinder(Scene& scene, const AdvectionScheme& scheme, Integrator integrator);

/// The problem of a scene.
using Model = std::variant<SteadyProblem, SteadyTarget, SteadyPatch, PatchTarget, TransientScene,
                           PatchTransient, CylinderScene>;

/// Reads `problem`, and the keys of that problem: with one of `patch_keys` those of
/// read_steady_patch() or read_patch_transient(), and with target_error those of
/// read_steady_target() or read_patch_target().
Model read_model(Scene& scene);

/// Returns N; with target_error 0, and of a patch that of the finest grid.
Eigen::Index elements_of(const Model& model);

}  // namespace microslip
