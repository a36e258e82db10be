// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "bound_rows.hpp"
#include "microslip/support/chebyshev_series.hpp"

namespace microslip {

/// The contact in which several stick zones are searched.
struct ZonedContact {
  ZonedContact(const Kernel& kernel, const TractionBound& bound);

  Kernel kernel;
  TractionBound bound;
  BoundRows rows;
  double log_factor;  ///< k of the kernel  [mm^2/N]
  double clear;       ///< clear_distance() of the kernel  [mm]
  /// Longest panel of a quadrature. Under a smooth bound its points show the conditions between the
  /// ends of zones, too  [mm]
  double longest;
};

/// The ends of a stick zone.
struct ZoneEnds {
  RowPlace begin, end;
};

/// A place by its distance from an end of a zone or from an edge of the contact. Boundary 0 is the
/// trailing edge, 2 j + 1 and 2 j + 2 are the ends of zone j, and the last one is the leading edge.
struct BoundaryPlace {
  std::size_t boundary;
  double from;  ///< > 0 ahead of the boundary  [mm]
};

/// Steady rolling with given stick zones [b_j, c_j], j = 0 ... K - 1, under a positive creepage,
/// with tractions counted as positive: the inversion of the finite Hilbert transform on all zones
/// at once, docs/theory.md. The bound in the slip zones gives everything. The ends are right where
/// all levels are equal, each leading root is zero, and the contact carries its load.
///
/// Integrals are made on Gauss points of panels that grow away from the ends of zones and end at
/// the rows of the bound. All distances between points and ends are sums of distances with their
/// own digits, so narrow zones lose none.
class StickZones {
 public:
  /// Panels next to the ends of zones are refined so often more than the integrals need;
  /// evaluations close to these ends need it.
  static constexpr int for_places = 16;

  /// Tractions at stick_points() need so many.
  static constexpr int for_strain = 9;

  /// \param refined  0 for levels, force and roots alone
  StickZones(std::shared_ptr<const ZonedContact> contact, std::vector<ZoneEnds> zones,
             int refined = 0);

  const std::vector<ZoneEnds>& zones() const { return zones_; }
  std::size_t size() const { return zones_.size(); }
  const ZonedContact& contact() const { return *contact_; }

  /// The creepage over k that the conditions of one zone give; all are equal in a solution
  /// [N/mm^2]
  double level(std::size_t zone) const;
  double force() const;  ///< [N/mm]

  /// Whether the bodies slip ahead of a zone.
  bool slips_ahead(std::size_t zone) const;

  /// The factor of the inverse root with which the traction gradient would be singular at the
  /// leading end, over the sum of its absolute terms. Below zero, the end is too far ahead  [1]
  double leading_root(std::size_t zone) const;

  /// The zone of a place; none in slip.
  std::optional<std::size_t> zone_of(double x) const;
  BoundaryPlace place_of(double x) const;
  double position(const BoundaryPlace& place) const;
  RowPlace row_place(const BoundaryPlace& place) const;

  double bound(const BoundaryPlace& place) const;
  /// P in a stick zone  [N/mm^2]
  double traction(std::size_t zone, const BoundaryPlace& place) const;

  /// Gauss points of all stick zones or all slip zones, with weights and bounds.
  struct Points {
    std::vector<BoundaryPlace> places;
    std::vector<std::size_t> zones;  ///< the stick zone, or the number of stick zones behind
    Eigen::ArrayXd weights, bounds;  ///< [mm], [N/mm^2]
    Eigen::ArrayXd rises;            ///< bound less the bound at the boundary  [N/mm^2]
  };
  const Points& slip_points() const { return slip_; }
  Points stick_points() const;

  /// The signed distance of one place ahead of another  [mm]
  double distance(const BoundaryPlace& from, const BoundaryPlace& to) const;

  /// Adds a strain over k by other causes than plane strain, such as the smooth part of a strip's
  /// kernel.
  /// \param strain  a function over the whole contact  [N/mm^2]
  /// \param terms   number of Chebyshev points that resolve it in a zone without neighbours
  void add_strain(std::shared_ptr<const ChebyshevSeries> strain, Eigen::Index terms);
  double added_strain(double x) const { return strain_ ? (*strain_)(x) : 0; }

 private:
  struct Interval;
  Points points_of(const std::vector<Interval>& intervals, int refined) const;
  void lay(const Interval& interval, int refined, Points& points) const;
  double from_strain(std::size_t zone, const BoundaryPlace& place) const;

  std::shared_ptr<const ZonedContact> contact_;
  std::vector<ZoneEnds> zones_;
  int refined_;
  std::vector<RowPlace> boundaries_;
  Eigen::MatrixXd between_;  ///< signed distance of boundary j ahead of boundary i  [mm]
  Points slip_;
  Eigen::ArrayXd lean_;     ///< product of |t - m_j|/sqrt((t - b_j)(t - c_j)) at the slip points
  Eigen::ArrayXd inverse_;  ///< 1/R at the slip points, signed

  std::shared_ptr<const ChebyshevSeries> strain_;
  std::vector<BoundaryPlace> strain_places_;
  std::vector<double> strain_values_;
  std::vector<double> strain_weights_;  ///< signed, of the inverse of R at the Chebyshev points
};

}  // namespace microslip
