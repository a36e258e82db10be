// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>

#include "microslip/friction/full_sliding.hpp"
#include "microslip/rolling/material_window.hpp"

namespace microslip {

/// What elements miss of the displacement by a contact that slides everywhere: exact less A g, at
/// the nodes of a window with its bounds g. Before the leading edge the exact one is continued, see
/// FullSliding: that is what the scheme feels.
class BoundDefect {
 public:
  /// \throws std::invalid_argument as FullSliding
  BoundDefect(const Kernel& kernel, const TractionBound& bound, const MaterialWindow& window);

  /// A times tractions of the window
  using Respond = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

  /// At a phase of the window  [mm]. O(N^2), and N times FullSliding::displacement; it is kept.
  const Eigen::VectorXd& at(double phase, const Respond& respond) const;

  /// Its change at material points between two phases, a length apart; zero at the last node if
  /// the window has moved on, which did not know it before  [mm]
  /// \param moved  by how many nodes, 0 or 1
  Eigen::VectorXd change(double before, double after, Eigen::Index moved, double length,
                         const Respond& respond) const;

 private:
  FullSliding sliding_;
  MaterialWindow window_;
  mutable std::map<long long, Eigen::VectorXd> known_;
};

}  // namespace microslip
