// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <variant>
#include <vector>

#include "microslip/linalg/solver.hpp"
#include "microslip/linalg/square_matrix.hpp"

namespace microslip {

/// The bodies roll with this creepage, and the force follows.
struct PrescribedCreepage {
  double value;  ///< relative rigid slip w, finite  [1]
};

/// The bodies carry this force, and the creepage follows.
struct PrescribedForce {
  double value;  ///< F, less in absolute value than full sliding  [N/mm]
};

using Load = std::variant<PrescribedCreepage, PrescribedForce>;

/// The load of a step of some length as that of a slip displacement: a creepage grows with it, and
/// a force stays.
Load over(const Load& load, double length);

/// In slip, the sign is that of the traction.
enum class Zone : signed char { slip_negative = -1, adhesion = 0, slip_positive = 1 };

/// An element that yields: a compliance times the change of its traction adds to its slip.
struct SoftElement {
  Eigen::Index element;
  double compliance;  ///< >= 0, in the unit of the response
};

/// What the slip of n traction coefficients p starts from, and the bound they must keep:
/// s = w + offset + (response + soft) (p - reference), |p_i| <= bound_i. Where the bound is zero,
/// so is p, whatever the slip.
struct SlipConditions {
  Eigen::VectorXd bound;      ///< n, >= 0  [N/mm^2]
  Eigen::VectorXd offset;     ///< n, in the unit of the slip
  Eigen::VectorXd reference;  ///< n  [N/mm^2]
  std::vector<SoftElement> soft = {};
};

/// How exactly slip conditions are met.
struct Residuals {
  double equations = 0;  ///< slip left in adhesion, over the largest term of its equations  [1]
  double bound = 0;      ///< of |p| above the bound, over the largest bound  [1]
  double slip = 0;  ///< of slip along the traction instead of against it, over the largest slip
                    ///< [1]
};

/// The answer to slip conditions.
struct ContactState {
  Eigen::VectorXd traction;  ///< n  [N/mm^2]
  Eigen::VectorXd slip;      ///< n, zero in adhesion
  std::vector<Zone> zones;   ///< n
  double creepage = 0;       ///< w, prescribed or found, in the unit of the slip
  int iterations = 0;        ///< partitions tried
  Residuals residuals = {};
};

/// Finds tractions, slip and their partition: in adhesion s = 0 and |p| <= bound, in slip
/// p = -bound s/|s|. Slip and creepage have the unit of response times traction: relative slip [1],
/// or slip displacement [mm].
///
/// First all violating elements are exchanged at once, those above the bound before those with the
/// wrong direction of slip: thesis 3.1.1. From adhesion everywhere and for c near 1 this takes
/// about log2(n) rounds; for c << 1 the partitions never settle. So an element may be released from
/// adhesion once. Then an exact path is followed, exchanging one element at a time: from bounds and
/// offsets that make the partition which the search started from the solution, down to the given
/// ones. From a partition nearby that takes as many exchanges as it differs by, or few more. If it
/// takes more than 60, the path starts again from a bound so high that all stick.
///
/// Termination: the first phase has at most 3 n rounds. On a path the solution is piecewise linear
/// in the part of the relief that is left, with one piece a partition; if response + response^T is
/// positive definite, it is unique, and each of the finitely many partitions is met at most once.
/// A is, and A - A' for all c <= 1 that were tried (tests/unit/active_set_test.cpp).
/// Otherwise the path is given up after 20 n + 100 exchanges.
///
/// Cost of a dense response: n^2 numbers, and O(n^3) for the first factors. They are kept from
/// solve to solve: a round with few exchanges costs O(n^2), as does a solve whose partition stays.
/// The compliances of soft elements may change from solve to solve at no cost. Of a Toeplitz
/// response: O(n) numbers and O(n log n) each, about 14 transforms of 2n numbers where the
/// partition stays.
class ActiveSet {
 public:
  /// \param response  n x n, of the slip to the traction
  /// \param weights   n, > 0: force = weights . p  [mm]
  /// \param solver    its tolerance; the response itself is dense or Toeplitz
  ActiveSet(SquareMatrix response, Eigen::VectorXd weights, const Solver& solver = {});
  ~ActiveSet();
  ActiveSet(const ActiveSet& other);  ///< with the factors, so that it goes on to the bit alike
  ActiveSet& operator=(const ActiveSet& other);
  ActiveSet(ActiveSet&&) noexcept;
  ActiveSet& operator=(ActiveSet&&) noexcept;

  /// \param state  in: zones to start from, n of them; out: the solution. Nothing is allocated if
  ///               the partitions tried are those of solves before, or differ from that of the
  ///               factors by a few elements that also did so before.
  /// \throws std::invalid_argument if the force is not below full sliding, weights . bound
  /// \throws NotConverged          if a system is singular or its residual above the tolerance, or
  ///                               the path is given up or ends short of a solution
  void solve(const SlipConditions& conditions, const Load& load, ContactState& state);

  /// The same from adhesion everywhere, or from the zones given.
  ContactState solve(const SlipConditions& conditions, const Load& load);
  ContactState solve(const SlipConditions& conditions, const Load& load,
                     const std::vector<Zone>& first);

  /// Estimate of the condition number of the equations in adhesion of the last partition, in the
  /// 1-norm; 1 if nothing sticks. New factors where the last ones are bordered, and some five
  /// solves.
  double condition();

  const SquareMatrix& response() const;

 private:
  std::unique_ptr<class ContactSearch> search_;
};

}  // namespace microslip
