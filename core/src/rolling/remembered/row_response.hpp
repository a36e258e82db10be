// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "microslip/friction/active_set.hpp"
#include "microslip/halfspace/kernel.hpp"
#include "microslip/rolling/transient_problem.hpp"
#include "row_edges.hpp"
#include "row_points.hpp"

namespace microslip {

/// Means of the mirrored bound over elements at x; as element_means()
Eigen::VectorXd mirrored_means(const TractionBound& bound, const Eigen::VectorXd& x,
                               const Eigen::VectorXd& lengths);

/// The displacements of a row by its tractions and by the pressure: at the nodes, at the entry, and
/// at the exit.
///
/// Tractions are on the problem's contact, whatever the half-width. In plane strain, another
/// half-width has the same response and a common compliance, which shifts the whole contact in
/// proportion to the force; a strip needs a new response.
///
/// A row of bodies that roll backward is the mirrored row, x' = -x and p'(x') = -p(-x'). The
/// influence of tractions is the same; bound and pressure are mirrored.
class RowResponse {
 public:
  /// \param grid  the row's nodes
  RowResponse(const TransientProblem& problem, const Grid& grid, const RowEdges& edges);

  const RowNodes& nodes() const { return nodes_; }
  ActiveSet& active_set() { return active_set_; }
  const Kernel& kernel() const { return kernel_; }  ///< on the problem's contact

  /// The half-width of the contact that responds, over the problem's.
  double half_width() const { return half_width_; }

  /// The displacement of all nodes alike by a unit of force  [mm^2/N]
  double common() const { return common_; }

  /// The first element, on its spring.
  const CompliantElement& exit() const { return exit_; }

  /// Takes another half-width: the kernel's lengths are divided by it.
  void set_half_width(double half_width);

  /// Takes the bound and the pressure of the contact, or of the mirrored contact.
  void face(bool backward) { facing_ = backward ? 1 : 0; }
  bool faces_backward() const { return facing_ == 1; }

  /// Counts how often the influence coefficients have changed.
  int version() const { return version_; }

  /// A solver for an element more, at the entry.
  ActiveSet with_entry() const;

  /// \return force of tractions  [N/mm]
  double force(const Eigen::VectorXd& traction) const { return nodes_.spacing * traction.sum(); }

  /// \return displacement of the nodes by tractions, with the exit's spring  [mm]
  Eigen::VectorXd displaced_by(const Eigen::VectorXd& traction) const;

  /// \param entry  traction of the element at the entry  [N/mm^2]
  /// \return displacement of the nodes  [mm]
  Eigen::VectorXd displaced_by_entry(double entry) const;

  /// Computes the displacements at entry and exit.
  /// \param entry  traction of the element at the entry  [N/mm^2]
  void displace_ends(RowPoints& nodes, const Eigen::VectorXd& traction, double entry) const;

  /// Displacement by the pressure at nodes, entry and exit; zero unless bodies differ in material
  /// [mm]
  const Eigen::VectorXd& pressed() const { return facings_[facing_].pressed; }

  /// \return work of tractions on the strain by the pressure, per distance rolled  [N/mm]
  double work_of_pressure(const Eigen::VectorXd& traction) const {
    return pressure_strain_ * nodes_.spacing * traction.dot(bound());
  }

  /// The bound on the problem's contact, as means over elements  [N/mm^2]
  const Eigen::VectorXd& bound() const { return facings_[facing_].bound; }

 private:
  struct Facing {
    Eigen::VectorXd bound;    ///< N
    Eigen::VectorXd pressed;  ///< N + 2
  };

  static Facing facing_of(const TransientProblem& problem, const Grid& grid, bool backward);
  void set_influence(const Kernel& kernel);

  RowNodes nodes_;
  Kernel kernel_;
  Solver solver_;
  ActiveSet active_set_;
  Eigen::VectorXd influence_;  ///< displacement by an element 0 ... N + 1 elements away  [mm^3/N]
  double half_width_ = 1;
  int version_ = 0;
  double common_ = 0;
  CompliantElement exit_;
  std::array<Facing, 2> facings_;  ///< forward and backward
  std::size_t facing_ = 0;
  double pressure_strain_;  ///< [mm^2/N]
};

}  // namespace microslip
