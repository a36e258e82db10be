// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "microslip/experiments/cattaneo_to_carter.hpp"
#include "microslip/scene/table.hpp"

namespace microslip::experiments {

/// Tractions and errors of Cattaneo to Carter for several schemes, step ratios and distances. The
/// tables traction, reference and summary of the transient studies are these.
class RolledTables {
 public:
  /// \param refinement  number of elements of the reference for each element
  RolledTables(const CattaneoToCarter& rolling, Eigen::Index refinement);

  /// Rolls, and adds the result to the tables.
  void add(const std::string& name, const AdvectionScheme& scheme, double step_ratio,
           double distance);

  const Table& traction() const { return traction_; }    ///< a row for each node
  const Table& reference() const { return reference_; }  ///< a row for each node of the finer grid
  const Table& summary() const { return summary_; }      ///< a row for each call of add()

 private:
  /// The solutions with which all results at one distance are compared.
  struct Yardstick {
    Eigen::VectorXd fine;  ///< the reference at the nodes
    double peak;           ///< largest |p| of the reference
    double flank;          ///< x at which |p| of the reference falls to a third of the peak  [mm]
    Eigen::VectorXd unit;  ///< tractions of the direct scheme with c = 1
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
