// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "creep_tables_states.hpp"
#include "microslip/reference/kalker.hpp"

namespace microslip::experiments {

/// The layout of USETAB, Kalker's table of creep forces (Proceedings of the International Conference on
/// Contact Mechanics and Wear, 1996), at one a/b, with nodes of our own. Creepages over 2 pi/C11 and
/// 2 pi/C22 and the spin over 2 pi/(3 C23), all in mu p0/G, have nodes at i/7 and 7/i; forces are linear
/// in each of them up to 1, and in their reciprocals from there on. The spin has both signs; other motions
/// follow by symmetry. Facts of the layout: src/usetab_table.f90 of https://github.com/eve70a/CONTACT.
class UsetabLayout {
 public:
  /// Solves the nodes on which some states depend, on all cores.
  UsetabLayout(double ratio, const std::vector<Eigen::Vector3d>& motions, Eigen::Index cells);

  /// \param motion  one of those given before
  /// \return        over mu F_n, and mu F_n c
  Eigen::Vector3d forces(const Eigen::Vector3d& motion) const;

  /// Nodes that were solved, of 16 x 16 x 29 different ones.
  std::size_t nodes() const { return solved_; }

 private:
  struct Place;
  Place place_of(const Eigen::Vector3d& motion) const;

  Eigen::Vector3d scales_;
  std::vector<Eigen::Vector3d> forces_;
  std::size_t solved_ = 0;
};

}  // namespace microslip::experiments
