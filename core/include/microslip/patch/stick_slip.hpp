// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/patch/patch_load.hpp"
#include "microslip/patch/patch_response.hpp"

namespace microslip {

/// Tractions and slip of a patch; scale and order are those of PatchResponse.
struct PatchState {
  Eigen::VectorXd unknowns;     ///< 2n
  Eigen::VectorXd own_slip;     ///< 2n, 0 where a cell sticks
  Eigen::VectorXd centre_slip;  ///< 2n
  Eigen::VectorXd seen_slip;    ///< 2n, see SeenSlip; 0 in a shift
  Eigen::VectorXd carried;      ///< n, the part of its limit that a cell carries where it slips
  Eigen::Vector3d motion;       ///< xi, eta, phi
  std::vector<bool> slips;      ///< n
  int iterations = 0;           ///< systems that were solved
  double residual = 0;          ///< largest error of the slip conditions, over the bound  [1]
};

/// Residuals of solved steps are smaller.
inline constexpr double largest_residual_of_step = 1e-7;

/// The discs onto which P projects; see solve_stick_slip().
enum class Discs { of_solution, of_start };

/// Solves the slip conditions of steady rolling: with q = v/g, g the limit of a cell, and s its slip
///   |q| <= 1 where s = 0,  q = -s/|s| elsewhere.
/// A cell sticks by its own slip t, and slips in the direction of the slip c at its centre. With a
/// length r both are q = P(q - r s), P the projection onto the unit disc; s is t up to the disc,
/// and becomes c beyond, by a part that grows with |q - r0 t| - 1 from 0 to 1. Where the slip turns
/// within a cell, the disc of P shrinks to the mean of its directions: docs/ellipse.md. As the right
/// side is continuous in q, there is a solution (Brouwer). Newton's method starts from adhesion and
/// has the slip of cells that slip, and the motion, as unknowns. It goes back on the way of a system
/// that makes the residual larger. If it does not converge, other lengths r and shorter steps of q
/// are tried.
/// \param limits  g, > 0, over G and by p/v of the cell's centre: n
/// \param load    in the scale of PatchResponse
/// \param start   where to start; nullptr for adhesion
/// \param imposed  slip in a step by what was before it; nullptr in steady rolling
/// \param discs    those of the start are for a step over whose way they hardly change; there is a
///                solution near the start then
/// \throws NotConverged
PatchState solve_stick_slip(const PatchResponse& response, const Eigen::VectorXd& limits,
                            const PatchLoad& load, const PatchState* start = nullptr,
                            const ImposedSlip* imposed = nullptr, Discs discs = Discs::of_solution);

/// The derivatives of the resultants by the motion, in a state that is solved. They are exact where
/// no cell changes between stick and slip, and one-sided elsewhere.
/// \return 3 x 3, in the scale of PatchResponse
Eigen::Matrix3d stick_slip_jacobian(const PatchResponse& response, const Eigen::VectorXd& limits,
                                    const PatchState& state);

}  // namespace microslip
