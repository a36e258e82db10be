// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "microslip/friction/active_set.hpp"
#include "microslip/halfspace/leading_edge.hpp"

namespace microslip {

class Archive;

/// A contact as a partition has it, and then as the mean over partitions has it; or its derivative.
struct RolledContact {
  ContactState contact;
  Eigen::VectorXd displacement;  ///< response times traction, n  [mm]
};

/// The stick-slip point at the trailing end of adhesion, anywhere within an element.
///
/// A partition whose adhesion begins at node k answers to a small change of the load as a contact
/// whose adhesion begins at its natural end, offset - 1/2 elements behind that node. Its solution
/// is the tangent to the exact one, where the stick-slip point is there. The stick-slip point
/// follows from the tractions of the partition that meets the conditions: next to it they are
/// coefficients of Wiener and Hopf's, of the regular square root and of the singular one. The mean
/// over four partitions, by cubic convolution in the place of the point between the natural ends,
/// has the exact solution's value and slope to second order (docs/theory.md).
///
/// Cost: O(n) a contact, and a solve for each of four neighbours of the stick-slip point when the
/// partition has changed.
class StickSlipPoint {
 public:
  /// \param first_length  from the trailing edge, which is the natural end where all sticks, to
  ///                      that of the next partition  [dx]
  StickSlipPoint(const LeadingEdgeConstants& edge, double first_length);

  /// Replaces traction, creepage and displacement of a contact by those of the mean; zones and slip
  /// stay. Without five nodes in adhesion at the end, all stays.
  /// \param active_set  that solved the contact, whose response is influence
  /// \param rolled      the solution of the conditions, in and out
  /// \param slopes      its derivatives, in and out: none or two
  /// \param reversal    of a shift without rolling, the tractions since which it has gone one way;
  ///                    in rolling, none [N/mm^2]
  void average(ActiveSet& active_set, const SlipConditions& conditions, const Load& load,
               RolledContact& rolled, std::span<RolledContact* const> slopes = {},
               const Eigen::VectorXd* reversal = nullptr);

  /// Writes or reads the responses that are known.
  /// \param size  n
  void archive(Archive& archive, Eigen::Index size);

 private:
  /// The place of the point; a scalar is a number, or a number with two derivatives.
  template <class Scalar>
  struct Place {
    Eigen::Index partition;  ///< whose natural end is behind the point
    Scalar fraction;         ///< of an element from there, in [0, 1]
  };

  /// A change of one neighbour of the end: unit slip of one in adhesion, unit traction of another;
  /// or of the creepage, by 1.
  struct Response {
    bool known = false;
    Eigen::VectorXd traction;
    Eigen::VectorXd slip;  ///< W + A p; n
    double creepage = 0;
    double force = 0;  ///< [N/mm]

    void archive(Archive& archive, Eigen::Index size);
  };

  /// What is left at the neighbours of the end, two before it and three behind: by how much slip is
  /// below 0, and traction below the bound.
  template <class Scalar>
  using Left = std::array<Scalar, 5>;

  /// Of the first nodes of the contact  [N/mm^2]
  using Bounds = std::array<double, 3>;

  /// Traction below the bound at the first node of those in adhesion, and the coefficient A of the
  /// regular square root [N/mm^2]
  template <class Scalar>
  struct Root {
    Scalar first;
    Scalar regular;
  };

  double left(const SlipConditions* conditions, const ContactState& contact,
              Eigen::Index neighbour) const;
  template <class Scalar>
  Root<Scalar> root_of(const Scalar& left, const Scalar& next) const;
  template <class Scalar>
  static Scalar beyond(const Root<Scalar>& root);
  template <class Scalar>
  Place<Scalar> place_of(const Left<Scalar>& left, const Bounds& bound) const;
  template <class Scalar>
  std::array<Scalar, 2> changes(ActiveSet& active_set, const Left<Scalar>& left,
                                Eigen::Index moved);
  template <class Scalar>
  Scalar trust(ActiveSet& active_set, const Left<Scalar>& left);
  template <class Scalar>
  std::array<Scalar, 4> change(ActiveSet& active_set, const Left<Scalar>& left,
                               const Bounds& bound);
  const Response& response(ActiveSet& active_set, Eigen::Index neighbour);
  void clear_unit();
  void solve_unit(ActiveSet& active_set, const Load& load, double sign, Response& found);
  void add_common_shift(ActiveSet& active_set, const Response& found, Response& shifted);
  void add(RolledContact& rolled, const std::array<double, 4>& change) const;

  double second_;  ///< the second node's traction over the first's, of the singular square root
  double first_length_;  ///< [dx]

  // Of the partition whose responses are known.
  std::vector<Zone> zones_;
  Load load_;  ///< none, of the kind of the load
  Eigen::Index stuck_ = 0;
  double direction_ = 1;  ///< of the traction that slips before the end
  Bounds left_before_{};  ///< below the bound where the slip zone began to grow  [N/mm^2]
  std::array<Response, 4> responses_;  ///< of nodes stuck_ - 2 ... stuck_ + 1

  // Under a creepage a common compliance shifts them, which may be another each time.
  double common_ = 0;
  Response by_creepage_;             ///< by a unit creepage
  std::array<Response, 4> shifted_;  ///< the responses with the common compliance
  SlipConditions unit_;
  ContactState answer_;
};

/// The first node in adhesion; their number if there is none.
Eigen::Index first_stuck(const std::vector<Zone>& zones);

/// The node ahead of the last in adhesion; 0 if there is none.
Eigen::Index past_last_stuck(const std::vector<Zone>& zones);

}  // namespace microslip
