// SPDX-License-Identifier: GPL-3.0-or-later
#include "stick_slip_point.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Nodes that stick from the first one on, for the mean to be taken.
constexpr Index fewest = 5;

/// Weights of the partitions before the one behind the point, of that one, and of the next two.
std::array<double, 4> convolution(double y) {
  const double y2 = y * y;
  const double y3 = y2 * y;
  return {-y / 2 + y2 - y3 / 2, 1 - 2.5 * y2 + 1.5 * y3, y / 2 + 2 * y2 - 1.5 * y3, (y3 - y2) / 2};
}

/// The same where adhesion has no partition before: that of the whole contact is exact for the
/// smallest loads, and the others come in with the square of the slip zone.
std::array<double, 4> convolution_at_edge(double y) {
  const double y2 = y * y;
  const double y3 = y2 * y;
  return {0, 1 - 2 * y2 + y3, 3 * y2 - 2 * y3, y3 - y2};
}

}  // namespace

Index first_stuck(const std::vector<Zone>& zones) {
  return std::find(zones.begin(), zones.end(), Zone::adhesion) - zones.begin();
}

/// The generating function of the regular square root's coefficients is (1 - z)^(-3/2)/b+(z), of
/// the singular one's (1 - z)^(-1/2)/b+(z): the first coefficients are alike, the second ones
/// differ by the first.
StickSlipPoint::StickSlipPoint(const LeadingEdgeConstants& edge)
    : second_(edge.layer[1] * std::sqrt(1 + edge.offset) /
                  (edge.layer[0] * std::sqrt(edge.offset)) -
              1) {}

StickSlipPoint::Root StickSlipPoint::root_of(const SlipConditions& conditions,
                                             const ContactState& contact, double direction) const {
  const auto below_bound = [&](Index i) {
    return std::max(0.0, conditions.bound[i] - direction * contact.traction[i]);
  };
  const double first = below_bound(stuck_);
  return {first, below_bound(stuck_ + 1) - second_ * first};
}

/// With the coefficients A of the regular square root and B of the singular one, the point is
/// -B/A elements from where the partition would have it without the singular one, and that is half
/// an element behind its natural end.
StickSlipPoint::Place StickSlipPoint::place_of(const SlipConditions& conditions,
                                               const Root& root) const {
  if (stuck_ == 0) {
    // All that sticks: the slip zone begins to take a node when its mean traction is at the bound.
    const double bound = conditions.bound[0];
    return {0, bound > 0 ? (1 - std::min(1.0, root.first / bound)) / 2 : 0};
  }
  const double beyond =
      root.regular > 0 ? std::clamp(1 - root.first / root.regular, 0.0, 1.0) : 0.0;
  if (beyond >= 0.5) return {stuck_, beyond - 0.5};
  return {stuck_ - 1, beyond + 0.5};
}

/// The response of the partition to a change of a neighbour of its end: to unit traction of the
/// slipping nodes before it, -2 and -1, and to unit slip of the first nodes in adhesion, 0 and 1.
const StickSlipPoint::Response& StickSlipPoint::response(ActiveSet& active_set, Index neighbour) {
  Response& found = responses_[static_cast<std::size_t>(neighbour + 2)];
  if (found.known) return found;
  const auto n = static_cast<Index>(zones_.size());
  const Index node = stuck_ + neighbour;
  const bool in_adhesion = neighbour >= 0;
  unit_.reference.setZero(n);
  unit_.bound.setZero(n);
  unit_.offset.setZero(n);
  double sign = 1;
  if (in_adhesion) {
    unit_.offset[node] = -1;
  } else {
    unit_.bound[node] = 1;
    sign = static_cast<double>(zones_[static_cast<std::size_t>(node)]);
  }
  active_set.solve_partition(unit_, load_, zones_, answer_);
  found.traction = sign * answer_.traction;
  found.slip = sign * answer_.slip;
  found.creepage = sign * answer_.creepage;
  if (in_adhesion) found.slip[node] = 1;
  found.known = true;
  return found;
}

/// What the neighbours nearest to the end have to change so that adhesion begins `moved` nodes
/// further on, or further back: traction where they stick instead, slip where they slip instead.
std::array<double, 2> StickSlipPoint::changes(ActiveSet& active_set,
                                              const SlipConditions& conditions,
                                              const ContactState& contact, Index moved,
                                              double direction) {
  const bool slips = moved > 0;
  const Index nearest = slips ? 0 : -1;
  const Index next = slips ? 1 : -2;
  const auto left = [&](Index neighbour) {
    const Index node = stuck_ + neighbour;
    return slips ? direction * conditions.bound[node] - contact.traction[node]
                 : -contact.slip[node];
  };
  const auto entry = [&](Index neighbour, Index by) {
    const Response& r = response(active_set, by);
    return slips ? r.traction[stuck_ + neighbour] : r.slip[stuck_ + neighbour];
  };
  if (std::abs(moved) == 1) return {left(nearest) / entry(nearest, nearest), 0};
  const double a = entry(nearest, nearest), b = entry(nearest, next);
  const double c = entry(next, nearest), d = entry(next, next);
  const double f = left(nearest), g = left(next);
  const double determinant = a * d - b * c;
  return {(f * d - b * g) / determinant, (a * g - c * f) / determinant};
}

/// If the node before the end stuck, too, its traction would be above the bound by A less the first
/// node's distance to the bound. Where it is not, because material slipped and stuck again or the
/// bound is rough, there is no square root to go by.
/// \return the part of the mean to take: 1 up to a difference of a quarter of A, 0 from three
///         quarters on
double StickSlipPoint::trust(ActiveSet& active_set, const SlipConditions& conditions,
                             const ContactState& contact, const Root& root, double direction) {
  if (root.regular <= 0) return 0;
  const double above = direction * changes(active_set, conditions, contact, -1, direction)[0];
  const double expected = root.regular - root.first;
  return std::clamp(1.5 - 2 * std::abs(above - expected) / root.regular, 0.0, 1.0);
}

void StickSlipPoint::average(ActiveSet& active_set, const SlipConditions& conditions,
                             const Load& load, ContactState& contact, VectorXd& displacement) {
  const auto n = static_cast<Index>(contact.zones.size());
  const Index stuck = first_stuck(contact.zones);
  if (stuck + fewest >= n) return;
  const auto begin = contact.zones.begin() + stuck;
  if (std::any_of(begin, begin + fewest, [](Zone z) { return z != Zone::adhesion; })) return;
  if (contact.zones != zones_ || load.index() != load_.index()) {
    zones_ = contact.zones;
    stuck_ = stuck;
    load_ = std::holds_alternative<PrescribedForce>(load) ? Load(PrescribedForce{0})
                                                          : Load(PrescribedCreepage{0});
    for (Response& r : responses_) r.known = false;
  }
  double direction = contact.traction[0] < 0 ? -1 : 1;
  if (stuck > 0) {
    direction = static_cast<double>(contact.zones[static_cast<std::size_t>(stuck) - 1]);
  }

  const Root root = root_of(conditions, contact, direction);
  const Place place = place_of(conditions, root);
  const auto weights =
      place.partition == 0 ? convolution_at_edge(place.fraction) : convolution(place.fraction);
  const double part = stuck == 0 ? 1 : trust(active_set, conditions, contact, root, direction);
  if (part == 0) return;
  std::array<double, 4> change{};
  for (Index k = 0; k < 4; ++k) {
    const double weight = weights[static_cast<std::size_t>(k)];
    const Index moved = place.partition - 1 + k - stuck;
    if (weight == 0 || moved == 0) continue;
    const auto [nearest, next] = changes(active_set, conditions, contact, moved, direction);
    change[moved > 0 ? 2 : 1] += weight * nearest;
    change[moved > 0 ? 3 : 0] += weight * next;
  }
  for (Index k = 0; k < 4; ++k) {
    const double by = part * change[static_cast<std::size_t>(k)];
    if (by == 0) continue;
    const Response& r = response(active_set, k - 2);
    contact.traction += by * r.traction;
    contact.creepage += by * r.creepage;
    displacement += by * (r.slip.array() - r.creepage).matrix();
  }
}

}  // namespace microslip
