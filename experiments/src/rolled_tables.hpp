// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "microslip/experiments/cattaneo_to_carter.hpp"
#include "microslip/scene/table.hpp"

namespace microslip::experiments {

/// Tractions and errors of Cattaneo to Carter for several schemes, step ratios and distances: the
/// tables traction, reference and summary of the transient studies.
class RolledTables {
 public:
  /// \param refinement  elements of the reference for each one
  RolledTables(const CattaneoToCarter& rolling, Eigen::Index refinement);

  /// Rolls and adds what comes out.
  void add(const std::string& name, const AdvectionScheme& scheme, double step_ratio,
           double distance);

  const Table& traction() const { return traction_; }    ///< a row a node
  const Table& reference() const { return reference_; }  ///< a row a node of the finer grid
  const Table& summary() const { return summary_; }      ///< a row a call of add()

 private:
  /// What all results at one distance are compared with.
  struct Yardstick {
    Eigen::VectorXd fine;  ///< the reference at the nodes
    double peak;           ///< largest |p| of the reference
    double flank;          ///< where its |p| falls to a third of that  [mm]
    Eigen::VectorXd unit;  ///< the direct scheme with c = 1
  };

  const Yardstick& yardstick(double distance);

  CattaneoToCarter rolling_;
  Eigen::Index refinement_;
  std::map<double, Yardstick> yardsticks_;
  Table traction_;
  Table reference_;
  Table summary_;
};

}  // namespace microslip::experiments
