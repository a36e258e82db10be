// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "microslip/friction/active_set.hpp"
#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/kernel.hpp"
#include "microslip/rolling/evidence.hpp"

namespace microslip {

class InvertedContact;
class StickZone;

/// A steady state as functions of the position.
class InvertedSolution {
 public:
  /// \param zone   of a positive creepage; none in full sliding, and without a load
  /// \param load   that it meets
  InvertedSolution(std::shared_ptr<const InvertedContact> contact,
                   std::shared_ptr<const StickZone> zone, const Load& load, int evaluations);

  double creepage() const;     ///< w  [1]
  double force() const;        ///< F  [N/mm]
  double dissipation() const;  ///< -w F, the energy lost per mm rolled and mm width  [N/mm]
  double stick_edge() const;   ///< b; a in full sliding  [mm]
  double stick_end() const;    ///< c  [mm]
  bool sticks(double x) const;
  double traction(double x) const;  ///< p(x), zero outside the contact  [N/mm^2]
  double slip(double x) const;      ///< s(x) inside the contact  [1]

  /// u at ascending places inside the contact  [mm]
  Eigen::VectorXd displacement(const Eigen::VectorXd& x) const;

  int evaluations() const { return evaluations_; }  ///< of stick zones
  Eigen::Index unknowns() const;                    ///< of a strip's equations; 0 in plane strain
  double condition() const;                         ///< of these, in the 1-norm; 1 without

  /// Whether tractions keep the bound, and slip its direction, at many places. If not, the contact
  /// has more than one stick zone, or a slip zone before it.
  bool keeps_conditions() const;

  /// By samples, see evidence_by_samples.
  Evidence evidence() const;

 private:
  std::shared_ptr<const InvertedContact> contact_;
  std::shared_ptr<const StickZone> zone_;
  double direction_;  ///< of the creepage, +-1; 0 without a load
  double creepage_, force_;
  int evaluations_;
};

/// Steady rolling with one stick zone [b, c], by the inversion of the finite Hilbert transform on
/// the zone: its tractions follow from the bound in the slip zones, and from nothing else. The
/// bodies slip behind the stick zone. They slip before it, too, where the bound is a table that
/// falls to zero; otherwise c = a. The kernel of a strip adds a smooth strain, which Chebyshev's
/// polynomials invert. docs/theory.md has the formulas.
///
/// Accuracy: 1e-10 of force, creepage, traction and slip for any bound that has one stick zone, and
/// any load, tests/unit/inverted_rolling_test.cpp. Cost: O(n) for a load and for each place where
/// tractions are wanted, n the pieces of the bound; for strips O(m^3), m = 38 where the strip is as
/// wide as the contact.
class InvertedRolling {
 public:
  /// \param fineness  of quadratures and series, >= 1; a comparison of two shows their error
  /// \throws std::invalid_argument as FullSliding, for a smooth bound
  InvertedRolling(const Kernel& kernel, const TractionBound& bound, double fineness = 1);

  /// The reason why a solution would cost too much, if it would: a strip narrower than 0.02
  /// half-widths, or a table of more than 20 000 rows.
  std::optional<std::string> obstacle() const;

  /// \throws std::invalid_argument if a force is not below full sliding
  /// \throws NotConverged          if there is an obstacle, or no such stick zone carries the load
  /// \return a solution if it keeps_conditions(), which solve() does not look at
  InvertedSolution solve(const Load& load) const;

 private:
  std::shared_ptr<const InvertedContact> contact_;

  /// Contacts that are searched for the stick zone one after another: for a strip, plane strain and
  /// a coarse series come first.
  struct Stage {
    std::shared_ptr<const InvertedContact> contact;
    double near;  ///< by how much the logarithm of theta may differ from the last one
  };
  std::vector<Stage> stages_;
};

}  // namespace microslip
