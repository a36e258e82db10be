// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/chebyshev_field.hpp"
#include "microslip/rolling/creepage_force.hpp"

namespace microslip {

/// A steady state as functions of the position.
class ChebyshevSolution : public LoadedSolution {
 public:
  /// The traction that adhesion takes away from full sliding, and the quality of its equations.
  struct Adhesion {
    ChebyshevField field;
    double residual;   ///< residual of the equations, over the strain  [1]
    double condition;  ///< condition number of the equations, in the 1-norm
  };

  /// \param sliding   the field of the bound as traction
  /// \param adhesion  the traction that adhesion takes away; none in full sliding
  ChebyshevSolution(const LoadedState& loaded, ChebyshevField sliding,
                    const std::optional<Adhesion>& adhesion);

  bool sticks(double x) const { return adhesion_ && x >= stick_edge(); }
  double traction(double x) const;      ///< p(x), zero outside the contact  [N/mm^2]
  double slip(double x) const;          ///< s(x) inside the contact  [1]
  double displacement(double x) const;  ///< u  [mm]
  Eigen::VectorXd displacement(const Eigen::VectorXd& x) const;  ///< u at each place  [mm]

  /// Evidence from samples, see evidence_by_samples.
  Evidence evidence() const;

 private:
  ChebyshevField sliding_;
  std::optional<ChebyshevField> adhesion_;
};

/// Steady rolling with one stick zone [b, a] at the leading edge, by a spectral method. Adhesion
/// takes sqrt(1 - t^2) times a polynomial away from full sliding on the stick zone. Collocation at
/// the n + 1 zeros of T_(n+1) gives the n coefficients of that polynomial and the creepage that
/// belongs to the trailing end b. In plane strain the matrix is diagonal in Chebyshev polynomials.
/// Accuracy: 1e-11 of force, creepage and traction, with at most 64 unknowns, for strips at least
/// as wide as the half-width and bounds sqrt(1 - x^2) times a smooth function,
/// tests/unit/chebyshev_rolling_test.cpp. Cost: O(n^3) for each value of b, n = 4 ... 64.
class ChebyshevRolling {
 public:
  /// \throws std::invalid_argument for a tabulated bound, which is not smooth; and as
  ///                               ChebyshevField
  /// \throws NotConverged          if 64 unknowns do not suffice
  ChebyshevRolling(const Kernel& kernel, const TractionBound& bound);

  /// \param unknowns  n, 1 to 64, fixed instead of as many as needed
  ChebyshevRolling(const Kernel& kernel, const TractionBound& bound, Eigen::Index unknowns);

  Eigen::Index unknowns() const { return unknowns_; }

  /// A point of the creepage-force curve.
  /// \param stick_edge  b, in [-a, a)  [mm]
  CreepageForce at(double stick_edge) const;

  /// \throws std::invalid_argument if a force is not below full sliding
  /// \throws NotConverged          if the contact conditions are violated by more than 1e-9 of the
  ///                               load: then there is more than one stick zone; or if 64 unknowns
  ///                               do not suffice for ten digits of the load
  ChebyshevSolution solve(const Load& load) const;

 private:
  struct Zone {
    Eigen::VectorXd coefficients;
    double creepage;
    double residual;
    double condition;
  };
  void add_unknowns();
  void tabulate();
  Zone zone(double stick_edge) const;
  CreepageForceCurve curve() const;

  Kernel kernel_;
  ChebyshevField sliding_;
  Eigen::Index unknowns_;
  bool fixed_;                   ///< whether the number of unknowns is fixed
  Eigen::VectorXd collocation_;  ///< collocation points, in (-1, 1)
  Eigen::VectorXd quadrature_;   ///< quadrature points, in (-1, 1)
  Eigen::MatrixXd strains_;      ///< of each term in plane strain, and a column of ones, at the
                                 ///< collocation points
  Eigen::MatrixXd loads_;        ///< of each term, at the quadrature points
};

}  // namespace microslip
