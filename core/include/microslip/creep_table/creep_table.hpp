// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "microslip/creep_table/creep_table_nodes.hpp"
#include "microslip/friction/elliptic_bound.hpp"

namespace microslip {

/// Forces and moment of contact ellipses by interpolation between solutions: for a/b of its layout,
/// and any creepages and spin. Motions and results have no units: motions are over mu p0/G, the
/// spin times c, c = (a b)^(1/2); forces are over mu F_n, and the moment over mu F_n c. So one table
/// serves all loads and materials of one Poisson ratio.
///
/// It is exact at rest and in its slopes there, and has exact full sliding at its nodes. Between the
/// nodes it is a cubic spline along all four axes, with continuous second derivatives, but for
/// directions that are close to pure spin: there, a linear function of the direction takes over, and
/// first derivatives are continuous. Symmetries are exact. Equations: docs/creep_tables.md.
///
/// Any number of threads may use one table. Cost: about 1 us.
class CreepTable {
 public:
  /// \throws std::invalid_argument unless the nodes fit their layout
  explicit CreepTable(const CreepTableNodes& nodes);

  /// \param ratio     a/b, within the layout  [1]
  /// \param motion    xi, eta and phi c over mu p0/G  [1]
  /// \param jacobian  out, may be nullptr: derivatives of the result by the motion
  /// \return          Fx, Fy over mu F_n and Mz over mu F_n c  [1]
  /// \throws std::invalid_argument outside the ranges, and for a motion that is not finite
  Eigen::Vector3d forces(double ratio, const Eigen::Vector3d& motion,
                         Eigen::Matrix3d* jacobian = nullptr) const;

  /// The same with units, for an ellipse that rolls under any load and friction.
  /// \param shear_modulus  G, > 0  [N/mm^2]
  /// \param bound          with a/b within the layout
  /// \param motion         xi, eta [1] and phi [1/mm]
  /// \param jacobian       out, may be nullptr
  /// \return               Fx, Fy [N] and Mz [N mm]
  /// \throws std::invalid_argument as forces()
  Eigen::Vector3d resultants(double shear_modulus, const EllipticBound& bound,
                             const Eigen::Vector3d& motion,
                             Eigen::Matrix3d* jacobian = nullptr) const;

  const CreepTableLayout& layout() const { return layout_; }

 private:
  struct Slopes;
  Slopes spline_at(double ratio_place, double step_place, double polar, double azimuth) const;
  Slopes cap_at(double ratio_place, double step_place, double polar, double azimuth) const;
  CreepCoefficients coefficients_at(double ratio_place) const;
  Eigen::Vector3d forces_of_octant(double ratio, const Eigen::Vector3d& motion,
                                   Eigen::Matrix3d* jacobian) const;
  void prepare_cap();

  CreepTableLayout layout_;
  std::vector<float> spline_;  ///< by ratio, step, polar angle, azimuth and result
  std::vector<double> cap_;    ///< by ratio and step: values and slopes at pure spin
  std::array<Eigen::VectorXd, 5> coefficients_;  ///< splines of C11 ... C33 over the ratio
  double cap_angle_ = 0;
};

}  // namespace microslip
