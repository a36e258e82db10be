// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/reference/kalker.hpp"

namespace microslip {

/// Fast laws of creep forces on Hertz's ellipse, as programs of vehicle dynamics have them. A motion
/// is xi, eta [1] and phi [1/mm]; the rigid slip is (xi - phi y, eta + phi x). Forces are those on
/// the body whose surface has this slip: a positive creepage gives a negative force. All laws have
/// the slopes of Kalker's coefficients under a motion of one component, and full sliding for large
/// creepages.
struct CreepForceContact {
  double half_width;               ///< a, along the rolling, > 0  [mm]
  double lateral_half_width;       ///< b, > 0  [mm]
  double shear_modulus;            ///< G, > 0  [N/mm^2]
  double full_sliding;             ///< mu F_n, > 0  [N]
  CreepCoefficients coefficients;  ///< C11, C22 and C23, > 0; the others have no part

  double size() const;  ///< c = (a b)^(1/2)  [mm]
};

/// Forces along and across without slip: -G c^2 (C11 xi, C22 eta + C23 c phi)  [N]
Eigen::Vector2d linear_creep_force(const CreepForceContact& contact, const Eigen::Vector3d& motion);

/// The law of Vermeulen and Johnson (Journal of Applied Mechanics 31, 1964, 338-340) with Kalker's
/// coefficients, and spin in the linear force, as Shen, Hedrick and Elkins have it (8th IAVSD
/// Symposium, 1983, 591-605): the force has the direction of the linear one, of the size T, and with
/// t = T/(3 mu F_n), at most 1, its size is mu F_n (1 - (1 - t)^3)  [N].
Eigen::Vector2d vermeulen_johnson(const CreepForceContact& contact, const Eigen::Vector3d& motion);

/// Polach's law (Vehicle System Dynamics 33 Supplement, 1999, 728-739): stress grows linearly from
/// the leading edge until it meets the bound; the force has the direction of the creepage, and spin
/// adds a force across the rolling. Forces along and across [N].
Eigen::Vector2d polach(const CreepForceContact& contact, const Eigen::Vector3d& motion);

/// Flexibilities of FASTSIM.
enum class Flexibilities {
  three,  ///< one for each component of the motion
  one     ///< their sum, weighted with |xi|, |eta| and c |phi|, over the length of these
};

/// Kalker's program FASTSIM (Vehicle System Dynamics 11, 1982, 1-13): in each of the rows along the
/// rolling, tractions grow from the leading edge on by the rigid slip over a flexibility, up to a
/// paraboloid of the same force as Hertz's bound. Rows are equally high, and the elements of a row
/// equally long.
/// Order: in the number of cells 1 under spin, otherwise 2; 100 of them have errors of 4e-3 of full
/// sliding under strong spin, and 5e-5 without: tests/unit/creep_force_laws_test.cpp
/// \param cells  rows, and elements of each, >= 1
/// \return forces along and across [N], and the moment [N mm]
/// \throws std::invalid_argument outside the range
Eigen::Vector3d fastsim(const CreepForceContact& contact, const Eigen::Vector3d& motion,
                        Flexibilities flexibilities, Eigen::Index cells = 100);

}  // namespace microslip
