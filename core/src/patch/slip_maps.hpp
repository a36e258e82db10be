// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>

#include "microslip/patch/joined_rows.hpp"
#include "microslip/patch/patch_response.hpp"

namespace microslip {

/// The displacements along, then across, at the points of rows by the tractions v: 2P x 2n, over the
/// size of the patch and with G = 1.
/// \param poisson_ratio  nu, in [0, 0.5]
PatchResponse::Matrix displacement_by_traction(const JoinedRows& rows, double poisson_ratio);

/// The slip of a cell as displacements at points of its row, times weights, and the rigid slip at x.
struct PointSlip {
  std::array<Eigen::Index, 5> points;
  std::array<double, 5> weights;
  double x;
};

/// Sets the slip of a cell.
/// \param displacement  as displacement_by_traction()
/// \param y             of the rigid slip by spin
void set_slip(PatchSlipMap& map, const JoinedRows& rows, const PatchResponse::Matrix& displacement,
              Eigen::Index i, Eigen::Index k, const PointSlip& slip, double y);

/// An empty map for all cells.
PatchSlipMap map_for(const JoinedRows& rows);

/// The point of a row that has the same displacement as the point j, which may lie two points beyond
/// an edge: displacements are even in theta there, as they are smooth in x.
Eigen::Index mirrored(const JoinedRows& rows, Eigen::Index j);

/// Weights of the cubic through values at first, first + 1, first + 2 and first + 3.
std::array<double, 4> cubic_weights(double at, Eigen::Index first);

/// Four points of a row around an angle, with the weights of the cubic in theta; x is not set.
PointSlip between(const JoinedRows& rows, double theta);

/// Forces along and across, and the moment about the centre, by the unknowns: 3 x 2n.
Eigen::Matrix3Xd resultants_by_traction(const JoinedRows& rows);

/// Makes the map of PatchResponse::pole().
/// \param part  (i, k) -> part that the slip of a cell has of what it lacks in steady rolling
PatchResponse::Stencils map_pole(const JoinedRows& rows,
                                 const std::function<double(Eigen::Index, Eigen::Index)>& part);

/// -du/dx at a centre, by differences of fourth order in theta.
PointSlip centre_slip(const JoinedRows& rows, Eigen::Index i, Eigen::Index k);

}  // namespace microslip
