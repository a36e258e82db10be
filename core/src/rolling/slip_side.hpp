// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "microslip/friction/traction_bound.hpp"

namespace microslip {

/// v = cosh(theta) - 1, without cancellation; and the inverse, theta of v, which is 0 for v <= 0.
double versine_of(double theta);
double theta_of(double versine);

/// A bound as a function of the distance from one edge of the contact.
class SidedBound {
 public:
  enum class Edge { trailing, leading };

  SidedBound(const TractionBound& bound, Edge edge);

  /// Distance from the edge to the point where the bound begins to differ from zero  [mm]
  double begin() const { return begin_; }

  /// The polynomial with its square roots; none for a tabulated bound.
  const std::optional<ChebyshevTraction>& smooth() const { return smooth_; }

  /// Distances of the rows of a table from begin(), ascending from 0  [mm]
  const std::vector<double>& rows() const { return rows_; }
  const std::vector<double>& values() const { return values_; }  ///< at the rows  [N/mm^2]

  /// g of a smooth bound, without cancellation next to the edge  [N/mm^2]
  /// \param distance  from the edge, >= 0  [mm]
  double operator()(double distance) const;

 private:
  std::optional<ChebyshevTraction> smooth_;
  Edge edge_;
  double begin_ = 0;
  std::vector<double> rows_, values_;
};

/// The bound on one side of a stick zone, where the bodies slip, and the integrals over it that
/// invert the finite Hilbert transform on the zone. The outward distance from the end of the zone,
/// over half its length, is the versine v = cosh(theta) - 1. In terms of theta, the inversion has
/// no square root at the end of the zone. This theta is psi in docs/theory.md.
///
/// A table's pieces are integrated in closed form if the place of evaluation is near them. A smooth
/// bound has a square root at the edge of the contact: the last panel of its quadrature uses r with
/// theta = extent - length r^2. Near the place of evaluation, the bound's value at that place is
/// subtracted and integrated in closed form.
class SlipSide {
 public:
  struct Panels {     ///< of the quadrature
    double longest;   ///< longest panel, for integrands with a length scale of their own  [mm]
    double fineness;  ///< factor by which panels are shorter than necessary
  };

  /// \param bound        must outlive this object
  /// \param extent       theta where the bound begins, > 0
  /// \param half_length  of the stick zone  [mm]
  SlipSide(const SidedBound& bound, double extent, double half_length, const Panels& panels);

  // Nodes of a quadrature over theta, for what is smooth on this side and beyond its ends.
  const Eigen::ArrayXd& theta() const { return theta_; }
  const Eigen::ArrayXd& versine() const { return versine_; }
  const Eigen::ArrayXd& load() const { return load_; }  ///< weight times bound  [N/mm^2]

  /// The integral of g/(v(theta) - versine) over theta times sqrt(|versine (2 + versine)|), as a
  /// principal value  [N/mm^2]
  /// \param versine  of the place of evaluation: above 0 on this side, from -2 to 0 in the stick
  ///                 zone, below -2 on the other side
  double transform(double versine) const;

  /// The finite part of the integral of g/v over theta, of a table: the transform at the near end
  /// of the stick zone.
  double at_near_end() const;

  /// The integral of g/(2 + v) over theta: the transform at the far end of the stick zone.
  double at_far_end() const;

 private:
  struct Piece {                // of a table, a straight line
    double from, to;            // theta, from < to
    double versine, value;      // at the outer end
    double slope;               // of g over v
    Eigen::Index first, count;  // of its nodes
    double reach;               // nearest distance, in theta, of a place for which nodes are
                                // accurate
    double at(double v) const { return value + slope * (v - versine); }
  };
  struct Place;

  void lay_table(const Panels& panels);
  void lay_smooth(const Panels& panels);
  template <class Bound>
  void lay(double from, double to, int points, const Bound& bound);
  void finish();

  double transform_table(const Place& place) const;
  double transform_smooth(const Place& place) const;
  double by_nodes(Eigen::Index first, Eigen::Index count, double versine) const;

  const SidedBound* bound_;
  double extent_, half_length_;
  std::vector<double> thetas_, weights_, loads_;  ///< used until the nodes are complete
  Eigen::ArrayXd theta_, versine_, weight_, load_;
  std::vector<Piece> pieces_;
  double edge_ = 0;              ///< theta where the last panel of a smooth bound begins
  double near_ = 0;              ///< nearest distance to the end, in theta, at which nodes are
                                 ///< accurate
  Eigen::Index edge_nodes_ = 0;  ///< the first node of that panel
  Eigen::ArrayXd root_;          ///< r at the nodes of that panel
};

}  // namespace microslip
