// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/friction/traction_bound.hpp"

namespace microslip::experiments {

/// A shift without rolling from no tractions, for a polynomial bound in plane strain: the tractions
/// of full sliding minus the tractions of full sliding on the stick zone under a smaller normal
/// load, which are also a polynomial times square roots. Source: J. Jäger, Arch. Appl. Mech. 65
/// (1995), 478; M. Ciavarella (1998). Accuracy: 1e-12 relative, tests/study/fretting_test.cpp
class SuperposedShift {
 public:
  /// \param compliance  2 (1 - nu)/G  [mm^2/N]
  /// \param length      L0  [mm]
  SuperposedShift(const PolynomialBound& bound, double compliance, double length);

  struct StickZone {
    double centre;       ///< [half-widths]
    double half_length;  ///< [half-widths]
  };

  /// \param force  F, in (0, full sliding)  [N/mm]
  StickZone stick_zone(double force) const;

  /// Rigid shift, taken as positive with the force  [mm]
  /// \param force  F, in [0, full sliding)  [N/mm]
  double shift(double force) const;

  /// The dissipation of a cycle between -+F, by Masing's rule  [N]
  double dissipation(double force) const;

 private:
  Eigen::VectorXd strain_on(const StickZone& zone) const;
  double centre_of(double half_length) const;

  double scale_;   ///< half-width, for forces by dimensionless tractions  [mm]
  double factor_;  ///< compliance over pi times the half-width  [mm^3/N]
  double log_length_;
  Eigen::VectorXd sines_;  ///< coefficients of the bound in U_n times the square root  [N/mm^2]
};

}  // namespace microslip::experiments
