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
  /// \param zone   the stick zone under a positive creepage; none in full sliding, and without a
  ///               load
  /// \param load   that the state carries
  InvertedSolution(std::shared_ptr<const InvertedContact> contact,
                   std::shared_ptr<const StickZone> zone, const Prescribed& load, int evaluations);

  double creepage() const;     ///< w  [1]
  double force() const;        ///< F  [N/mm]
  double dissipation() const;  ///< -w F, the energy lost per mm rolled and mm width  [N/mm]
  double stick_edge() const;   ///< b; a in full sliding  [mm]
  double stick_end() const;    ///< f  [mm]
  bool sticks(double x) const;
  double traction(double x) const;  ///< p(x), zero outside the contact  [N/mm^2]
  double slip(double x) const;      ///< s(x) inside the contact  [1]

  /// u at ascending places inside the contact  [mm]
  Eigen::VectorXd displacement(const Eigen::VectorXd& x) const;

  int evaluations() const { return evaluations_; }  ///< number of stick zones tried
  Eigen::Index unknowns() const;                    ///< number, in a strip's equations; 0 in plane
                                                    ///< strain
  double condition() const;                         ///< of these equations, in the 1-norm; 1 in
                                                    ///< plane strain

  /// Whether, at many places, the tractions keep the bound and the slip has the right direction. If
  /// not, the contact has more than one stick zone, or a slip zone ahead of it.
  bool keeps_conditions() const;

  /// Evidence from samples, see evidence_by_samples.
  Evidence evidence() const;

 private:
  std::shared_ptr<const InvertedContact> contact_;
  std::shared_ptr<const StickZone> zone_;
  double direction_;  ///< sign of the creepage, +-1; 0 without a load
  double creepage_, force_;
  int evaluations_;
};

/// Steady rolling with one stick zone [b, f], by the inversion of the finite Hilbert transform on
/// the zone: the tractions there follow from the bound in the slip zones alone. The bodies slip
/// behind the stick zone. Under a tabulated bound that falls to zero they slip ahead of it, too;
/// otherwise f = a. The kernel of a strip adds a smooth strain, which is inverted with Chebyshev
/// polynomials. docs/theory.md has the formulas.
///
/// Accuracy: 1e-10 of force, creepage, traction and slip for any load and any bound that leads to
/// one stick zone: tests/unit/inverted_rolling_test.cpp. Cost: O(n) for a load and for each
/// traction value, where n is the number of pieces of the bound; for strips O(m^3), with m = 38 for
/// a strip as wide as the contact.
class InvertedRolling {
 public:
  /// \param fineness  fineness of quadratures and series, >= 1; comparing two values shows the
  ///                  error
  /// \throws std::invalid_argument as SlidingField, for a smooth bound
  InvertedRolling(const Kernel& kernel, const TractionBound& bound, double fineness = 1);

  /// The reason why a solution would cost too much, if there is one: a strip narrower than 0.02
  /// half-widths, or a table of more than 20 000 rows.
  std::optional<std::string> obstacle() const;

  /// \throws std::invalid_argument if a force is not below full sliding
  /// \throws NotConverged          if there is an obstacle, or no such stick zone carries the load
  /// \return a candidate; it is a solution only if keeps_conditions(), which solve() does not check
  InvertedSolution solve(const Load& load) const;

 private:
  std::shared_ptr<const InvertedContact> contact_;

  /// A contact to search for the stick zone. Stages follow one another: for a strip, plane strain
  /// and a coarse series come first.
  struct Stage {
    std::shared_ptr<const InvertedContact> contact;
    double near;  ///< largest change of the logarithm of theta from the previous stage
  };
  std::vector<Stage> stages_;
};

}  // namespace microslip
