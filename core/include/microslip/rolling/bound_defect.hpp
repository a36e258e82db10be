// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>

#include "microslip/friction/full_sliding.hpp"
#include "microslip/linalg/square_matrix.hpp"
#include "microslip/rolling/material_window.hpp"

namespace microslip {

/// What elements miss of the displacement by a contact that slides everywhere: exact less A g, at
/// the nodes of a window with its bounds g. Before the leading edge the exact one is continued, see
/// FullSliding: that is what the scheme feels.
class BoundDefect {
 public:
  /// \throws std::invalid_argument as FullSliding
  BoundDefect(const Kernel& kernel, const TractionBound& bound, const MaterialWindow& window);

  /// At a phase of the window  [mm]. A product, and N times FullSliding::displacement; it is kept.
  /// \param response  A of the window
  const Eigen::VectorXd& at(double phase, const SquareMatrix& response) const;

  /// Its change at material points between two phases, a length apart; zero at the last node if
  /// the window has moved on, which did not know it before. Allocates nothing where the phases are
  /// known, or where the length is below a ten thousandth of an element.
  /// \param moved   by how many nodes, 0 or 1
  /// \param change  out  [mm]
  void change(double before, double after, Eigen::Index moved, double length,
              const SquareMatrix& response, Eigen::VectorXd& change) const;

 private:
  FullSliding sliding_;
  MaterialWindow window_;
  /// Copies share what is known.
  mutable std::map<long long, std::shared_ptr<const Eigen::VectorXd>> known_;
  mutable Eigen::VectorXd bound_, bound_before_, by_elements_;
};

}  // namespace microslip
