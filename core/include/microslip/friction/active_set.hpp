// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string_view>
#include <vector>

#include "microslip/friction/load.hpp"
#include "microslip/linalg/linear_operator.hpp"
#include "microslip/linalg/solver.hpp"

namespace microslip {

/// Adhesion or slip of an element; the sign of a slip zone is the sign of the traction.
enum class Zone : signed char { slip_negative = -1, adhesion = 0, slip_positive = 1 };

/// An element on a spring. The spring adds the compliance times the change of traction to the slip.
struct CompliantElement {
  Eigen::Index element;
  double compliance;  ///< >= 0, in the unit of the response matrix

  bool operator==(const CompliantElement&) const = default;
};

class Archive;

/// Writes or reads zones of n elements.
/// \param size  n
void archive_zones(Archive& archive, std::string_view name, std::vector<Zone>& zones,
                   Eigen::Index size);

/// Writes or reads the compliant elements among n elements.
/// \param size  n
void archive_compliant(Archive& archive, std::vector<CompliantElement>& compliant,
                       Eigen::Index size);

/// The slip s as a function of n traction coefficients p, and the bound on p: s = rigid slip +
/// offset + (response + springs) (p - reference) + common (F - reference force), |p_i| <= bound_i.
/// Where the bound is zero, p is zero for any slip.
struct SlipConditions {
  Eigen::VectorXd bound;      ///< n, >= 0  [N/mm^2]
  Eigen::VectorXd offset;     ///< n, in the unit of the slip
  Eigen::VectorXd reference;  ///< n  [N/mm^2]
  std::vector<CompliantElement> compliant = {};
  double common = 0;  ///< shift of all elements alike per unit of force  [slip mm/N]
};

/// Residuals of the slip conditions.
struct Residuals {
  double equations = 0;  ///< slip left in adhesion, over the largest term of the equations  [1]
  double bound = 0;      ///< excess of |p| over the bound, over the largest bound  [1]
  double slip = 0;  ///< slip along the traction instead of against it, over the largest slip [1]
};

/// The solution of slip conditions.
struct ContactState {
  Eigen::VectorXd traction;  ///< n  [N/mm^2]
  Eigen::VectorXd slip;      ///< n, zero in adhesion
  std::vector<Zone> zones;   ///< n
  double rigid_slip = 0;     ///< prescribed or found, in the unit of the slip
  int iterations = 0;        ///< partitions tried
  Residuals residuals = {};
};

/// Finds tractions, slip and the partition into adhesion and slip: in adhesion s = 0 and |p| <=
/// bound, in slip p = -bound s/|s|. Slip and rigid slip have the unit of response times traction:
/// relative slip and creepage [1], or slip displacement and shift [mm].
///
/// The search has two phases. The first phase exchanges all violating elements at once: elements
/// above the bound slip, and elements that slip in the wrong direction stick. (The thesis, 3.1.1,
/// does the second only where there is nothing of the first to do, which takes twice as many rounds
/// where there are many stick zones.) From adhesion everywhere and for c near 1 this phase takes
/// about log2(n) rounds, from the partition of a coarser grid 2 to 6, whatever the number of zones.
/// For c << 1 the partitions never settle, so the phase ends when an element is released from
/// adhesion again and there are as many violations as when this happened before. The second phase
/// exchanges one element at a time along an exact path. The path begins with bounds and offsets for
/// which a known partition is the solution, and ends with the given bounds and offsets. From a
/// partition nearby the path takes about one exchange for each differing element. It begins at the
/// first partition or, if all elements stick there, at the last partition of the first phase. A
/// path of more than 60 exchanges, or 20, begins again, in the end with a bound so high that all
/// elements stick.
///
/// Termination: the first phase ends, because violations have to become fewer. On the path the
/// solution is piecewise linear in the remaining fraction of the relief, with one piece for each
/// partition. If response + response^T is positive definite, the solution is unique, and the path
/// meets each partition at most once. A is positive definite, and so is A - A' for all tested c <=
/// 1 (tests/unit/active_set_test.cpp). Otherwise the search gives up after 20 n + 100 exchanges.
///
/// Cost of a dense response: n^2 numbers, and O(n^3) for the first factors. The factors are kept
/// from solve to solve: a round with few exchanges costs O(n^2), and so does a solve with an
/// unchanged partition. Cost of a Toeplitz response: O(n) numbers, and O(n log n) per round, about
/// 14 transforms of 2n numbers if the partition is unchanged. Compliances may change from solve to
/// solve at no cost; with a common compliance, a prescribed rigid slip takes two solves instead of
/// one.
class ActiveSet {
 public:
  /// \param response  n x n, derivatives of the slip by the tractions
  /// \param weights   n, > 0: force = weights . p  [mm]
  /// \param solver    for its tolerance; the response matrix decides between dense and Toeplitz
  ActiveSet(LinearOperator response, Eigen::VectorXd weights, const Solver& solver = {});
  ~ActiveSet();
  ActiveSet(const ActiveSet& other);  ///< copies the factors, too, so that both give the same bits
  ActiveSet& operator=(const ActiveSet& other);
  ActiveSet(ActiveSet&&) noexcept;
  ActiveSet& operator=(ActiveSet&&) noexcept;

  /// \param state  in: n zones to start from; out: the solution. Nothing is allocated if the tried
  ///               partitions occurred in earlier solves, or differ from the factors' partition by
  ///               a few elements that differed in earlier solves, too.
  /// \throws std::invalid_argument if the force is not below full sliding, weights . bound
  /// \throws NotConverged          if a system is singular or its residual above the tolerance, or
  ///                               if the path is given up or ends before a solution
  void solve(const SlipConditions& conditions, const Prescribed& load, ContactState& state);

  /// The same from adhesion everywhere, or from the given zones.
  ContactState solve(const SlipConditions& conditions, const Prescribed& load);
  ContactState solve(const SlipConditions& conditions, const Prescribed& load,
                     const std::vector<Zone>& first);

  /// Tractions, slip and rigid slip of a given partition: elements in adhesion have no slip, others
  /// have the traction of their bound. The result may violate the slip conditions. Solutions are
  /// refined until the tolerance is reached; solve() refines its solutions further.
  /// \param zones  n
  /// \param state  out
  /// \throws NotConverged if the system is singular or its residual above the tolerance
  void solve_partition(const SlipConditions& conditions, const Prescribed& load,
                       const std::vector<Zone>& zones, ContactState& state);

  /// Estimate of the condition number, in the 1-norm, of the last partition's equations in
  /// adhesion; 1 if nothing sticks. Cost: about five solves, and new factors if the last ones are
  /// bordered.
  double condition();

  /// Writes or reads the history of the factors, so that later solves give the same bits.
  /// \throws std::invalid_argument for a history that does not fit the response
  void archive(Archive& archive);

  const LinearOperator& response() const;
  const Eigen::VectorXd& weights() const;

 private:
  std::unique_ptr<class ContactSearch> search_;
};

}  // namespace microslip
