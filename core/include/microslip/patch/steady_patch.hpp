// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <vector>

#include "microslip/friction/friction_law.hpp"
#include "microslip/halfspace/material.hpp"
#include "microslip/patch/patch_bound.hpp"
#include "microslip/patch/patch_load.hpp"
#include "microslip/patch/patch_response.hpp"
#include "microslip/patch/stick_slip.hpp"
#include "microslip/reference/kalker.hpp"
#include "microslip/rolling/evidence.hpp"

namespace microslip {

/// One cell a row would carry twice the bound, and could gain energy.
inline constexpr Eigen::Index least_elements = 2;

/// Half-spaces of one material touch in an ellipse or another patch, and roll steadily. Spin and
/// moment are about x = y = 0, which is the centre of an ellipse.
struct SteadyPatch {
  Material material;  ///< poisson_ratio in [0, 0.5]
  PatchBound bound;
  Eigen::Index rows;      ///< M, >= 1, and not less than there are lobes
  Eigen::Index elements;  ///< N of each row, >= 2
  PatchLoad load = {};
  Acceptance accepted = {};
  /// If it depends on slip; the bound is that at rest then.
  std::optional<SlipFriction> friction = std::nullopt;
};

/// \throws std::invalid_argument if a number is out of its range; as validate() of the load
void validate(const SteadyPatch& problem);

/// \throws std::invalid_argument if a number is not finite, or a resultant is not less than friction
///         carries on its own: forces less than full sliding, as the length of their vector, and
///         the moment less than that of turning about the centre
/// \param full_sliding    [N]
/// \param turning_moment  [N mm]
void validate(const PatchLoad& load, double full_sliding, double turning_moment);

/// The sum of the areas of cells that slip.
double slip_area_of(const Eigen::VectorXd& areas, const std::vector<bool>& slips);

/// Tractions and slip at the centres of cells, in the order of JoinedRows; resultants and motion.
struct SteadyPatchSolution {
  Eigen::VectorXd x, y;       ///< [mm]
  Eigen::VectorXd area;       ///< [mm^2]
  Eigen::VectorXd bound;      ///< g by the friction at the cell  [N/mm^2]
  Eigen::MatrixX2d traction;  ///< along and across  [N/mm^2]
  Eigen::MatrixX2d slip;      ///< relative slip, zero where a cell sticks  [1]
  std::vector<bool> slips;
  Eigen::Vector3d resultants;  ///< Fx, Fy [N], Mz about the centre [N mm]
  Eigen::Vector3d motion;      ///< xi, eta [1], phi [1/mm]
  double dissipation;          ///< energy per mm rolled, -(xi Fx + eta Fy + phi Mz)  [N]
  int iterations;
  double condition;  ///< of the equations in adhesion
  /// Forces and powers are integrals over the patch [N]; `load` is the length of the force.
  Evidence evidence;
  PatchState state;  ///< a start for the next load
  /// Whether the search for a friction that depends on slip found a second solution.
  bool has_second = false;

  double force() const { return std::hypot(resultants[0], resultants[1]); }  ///< [N]
  double slip_area() const { return slip_area_of(area, slips); }             ///< [mm^2]
};

/// Solves steady rolling of a patch.
/// Order: 2 in 1/N where M/N is kept; tests/property/generated_patches_test.cpp
/// \param response  of rows for bound.shape(), scaled to the size 1, and the material's Poisson ratio
/// \param start     the state of another solution with the same rows; nullptr for none
/// \throws as validate; NotConverged
SteadyPatchSolution solve_steady(const SteadyPatch& problem, const PatchResponse& response,
                                 const PatchState* start = nullptr);

/// The same, with a response of its own.
SteadyPatchSolution solve_steady(const SteadyPatch& problem);

/// The largest change of what follows from the load between two solutions: of the forces over full
/// sliding, of the moment over that of turning, and of motions that follow over the largest motion of
/// their kind, creepage or spin.
/// \return  [1]
double change_of(const SteadyPatch& problem, const SteadyPatchSolution& from,
                 const SteadyPatchSolution& to);

/// The problem with rows and elements that are a third fewer; none if there is one row in each lobe,
/// or two elements.
std::optional<SteadyPatch> with_fewer_elements(const SteadyPatch& problem);

/// Solves steady rolling of a patch under one load after another, each from the solution before. The
/// patch is prepared once, also with rows and elements that are a third fewer: the change of the
/// result from those, by change_of(), is evidence. Errors of resultants are below 2e-3 plus 1.5 times
/// the change, and under strong spin below 7e-3 plus 2.5 times the change:
/// tests/property/generated_patches_test.cpp. The change is 1 if fewer have no solution, and if there
/// is one row in each lobe or two elements.
class SteadyPatchSolver {
 public:
  /// \param with_change  whether the change is wanted, which takes a third of the time; else it is 0
  /// \throws as validate
  explicit SteadyPatchSolver(const SteadyPatch& problem, bool with_change = true);

  /// Sets the bound of the next solutions.
  /// \param bound  of the same shape but for its size
  /// \throws std::invalid_argument for another ratio a/b
  void set_bound(const PatchBound& bound);

  /// Sets the speed V of rolling, > 0, by which friction falls that depends on slip  [mm/s].
  /// \throws std::invalid_argument outside the range
  void set_speed(double speed);

  /// \throws as solve_steady
  SteadyPatchSolution solve(const PatchLoad& load);

  /// The coefficients of forces and moment where all sticks, by the patch's own rows.
  CreepCoefficients coefficients() const;

  /// The derivatives of Fx, Fy [N] and Mz [N mm] by xi, eta [1] and phi [1/mm] at the last solution;
  /// exact where no cell changes between stick and slip, and one-sided elsewhere.
  /// \throws std::logic_error before the first solution
  /// \throws std::invalid_argument where friction depends on slip
  Eigen::Matrix3d jacobian() const;

 private:
  /// One of the two grids, with the state of its last solution.
  struct Prepared {
    SteadyPatch problem;
    PatchResponse response;
    std::optional<PatchState> state = {};

    explicit Prepared(const SteadyPatch& of);
    SteadyPatchSolution solve(const PatchLoad& load);
  };

  Prepared fine_;
  bool with_change_;
  std::optional<Prepared> coarse_;
};

/// Solves one load so.
SteadyPatchSolution solve_steady_with_change(const SteadyPatch& problem);

}  // namespace microslip
