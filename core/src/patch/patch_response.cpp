// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/patch_response.hpp"

#include <array>

#include "microslip/linalg/lu_factors.hpp"
#include "microslip/linalg/matrix_product.hpp"
#include "mirror_parts.hpp"
#include "slip_maps.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Makes the own slip, from the centre of a cell to the point ahead: the centre ahead, or the
/// leading edge. It is the slip halfway.
PatchSlipMap map_own_slip(const JoinedRows& rows, const PatchResponse::Matrix& displacement) {
  PatchSlipMap map = map_for(rows);
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      const Index here = 2 * i + 1, ahead = i == 0 ? 0 : here - 2;
      const double from = rows.x(ahead, k), to = rows.x(here, k);
      const double weight = 1 / (from - to);
      set_slip(map, rows, displacement, i, k, {{here, ahead}, {weight, -weight}, (from + to) / 2},
               rows.y(k));
    }
  }
  return map;
}

PatchSlipMap map_centre_slip(const JoinedRows& rows, const PatchResponse::Matrix& displacement) {
  PatchSlipMap map = map_for(rows);
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      set_slip(map, rows, displacement, i, k, centre_slip(rows, i, k), rows.y(k));
    }
  }
  return map;
}

}  // namespace

SeenSlip SeenSlip::steady(Index cells) {
  const VectorXd none = VectorXd::Zero(cells), all = VectorXd::Ones(cells);
  return {.by_own = all, .by_ahead = none, .ways = all};
}

PatchResponse::PatchResponse(const JoinedRows& rows, double poisson_ratio)
    : PatchResponse(rows, displacement_by_traction(rows, poisson_ratio)) {}

PatchResponse::PatchResponse(const JoinedRows& rows, const Matrix& displacement)
    : PatchResponse(rows, map_own_slip(rows, displacement), map_centre_slip(rows, displacement),
                    map_pole(rows, [](Index, Index) { return 1.0; }),
                    SeenSlip::steady(rows.cells())) {}

PatchResponse::PatchResponse(const JoinedRows& rows, const PatchSlipMap& own,
                             const PatchSlipMap& centre, const Stencils& pole, const SeenSlip& seen)
    : rows_(rows), pole_(pole), seen_(seen) {
  solve(own.by_traction, centre.by_traction);
  const auto norm = [](const auto& map) { return map.cwiseAbs().colwise().sum().maxCoeff(); };
  condition_ = norm(own.by_traction) * norm(unknowns_);
  rigid_own_slip_ = own.by_motion;
  rigid_centre_slip_ = centre.by_motion;
  stiffness_ = own.by_traction.diagonal();
  resultants_ = resultants_by_traction(rows);
  if (rolls()) pole_slip_ = pole_ * unknowns_;
  // `unknowns_` has its rows in order, so that its transpose is what the product takes.
  relief_ = matrix_product(unknowns_.transpose(), resultants_.transpose()).transpose();
  linear_ = -matrix_product(relief_, rigid_own_slip_);
}

void PatchResponse::see(const VectorXd& own, const VectorXd& imposed, VectorXd& found) const {
  const Index n = rows_.cells();
  if (!rolls()) {
    found.setZero(2 * n);
    return;
  }
  found.resize(2 * n);
  for (const Index first : {Index{0}, n}) {
    found.segment(first, n) = seen_.by_own.cwiseProduct(own.segment(first, n));
    found.segment(first + 1, n - 1) +=
        seen_.by_ahead.tail(n - 1).cwiseProduct(own.segment(first, n - 1));
  }
  if (imposed.size() > 0) found += imposed;
}

void PatchResponse::solve(const MatrixXd& own, const MatrixXd& centre) {
  if (rows_.shape().is_mirrored()) {
    const MirrorParts mirror(rows_);
    if (mirror.apply_to(own) && mirror.apply_to(centre)) {
      std::array<MatrixXd, 2> unknowns, centre_slip;
      for (std::size_t part = 0; part < 2; ++part) {
        unknowns[part] = LuFactors(mirror.part_of(own, part)).inverse();
        centre_slip[part] = matrix_product(mirror.part_of(centre, part), unknowns[part]);
      }
      unknowns_ = mirror.joined(unknowns);
      centre_slip_ = mirror.joined(centre_slip);
      return;
    }
  }
  const MatrixXd inverse = LuFactors(own).inverse();
  unknowns_ = inverse;
  centre_slip_ = matrix_product(centre, inverse);
}

}  // namespace microslip
