// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "microslip/friction/full_sliding.hpp"
#include "microslip/halfspace/basis.hpp"
#include "microslip/linalg/solver.hpp"
#include "microslip/rolling/creepage_force.hpp"
#include "microslip/support/graded_chebyshev.hpp"

namespace microslip {

/// What a scheme of differences over one element makes of n elements that fill a stick zone, found
/// where the exact solution is known: for a strain that grows linearly (Carter's).
struct EdgeCalibration {
  /// Distance, in elements, from the outermost nodes to the edges at which the scheme feels its
  /// tractions vanish: that for which the force is exact. For n -> inf it tends to 0.825347 for
  /// constant and to 0.884948 for linear functions, as Wiener-Hopf theory says,
  /// tests/unit/calibrated_rolling_test.cpp.
  double offset;
  /// Exact tractions at the nodes over the coefficients there: 1 but next to the edges.
  Eigen::VectorXd values;
};

/// \param elements  n, >= 2; odd for quadratic functions
EdgeCalibration edge_calibration(const Basis& basis, Eigen::Index elements,
                                 const Solver& solver = {});

/// What adhesion takes away from the tractions of full sliding, on the stick zone [b, a]: a part of
/// the bound itself, stretched to the stick zone, and n elements that fill it: their outermost
/// nodes lie EdgeCalibration::offset elements inside its ends.
struct StickLattice {
  double stick_edge;         ///< b  [mm]
  double spacing;            ///< h  [mm]
  Eigen::VectorXd x;         ///< nodes  [mm]
  Eigen::VectorXd elements;  ///< coefficients of the functions  [N/mm^2]
  Eigen::VectorXd values;    ///< tractions at the nodes that they stand for  [N/mm^2]
  Eigen::VectorXd loads;     ///< the functions as line loads  [N/mm]
  double part;               ///< of the stretched bound  [1]
  TractionBound stretched;   ///< centred at x = 0
  FullSliding field;         ///< of that
  double force;              ///< of all that adhesion takes away  [N/mm]
  double creepage;           ///< that belongs to b  [1]
  double residual;           ///< of the equations, over the strain  [1]

  double centre() const { return stick_edge + half_width_of(stretched); }
};

class CalibratedSolution;

/// Steady rolling with one stick zone at the leading edge, by elements, of second order. Full
/// sliding is exact, and only what adhesion takes away from it is made of elements: n of them, on
/// the stick zone wherever that ends. So elements meet an edge of the contact or the stick-slip
/// point only where the scheme feels one, and no element holds either inside. Differences are over
/// one element; there is no step. The stretched bound is what makes the error vanish with the load:
/// where all sticks, it is the solution.
///
/// Accuracy: force and tractions are second order in 1/n for any adhesion and any bound that is
/// smooth but for its square roots, tests/order/calibrated_order_test.cpp.
/// Cost: in plane strain the factors are those of any stick zone, and for strips those of a stick
/// zone nearby are refined; so they are made twice at most. See Solver: O(n log n), or O(n^3) dense
/// and for quadratic functions.
class CalibratedRolling {
 public:
  /// \param basis     constant, linear or quadratic
  /// \param elements  n, >= 2; odd for quadratic functions
  /// \throws std::invalid_argument as FullSliding
  CalibratedRolling(const Kernel& kernel, const TractionBound& bound, const Basis& basis,
                    Eigen::Index elements, const Solver& solver = {});
  ~CalibratedRolling();
  CalibratedRolling(CalibratedRolling&&) noexcept;
  CalibratedRolling& operator=(CalibratedRolling&&) noexcept;

  const Kernel& kernel() const { return kernel_; }
  const TractionBound& bound() const { return bound_; }
  const Basis& basis() const { return basis_; }
  const FullSliding& sliding() const { return sliding_; }

  /// \param stick_edge  b, in [-a, a)  [mm]
  /// The reference holds until the next call.
  const StickLattice& lattice(double stick_edge);

  /// Estimate of the condition number of the last lattice's equations, in the 1-norm.
  double condition() const;

  /// A point of the creepage-force curve.
  CreepageForce at(double stick_edge);

  /// \throws as meet_load
  CalibratedSolution solve(const Load& load);

 private:
  StickLattice make_lattice(double stick_edge);
  CreepageForceCurve curve();
  LoadedState meet(const Load& load);

  Kernel kernel_;
  TractionBound bound_;
  Basis basis_;
  Eigen::Index elements_;
  FullSliding sliding_;
  Solver solver_;
  std::unique_ptr<class StrainSystem> system_;
  EdgeCalibration calibration_;
  std::optional<StickLattice> lattice_;  ///< the last one
};

/// A steady state as functions of the position.
class CalibratedSolution : public LoadedSolution {
 public:
  CalibratedSolution(CalibratedRolling& rolling, const LoadedState& loaded);

  bool sticks(double x) const { return lattice_ && x >= stick_edge(); }
  double traction(double x) const;      ///< p(x), zero outside the contact  [N/mm^2]
  double slip(double x) const;          ///< s(x) inside the contact  [1]
  double displacement(double x) const;  ///< u(x) inside the contact  [mm]

  /// By samples of an element each, see evidence_by_samples.
  Evidence evidence() const;

 private:
  double removed(double x) const;
  double behind_elements() const;
  double strain_of_loads(double x) const;
  double displacement_of_loads(double x) const;
  void interpolate_loads();
  double removed_strain(double x) const;
  double removed_displacement(double x) const;
  double slip_behind(double x) const;

  Kernel kernel_;
  TractionBound bound_;
  FullSliding sliding_;
  std::optional<StickLattice> lattice_;           ///< none in full sliding
  std::optional<GradedChebyshev> strain_behind_;  ///< of many elements, by the distance from them
  double nearest_displacement_ = 0;  ///< of them, at the least of these distances  [mm]
  double anchor_ = 0;                ///< a place in adhesion  [mm]
  double anchor_displacement_ = 0;   ///< there  [mm]
};

}  // namespace microslip
