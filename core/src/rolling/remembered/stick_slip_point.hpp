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

/// A contact solved with one partition, replaced later by the mean over partitions; or a derivative
/// of this contact.
struct RolledContact {
  ContactState contact;
  Eigen::VectorXd displacement;  ///< response times traction, n  [mm]
};

/// The stick-slip point at the trailing end of adhesion, anywhere within an element.
///
/// A partition whose adhesion begins at node k responds to a small change of the load like a
/// contact whose adhesion begins at the partition's natural end, offset - 1/2 elements behind that
/// node. If the stick-slip point is there, the partition's solution is the tangent to the exact
/// solution. The stick-slip point follows from the tractions of the partition that meets the
/// conditions: next to the point, tractions are the Wiener-Hopf coefficients of a regular and a
/// singular square root. The mean over four partitions, by cubic convolution in the position of the
/// point between the natural ends, has the exact solution's value and slope to second order
/// (docs/theory.md).
///
/// Cost: O(n) per contact, and one solve for each of four nodes next to the stick-slip point when
/// the partition has changed.
class StickSlipPoint {
 public:
  /// \param first_length  distance from the trailing edge, which is the natural end if all nodes
  ///                      stick, to the next partition's natural end  [dx]
  StickSlipPoint(const LeadingEdgeConstants& edge, double first_length);

  /// Replaces traction, shift and displacement of a contact by the mean over partitions; zones
  /// and slip are unchanged. With fewer than five nodes in adhesion at the end, nothing is changed.
  /// \param active_set  the set that solved the contact; its response matrix contains influence
  ///                    coefficients
  /// \param rolled      the solution of the conditions, in and out
  /// \param slopes      derivatives of the solution, in and out: none or two
  /// \param reversal    for a shift without rolling, the tractions at the last reversal; in
  ///                    rolling, none [N/mm^2]
  void average(ActiveSet& active_set, const SlipConditions& conditions, const Prescribed& load,
               RolledContact& rolled, std::span<RolledContact* const> slopes = {},
               const Eigen::VectorXd* reversal = nullptr);

  /// Writes or reads the known responses.
  /// \param size  n
  void archive(Archive& archive, Eigen::Index size);

 private:
  /// The position of the point; a scalar is a number, or a number with two derivatives.
  template <class Scalar>
  struct Place {
    Eigen::Index partition;  ///< the partition whose natural end is just behind the point
    Scalar fraction;         ///< distance from that end to the point, as a fraction of the distance
                             ///< to the next end, in [0, 1]
  };

  /// Response to a change at one node next to the end: unit slip of a node in adhesion, or unit
  /// traction of a slipping node; or to a unit shift.
  struct Response {
    bool known = false;
    Eigen::VectorXd traction;
    Eigen::VectorXd slip;  ///< S + A p; n
    double rigid_slip = 0;
    double force = 0;  ///< [N/mm]

    void archive(Archive& archive, Eigen::Index size);
  };

  /// Distances to the limits at the nodes next to the end, two on each side and a third in
  /// adhesion: slip below 0, and traction below the bound.
  template <class Scalar>
  using Left = std::array<Scalar, 5>;

  /// Bounds of the first nodes of the contact  [N/mm^2]
  using Bounds = std::array<double, 3>;

  /// Distance of the traction to the bound at the first node in adhesion, and the coefficient A of
  /// the regular square root [N/mm^2]
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
  void solve_unit(ActiveSet& active_set, const Prescribed& load, double sign, Response& found);
  void add_common_shift(ActiveSet& active_set, const Response& found, Response& shifted);
  void add(RolledContact& rolled, const std::array<double, 4>& change) const;

  double second_;  ///< the second node's traction over the first's, of the singular square root
  double first_length_;  ///< [dx]

  // The partition whose responses are known.
  std::vector<Zone> zones_;
  bool by_force_ = false;  ///< whether the load is a force
  Eigen::Index stuck_ = 0;
  double direction_ = 1;  ///< sign of the traction in the slip zone next to the end
  Bounds left_before_{};  ///< distance to the bound when the slip zone began to grow  [N/mm^2]
  std::array<Response, 4> responses_;  ///< of nodes stuck_ - 2 ... stuck_ + 1

  // Under a prescribed shift a common compliance, which may differ each time, shifts the
  // responses.
  double common_ = 0;
  Response by_rigid_slip_;           ///< by a unit shift
  std::array<Response, 4> shifted_;  ///< the responses with the common compliance
  SlipConditions unit_;
  ContactState answer_;
};

/// The first node in adhesion; the number of nodes if none is in adhesion.
Eigen::Index first_stuck(const std::vector<Zone>& zones);

/// The node ahead of the last node in adhesion; 0 if none is in adhesion.
Eigen::Index past_last_stuck(const std::vector<Zone>& zones);

}  // namespace microslip
