// SPDX-License-Identifier: GPL-3.0-or-later
#include "stick_slip_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/AutoDiff>

#include "microslip/support/archive.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Least number of nodes in adhesion at the stick-slip point for which the mean over partitions is
/// taken.
constexpr Index fewest = 5;

/// A number and its two derivatives.
using Sloped = Eigen::AutoDiffScalar<Eigen::Vector2d>;

template <class Scalar>
Scalar clamped(const Scalar& x, double low, double high) {
  if (x < low) return Scalar(low);
  if (x > high) return Scalar(high);
  return x;
}

/// Weights of four consecutive partitions, the second of which has its natural end just behind the
/// stick-slip point. The weights are cubic in y, add up to 1, and make the mean of the squared
/// distances to the point 0.
/// \param y       position of the point between the two nearest natural ends, [0, 1]
/// \param before  distance from the first partition's natural end to the second's  [dx]
template <class Scalar>
std::array<Scalar, 4> convolution(const Scalar& y, double before) {
  const double e = 1 / (before + 1);
  const Scalar first = -(e / before) * y * (1 - y) * (1 - y);
  const Scalar third = y * (1 - e + (1 + 2 * e) * y - (1 + e) * y * y);
  const Scalar last = -y * y * (1 - y) / 2;
  return {first, 1 - first - third - last, third, last};
}

/// The same without a partition before the second one: the partition in which the whole contact
/// sticks is exact for the smallest loads, and the weights of the others grow with the square of
/// the slip zone.
/// \param length  from the edge of the contact to the next natural end  [dx]
template <class Scalar>
std::array<Scalar, 4> convolution_at_edge(const Scalar& y, double length) {
  const Scalar next = y * y * (2 * length + 1 - 2 * length * y);
  const Scalar last = -2 * length * length / (length + 1) * y * y * (1 - y);
  return {Scalar(0), 1 - next - last, next, last};
}

}  // namespace

Index first_stuck(const std::vector<Zone>& zones) {
  return std::find(zones.begin(), zones.end(), Zone::adhesion) - zones.begin();
}

Index past_last_stuck(const std::vector<Zone>& zones) {
  return zones.rend() - std::find(zones.rbegin(), zones.rend(), Zone::adhesion);
}

/// The coefficients of the regular square root have the generating function (1 - z)^(-3/2)/b+(z),
/// and the coefficients of the singular square root (1 - z)^(-1/2)/b+(z). The first coefficients
/// are equal; the second ones differ by the first.
StickSlipPoint::StickSlipPoint(const LeadingEdgeConstants& edge, double first_length)
    : second_(edge.second - 1), first_length_(first_length) {}

/// Returns the distance from the bound, or from slip. Bounds are 0 for a derivative.
double StickSlipPoint::left(const SlipConditions* conditions, const ContactState& contact,
                            Index neighbour) const {
  const Index node = stuck_ + neighbour;
  if (node < 0) return 0;
  if (neighbour < 0) return -contact.slip[node];
  return (conditions == nullptr ? 0 : conditions->bound[node]) -
         direction_ * contact.traction[node];
}

template <class Scalar>
StickSlipPoint::Root<Scalar> StickSlipPoint::root_of(const Scalar& left, const Scalar& next) const {
  constexpr double any = std::numeric_limits<double>::infinity();
  const Scalar first = clamped(left, 0, any);
  return {first, clamped(next, 0, any) - second_ * first};
}

/// Returns the stick-slip point, as its distance from the partition's natural end in elements,
/// [-1/2, 1/2]. With the coefficients A of the regular square root and B of the singular square
/// root, the point is -B/A elements from its position at B = 0, which is half an element behind the
/// natural end.
template <class Scalar>
Scalar StickSlipPoint::beyond(const Root<Scalar>& root) {
  if (root.regular <= 0) return Scalar(-0.5);
  return clamped<Scalar>(1 - root.first / root.regular, 0, 1) - 0.5;
}

/// If all nodes stick, the slip zone grows with the change of the load, and reaches the first node
/// when the node's mean traction is at the bound. The point is then at its position in the next
/// partition, whose tractions are the same.
template <class Scalar>
StickSlipPoint::Place<Scalar> StickSlipPoint::place_of(const Left<Scalar>& left,
                                                       const Bounds& bound) const {
  if (stuck_ > 0) {
    const Scalar behind = beyond(root_of(left[2], left[3]));
    if (behind >= 0) return {stuck_, behind};
    if (stuck_ > 1) return {stuck_ - 1, 1 + behind};
    return {0, 1 + behind / first_length_};
  }
  if (bound[0] <= 0 || left_before_[0] <= 0) return {0, Scalar(0)};
  const Scalar load = clamped<Scalar>(1 - left[2] / left_before_[0], 0, 1);
  if (load <= 0) return {0, Scalar(0)};
  const auto at_the_bound = [&](std::size_t node) {
    return left_before_[node] - (left_before_[node] - left[2 + node]) / load;
  };
  const Scalar behind = beyond(root_of<Scalar>(at_the_bound(1), at_the_bound(2)));
  return {0, load * (1 + clamped<Scalar>(behind, -0.5, 0) / first_length_)};
}

/// The response of the partition to a change at a node next to its end: to unit traction of the
/// slipping nodes -2 and -1 behind the end, and to unit slip of the first nodes in adhesion, 0 and
/// 1.
const StickSlipPoint::Response& StickSlipPoint::response(ActiveSet& active_set, Index neighbour) {
  const auto k = static_cast<std::size_t>(neighbour + 2);
  Response& found = responses_[k];
  if (!found.known) {
    clear_unit();
    const Index node = stuck_ + neighbour;
    double sign = 1;
    if (neighbour >= 0) {
      unit_.offset[node] = -1;
    } else {
      unit_.bound[node] = 1;
      sign = static_cast<double>(zones_[static_cast<std::size_t>(node)]);
    }
    const Prescribed none =
        by_force_ ? Prescribed(PrescribedForce{0}) : Prescribed(PrescribedShift{0});
    solve_unit(active_set, none, sign, found);
    if (neighbour >= 0) found.slip[node] = 1;
  }
  if (common_ == 0) return found;
  if (!shifted_[k].known) add_common_shift(active_set, found, shifted_[k]);
  return shifted_[k];
}

void StickSlipPoint::clear_unit() {
  const auto n = static_cast<Index>(zones_.size());
  for (VectorXd* of : {&unit_.bound, &unit_.offset, &unit_.reference}) of->setZero(n);
}

/// \param sign  sign of the response
void StickSlipPoint::solve_unit(ActiveSet& active_set, const Prescribed& load, double sign,
                                Response& found) {
  active_set.solve_partition(unit_, load, zones_, answer_);
  found.traction = sign * answer_.traction;
  found.slip = sign * answer_.slip;
  found.rigid_slip = sign * answer_.rigid_slip;
  found.force = active_set.weights().dot(found.traction);
  found.known = true;
}

/// The force of a response shifts all elements, and this shift changes the force.
void StickSlipPoint::add_common_shift(ActiveSet& active_set, const Response& found,
                                      Response& shifted) {
  if (!by_rigid_slip_.known) {
    clear_unit();
    solve_unit(active_set, PrescribedShift{1}, 1, by_rigid_slip_);
  }
  const double shift = common_ * found.force / (1 - common_ * by_rigid_slip_.force);
  shifted.traction = found.traction + shift * by_rigid_slip_.traction;
  shifted.slip = found.slip + shift * by_rigid_slip_.slip;
  shifted.rigid_slip = 0;
  shifted.known = true;
}

/// The changes at the nodes next to the end, nearest ones first, with which adhesion begins `moved`
/// nodes further on, or further back. The change is a traction at nodes that then stick, and a slip
/// at nodes that then slip.
template <class Scalar>
std::array<Scalar, 2> StickSlipPoint::changes(ActiveSet& active_set, const Left<Scalar>& left,
                                              Index moved) {
  const bool slips = moved > 0;
  const Index nearest = slips ? 0 : -1;
  const Index next = slips ? 1 : -2;
  const auto left_at = [&](Index neighbour) -> Scalar {
    return (slips ? direction_ : 1.0) * left[static_cast<std::size_t>(neighbour + 2)];
  };
  const auto entry = [&](Index neighbour, Index by) {
    const Response& r = response(active_set, by);
    return slips ? r.traction[stuck_ + neighbour] : r.slip[stuck_ + neighbour];
  };
  if (std::abs(moved) == 1) return {left_at(nearest) / entry(nearest, nearest), Scalar(0)};
  const double a = entry(nearest, nearest), b = entry(nearest, next);
  const double c = entry(next, nearest), d = entry(next, next);
  const Scalar f = left_at(nearest), g = left_at(next);
  const double determinant = a * d - b * c;
  return {(f * d - b * g) / determinant, (a * g - c * f) / determinant};
}

/// If the node behind the end stuck, too, its traction would exceed the bound by A minus the first
/// node's distance to the bound. If it does not, because material slipped and stuck again or
/// because the bound is rough, there is no square root from which the point could be found.
/// \return the fraction of the mean to take: 1 up to a difference of a quarter of A, 0 from three
///         quarters on
template <class Scalar>
Scalar StickSlipPoint::trust(ActiveSet& active_set, const Left<Scalar>& left) {
  if (stuck_ == 0) return Scalar(1);
  const Root<Scalar> root = root_of(left[2], left[3]);
  if (root.regular <= 0) return Scalar(0);
  const Scalar above = direction_ * changes(active_set, left, -1)[0];
  const Scalar expected = root.regular - root.first;
  Scalar difference = above - expected;
  if (difference < 0) difference = -difference;
  return clamped<Scalar>(1.5 - 2 * difference / root.regular, 0, 1);
}

/// The changes at the nodes next to the end that lead from the partition to the mean.
/// \param bound  bound at the first nodes of the contact
template <class Scalar>
std::array<Scalar, 4> StickSlipPoint::change(ActiveSet& active_set, const Left<Scalar>& left,
                                             const Bounds& bound) {
  std::array<Scalar, 4> sum{Scalar(0), Scalar(0), Scalar(0), Scalar(0)};
  const Scalar part = trust(active_set, left);
  if (part == 0) return sum;
  const Place<Scalar> place = place_of(left, bound);
  const auto weights = place.partition == 0
                           ? convolution_at_edge(place.fraction, first_length_)
                           : convolution(place.fraction, place.partition == 1 ? first_length_ : 1);
  for (Index k = 0; k < 4; ++k) {
    const Index moved = place.partition - 1 + k - stuck_;
    if (moved == 0 || stuck_ + moved < 0) continue;
    const Scalar weight = part * weights[static_cast<std::size_t>(k)];
    const auto [nearest, next] = changes(active_set, left, moved);
    sum[moved > 0 ? 2 : 1] += weight * nearest;
    sum[moved > 0 ? 3 : 0] += weight * next;
  }
  return sum;
}

void StickSlipPoint::add(RolledContact& rolled, const std::array<double, 4>& change) const {
  for (std::size_t k = 0; k < 4; ++k) {
    const double by = change[k];
    if (by == 0) continue;
    const Response& r = common_ == 0 ? responses_[k] : shifted_[k];
    rolled.contact.traction += by * r.traction;
    rolled.contact.rigid_slip += by * r.rigid_slip;
    rolled.displacement += by * (r.slip.array() - r.rigid_slip).matrix();
  }
}

void StickSlipPoint::average(ActiveSet& active_set, const SlipConditions& conditions,
                             const Prescribed& load, RolledContact& rolled,
                             std::span<RolledContact* const> slopes, const VectorXd* reversal) {
  const ContactState& contact = rolled.contact;
  const auto n = static_cast<Index>(contact.zones.size());
  const Index stuck = first_stuck(contact.zones);
  if (stuck + fewest >= n) return;
  const auto begin = contact.zones.begin() + stuck;
  if (std::any_of(begin, begin + fewest, [](Zone z) { return z != Zone::adhesion; })) return;
  if (contact.zones != zones_ || load.by_force != by_force_) {
    zones_ = contact.zones;
    stuck_ = stuck;
    by_force_ = load.by_force;
    unit_.compliant = conditions.compliant;
    for (Response& r : responses_) r.known = false;
    for (Response& r : shifted_) r.known = false;
    by_rigid_slip_.known = false;
  }
  const double common = by_force_ ? 0 : conditions.common;
  if (common != common_) {
    for (Response& r : shifted_) r.known = false;
    common_ = common;
  }
  direction_ = contact.traction[0] < 0 ? -1 : 1;
  if (stuck > 0) {
    direction_ = static_cast<double>(contact.zones[static_cast<std::size_t>(stuck) - 1]);
  }

  const Bounds bound{conditions.bound[0], conditions.bound[1], conditions.bound[2]};
  left_before_ = bound;
  if (stuck == 0 && reversal != nullptr) {
    direction_ = contact.rigid_slip > 0 ? -1 : 1;
    for (Index i = 0; i < 3; ++i) {
      left_before_[static_cast<std::size_t>(i)] -= direction_ * (*reversal)[i];
    }
  }
  Left<double> left_now;
  for (Index k = 0; k < 5; ++k) {
    left_now[static_cast<std::size_t>(k)] = left(&conditions, contact, k - 2);
  }
  if (slopes.empty()) {
    add(rolled, change(active_set, left_now, bound));
    return;
  }
  Left<Sloped> sloped;
  for (Index k = 0; k < 5; ++k) {
    const auto at = static_cast<std::size_t>(k);
    sloped[at] = Sloped(left_now[at], {left(nullptr, slopes[0]->contact, k - 2),
                                       left(nullptr, slopes[1]->contact, k - 2)});
  }
  const std::array<Sloped, 4> sum = change(active_set, sloped, bound);
  add(rolled, {sum[0].value(), sum[1].value(), sum[2].value(), sum[3].value()});
  for (Index i = 0; i < 2; ++i) {
    const auto of = [&](std::size_t k) { return sum[k].derivatives()[i]; };
    add(*slopes[static_cast<std::size_t>(i)], {of(0), of(1), of(2), of(3)});
  }
}

void StickSlipPoint::Response::archive(Archive& archive, Index size) {
  archive.flag("response_is_known", known);
  if (!known) return;
  archive.numbers("response_traction", traction, size);
  archive.numbers("response_slip", slip, size);
  archive.number("response_creepage", rigid_slip);
  archive.number("response_force", force);
}

/// With a common compliance, shifted responses are computed again from the known responses.
void StickSlipPoint::archive(Archive& archive, Index size) {
  bool has_partition = !zones_.empty();
  archive.flag("has_partition", has_partition);
  if (!has_partition) return;
  archive_zones(archive, "partition", zones_, size);
  archive.flag("partition_by_force", by_force_);
  archive.number("common", common_);
  for (Response& response : responses_) response.archive(archive, size);
  by_rigid_slip_.archive(archive, size);
  archive_compliant(archive, unit_.compliant, size);
  if (!archive.reads()) return;
  stuck_ = first_stuck(zones_);
}

}  // namespace microslip
