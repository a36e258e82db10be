// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "microslip/friction/active_set.hpp"

namespace microslip {

/// Zones of a contact from -1 to 1, from the trailing edge on. Stick and slip zones alternate.
struct ZonePattern {
  std::vector<Zone> zones;
  std::vector<double> widths;  ///< > 0, their sum is 2

  std::size_t size() const { return zones.size(); }
  bool sticks(std::size_t zone) const { return zones[zone] == Zone::adhesion; }
};

/// A place, by its distances from the ends of its zone. So the distances from the ends of all zones
/// are sums of positive numbers, and exact in the narrowest zones.
struct ZonePlace {
  std::size_t zone;
  double behind;  ///< from the trailing end of the zone
  double ahead;   ///< from the leading end
};

/// Steady rolling of bodies of different material in plane strain under Hertz's bound, with given
/// zones of stick and of slip in both directions: the inversion of the finite Hilbert transform on
/// the stick zones, docs/theory.md. Lengths are over the half-width, tractions over the peak of the
/// bound, slip and creepage over the combined compliance times that peak.
///
/// The bound on the slip zones and the pressure cause the tractions on the stick zones. Where the
/// residuals are zero, tractions are continuous, and leave the bound with the power 3/2 at the
/// leading ends of stick zones.
class UnlikeZones {
 public:
  /// \param ratio  beta/mu
  /// \param level  creepage minus 2/pi of the ratio, the creepage of free rolling without slip
  UnlikeZones(double ratio, ZonePattern pattern, double level);

  const ZonePattern& pattern() const { return pattern_; }
  double ratio() const { return ratio_; }
  double level() const { return level_; }
  double creepage() const;
  double force() const;

  /// Returns the residuals that the right widths and level make zero, each relative to its terms.
  /// \param force  prescribed; none if the level is
  Eigen::VectorXd residuals(std::optional<double> force) const;

  ZonePlace place_of(double x) const;
  double x_of(const ZonePlace& place) const;
  double bound(const ZonePlace& place) const;
  double traction(const ZonePlace& place) const;
  double slip(const ZonePlace& place) const;

 private:
  /// A slip zone as a source of strain: at Gauss points of the angle, in which the zone is
  /// the diameter of a half circle.
  struct Source {
    std::size_t zone = 0;
    Eigen::ArrayXd weights, behind, ahead, x;
    Eigen::ArrayXd density;           ///< traction over the root of distances from the stick ends
    double half = 0;                  ///< of its width
    double at_begin = 0, at_end = 0;  ///< the density at its ends
  };

  /// A sum of terms, by sign.
  struct Sum {
    double up = 0, down = 0;
    void add(double term) { (term > 0 ? up : down) += std::abs(term); }
    double total() const { return up - down; }
  };

  bool is_singular() const { return pattern_.sticks(0); }
  Eigen::Index moments() const;
  double between(std::size_t from, std::size_t to) const;
  double distance(const ZonePlace& place, std::size_t boundary) const;
  bool is_stick_end(std::size_t boundary) const;
  double sign_of_root(std::size_t zone) const;
  double root(const ZonePlace& place, bool own_ends) const;
  double logarithm(const ZonePlace& place) const;
  double density(const ZonePlace& place) const;
  double density_slope(const ZonePlace& place) const;
  Source source_of(std::size_t zone) const;
  void add_cauchy(const Source& source, const ZonePlace& place, Sum& sum) const;
  Sum cauchy(const ZonePlace& place) const;
  double moment(Eigen::Index power) const;
  double leading_condition(std::size_t boundary) const;

  double ratio_;
  ZonePattern pattern_;
  double level_;
  std::vector<Source> sources_;
};

/// Gauss points and weights of the angle in (0, pi), graded towards its ends.
/// \param from, to  how often intervals are halved towards 0, and towards pi
/// \param points    of each interval, 10 or 15
void graded_angles(int from, int to, unsigned points, Eigen::ArrayXd& angles,
                   Eigen::ArrayXd& weights);

}  // namespace microslip
