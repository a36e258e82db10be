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

  /// Whether tractions keep the bound, and slip its direction, at many places: else there is more
  /// than one zone of stick, or slip before one.
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
/// it: its tractions follow from the bound where the bodies slip, and from nothing else. They slip
/// behind it, and before it where the bound is a table that falls to zero; else c = a. Strips have
/// a smooth strain on top, which Chebyshev's polynomials invert. docs/theory.md has the formulas.
///
/// Accuracy: 1e-10 of force, creepage, traction and slip for any bound that has one stick zone, and
/// any load, tests/unit/inverted_rolling_test.cpp. Cost: O(n) for a load and for each place where
/// tractions are wanted, n the pieces of the bound; for strips O(m^3), m = 38 where the strip is as
/// wide as the contact.
class InvertedRolling {
 public:
  /// \param fineness  of quadratures and series, >= 1: what more of it changes is their error
  /// \throws std::invalid_argument as FullSliding, for a smooth bound
  InvertedRolling(const Kernel& kernel, const TractionBound& bound, double fineness = 1);

  /// Why it would cost too much, if it would: strips narrower than 0.02 half-widths, and tables of
  /// more than 20 000 rows.
  std::optional<std::string> obstacle() const;

  /// \throws std::invalid_argument if a force is not below full sliding
  /// \throws NotConverged          if there is an obstacle, or no such stick zone carries the load
  /// \return which may be no solution: that it keeps the contact conditions is another question
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
