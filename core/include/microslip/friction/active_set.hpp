// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string_view>
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

/// The load of a step as a slip displacement has it: the creepage times the length, or the force.
/// \param length  of the step  [mm]
Load load_of_step(const Load& load, double length);

/// In slip, the sign is that of the traction.
enum class Zone : signed char { slip_negative = -1, adhesion = 0, slip_positive = 1 };

/// An element on a spring: its slip is larger by the compliance times the change of its traction.
struct CompliantElement {
  Eigen::Index element;
  double compliance;  ///< >= 0, in the unit of the response

  bool operator==(const CompliantElement&) const = default;
};

class Archive;

/// Writes or reads zones of n elements.
/// \param size  n
void archive_zones(Archive& archive, std::string_view name, std::vector<Zone>& zones,
                   Eigen::Index size);

/// Writes or reads compliant elements of n.
/// \param size  n
void archive_compliant(Archive& archive, std::vector<CompliantElement>& compliant,
                       Eigen::Index size);

/// The equation of the slip at n traction coefficients p, and the bound that they keep:
/// s = w + offset + (response + springs) (p - reference) + common (F - reference force),
/// |p_i| <= bound_i. Where the bound is zero, so is p, whatever the slip.
struct SlipConditions {
  Eigen::VectorXd bound;      ///< n, >= 0  [N/mm^2]
  Eigen::VectorXd offset;     ///< n, in the unit of the slip
  Eigen::VectorXd reference;  ///< n  [N/mm^2]
  std::vector<CompliantElement> compliant = {};
  double common = 0;  ///< compliance by which the force shifts all elements alike  [slip mm/N]
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
/// The search has two phases. The first exchanges all violating elements at once, those above the
/// bound before those with the wrong direction of slip: thesis 3.1.1. From adhesion everywhere and
/// for c near 1 it takes about log2(n) rounds. For c << 1 the partitions never settle, so an
/// element may be released from adhesion only once. The second phase exchanges one element at a
/// time along an exact path. The path begins with bounds and offsets for which a partition is the
/// solution, and ends with the given ones. From a partition nearby it takes as many exchanges as
/// partitions differ by, or few more. It begins at the first partition, or, if all sticks there,
/// where the first phase has ended. If it takes more than 60 exchanges, or 20, it begins again, in
/// the end with a bound so high that all elements stick.
///
/// Termination: the first phase has at most 3 n rounds. On the path the solution is piecewise
/// linear in the fraction of the relief that is left, with one piece a partition. If response +
/// response^T is positive definite, the solution is unique, and the path meets each partition at
/// most once. A is positive definite, and so is A - A' for all c <= 1 that were tried
/// (tests/unit/active_set_test.cpp). Otherwise the search gives up after 20 n + 100 exchanges.
///
/// Cost of a dense response: n^2 numbers, and O(n^3) for the first factors. They are kept from
/// solve to solve: a round with few exchanges costs O(n^2), as does a solve whose partition stays.
/// Cost of a Toeplitz response: O(n) numbers, and O(n log n) a round, about 14 transforms of 2n
/// numbers where the partition stays. Compliances may change from solve to solve at no cost; with a
/// common one, a creepage takes two solves instead of one.
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

  /// Tractions, slip and creepage of a given partition, which may break the conditions: elements in
  /// adhesion have no slip, others the traction of their bound. Solutions are refined until the
  /// tolerance is reached, those of solve() further.
  /// \param zones  n
  /// \param state  out
  /// \throws NotConverged if the system is singular or its residual above the tolerance
  void solve_partition(const SlipConditions& conditions, const Load& load,
                       const std::vector<Zone>& zones, ContactState& state);

  /// Estimate of the condition number of the equations in adhesion of the last partition, in the
  /// 1-norm; 1 if nothing sticks. New factors where the last ones are bordered, and some five
  /// solves.
  double condition();

  /// Writes or reads the history of its factors, so that it goes on to the bit alike.
  /// \throws std::invalid_argument for one that does not fit the response
  void archive(Archive& archive);

  const SquareMatrix& response() const;
  const Eigen::VectorXd& weights() const;

 private:
  std::unique_ptr<class ContactSearch> search_;
};

}  // namespace microslip
