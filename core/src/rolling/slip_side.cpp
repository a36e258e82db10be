// SPDX-License-Identifier: GPL-3.0-or-later
#include "slip_side.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/support/gauss_points.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::ArrayXd;
using Eigen::Index;

double versine_of(double theta) {
  const double root = std::sinh(theta / 2);
  return 2 * root * root;
}

double theta_of(double versine) { return 2 * std::asinh(std::sqrt(std::max(0.0, versine) / 2)); }

namespace {

using Edge = SidedBound::Edge;

/// for_gauss_points with one of the numbers of points that are used here.
template <class Take>
void lay_points(int points, double begin, double end, const Take& take) {
  switch (points) {
    case 2:
      return for_gauss_points<2>(begin, end, take);
    case 3:
      return for_gauss_points<3>(begin, end, take);
    case 5:
      return for_gauss_points<5>(begin, end, take);
    case 8:
      return for_gauss_points<8>(begin, end, take);
    default:
      return for_gauss_points<16>(begin, end, take);
  }
}

/// A panel of a table. The singularities of the integrands at +-i pi limit its length.
struct Panel {
  double length;  ///< upper limit of the length
  int points;
  double reach;  ///< distance of a pole at which the error is 1e-14, over half the length
};
constexpr Panel kinds[] = {{0.002, 2, 3200}, {0.05, 3, 215}, {0.3, 5, 25}, {1, 8, 8}};

constexpr int smooth_points = 16;

}  // namespace

SidedBound::SidedBound(const TractionBound& bound, Edge edge)
    : smooth_(chebyshev_traction(bound)), edge_(edge) {
  if (smooth_) return;
  const auto& table = std::get<TabulatedBound>(bound);
  const double a = table.half_width();
  const Index n = table.x().size();
  for (Index i = 0; i < n; ++i) {
    const Index row = edge == Edge::trailing ? i : n - 1 - i;
    const double distance = edge == Edge::trailing ? table.x()[row] + a : a - table.x()[row];
    const double value = table.values()[row];
    if (!rows_.empty() && distance <= rows_.back()) {
      values_.back() = value;  // the edge and a row coincide
      continue;
    }
    // Zeros in front of the point where the bound begins are dropped.
    if (rows_.size() == 1 && value == 0 && values_[0] == 0) rows_.clear(), values_.clear();
    rows_.push_back(distance);
    values_.push_back(value);
  }
  begin_ = rows_.front();
  for (double& row : rows_) row -= begin_;
}

double SidedBound::operator()(double distance) const {
  const double a = smooth_->half_length();
  const double x = edge_ == Edge::trailing ? distance - a : a - distance;
  return std::sqrt(std::max(0.0, distance * (2 * a - distance))) / a * smooth_->polynomial(x);
}

SlipSide::SlipSide(const SidedBound& bound, double extent, double half_length, const Panels& panels)
    : bound_(&bound), extent_(extent), half_length_(half_length) {
  if (bound.smooth()) {
    lay_smooth(panels);
  } else {
    lay_table(panels);
  }
  finish();
}

/// Adds the nodes of a panel.
template <class Bound>
void SlipSide::lay(double from, double to, int points, const Bound& bound) {
  lay_points(points, from, to, [&](double theta, double weight) {
    thetas_.push_back(theta);
    weights_.push_back(weight);
    loads_.push_back(weight * bound(theta));
  });
}

void SlipSide::finish() {
  const auto size = static_cast<Index>(thetas_.size());
  theta_ = Eigen::Map<const ArrayXd>(thetas_.data(), size);
  weight_ = Eigen::Map<const ArrayXd>(weights_.data(), size);
  load_ = Eigen::Map<const ArrayXd>(loads_.data(), size);
  versine_ = theta_.unaryExpr(&versine_of);
  count_work(kernel_work * static_cast<double>(size));
}

void SlipSide::lay_table(const Panels& panels) {
  const double end = versine_of(extent_);
  const auto versine_at = [&](double distance) { return end - distance / half_length_; };
  const std::vector<double>& rows = bound_->rows();
  const std::vector<double>& values = bound_->values();
  double to = extent_;
  for (std::size_t i = 0; i + 1 < rows.size() && to > 0; ++i) {
    const double outer = versine_at(rows[i]);
    const double inner = versine_at(rows[i + 1]);
    const double from = theta_of(inner);
    const double slope = (values[i + 1] - values[i]) / (inner - outer);
    const double arc = half_length_ * std::sinh(to);
    const double needed =
        std::max((to - from) / kinds[3].length, (to - from) * arc / panels.longest * 2);
    const double parts = std::max(1.0, std::ceil(panels.fineness * needed));
    const double width = (to - from) / parts;
    const Panel& panel =
        *std::find_if(std::begin(kinds), std::end(kinds) - 1,
                      [&](const Panel& with) { return panels.fineness * width <= with.length; });
    Piece piece{from,  to,
                outer, values[i],
                slope, static_cast<Index>(thetas_.size()),
                0,     panel.reach * width / 2};
    for (int k = 0; k < static_cast<int>(parts); ++k) {
      lay(from + k * width, from + (k + 1) * width, panel.points,
          [&](double theta) { return piece.at(versine_of(theta)); });
    }
    piece.count = static_cast<Index>(thetas_.size()) - piece.first;
    pieces_.push_back(piece);
    to = from;
  }
}

void SlipSide::lay_smooth(const Panels& panels) {
  const double degree = static_cast<double>(bound_->smooth()->coefficients().size());
  const double arc = half_length_ * std::sinh(extent_);
  const double most = std::min({1.0, 12 / degree, panels.longest / arc}) / panels.fineness;
  const double last = std::min(most / 2, extent_ / 2);
  edge_ = extent_ - last;
  const double parts = std::ceil(edge_ / most);
  near_ = edge_ / parts;
  const auto g = [&](double theta) {
    const double from_edge =
        2 * std::sinh((extent_ + theta) / 2) * std::sinh((extent_ - theta) / 2);
    return (*bound_)(half_length_ * from_edge);
  };
  for (int k = 0; k < static_cast<int>(parts); ++k) {
    lay(k * near_, (k + 1) * near_, smooth_points, g);
  }
  edge_nodes_ = static_cast<Index>(thetas_.size());
  std::vector<double> roots;
  for_gauss_points<smooth_points>(0, 1, [&](double root, double weight) {
    const double theta = extent_ - last * root * root;
    roots.push_back(root);
    thetas_.push_back(theta);
    weights_.push_back(2 * last * root * weight);
    const double from_edge = std::sinh((extent_ + theta) / 2) * std::sinh(last * root * root / 2);
    loads_.push_back(weights_.back() * (*bound_)(2 * half_length_ * from_edge));
  });
  root_ = Eigen::Map<const ArrayXd>(roots.data(), static_cast<Index>(roots.size()));
}

/// The place at which a transform is evaluated.
struct SlipSide::Place {
  double versine;
  bool slips;   ///< on this side
  bool sticks;  ///< or on the other side
  /// Theta of the place's own side; in the stick zone, the angle from the end of the zone.
  double angle;
  double tangent;  ///< of half the angle; for theta, hyperbolic

  explicit Place(double v)
      : versine(v),
        slips(v > 0),
        sticks(v <= 0 && v >= -2),
        angle(slips    ? theta_of(v)
              : sticks ? 2 * std::asin(std::min(1.0, std::sqrt(-v / 2)))
                       : theta_of(-2 - v)),
        tangent(sticks ? std::tan(angle / 2) : std::tanh(angle / 2)) {}

  double root() const { return std::sqrt(std::abs(versine * (2 + versine))); }

  /// The integral of root()/(v - versine) from 0 to theta.
  double integral_to(double theta) const {
    constexpr double next_to_one = 1 - 1e-16;
    const double t = std::tanh(theta / 2);
    if (sticks) return 2 * std::atan2(t, tangent);
    if (!slips) return 2 * std::atanh(std::min(t * tangent, next_to_one));
    const double ratio = t < tangent ? t / tangent : tangent / t;
    return -2 * std::atanh(std::min(ratio, next_to_one));
  }

  /// Distance in the plane of theta from a piece of its axis.
  double distance(double from, double to) const {
    if (slips) return std::max({0.0, from - angle, angle - to});
    return sticks ? std::hypot(from, angle) : std::hypot(from, std::numbers::pi);
  }
};

double SlipSide::transform(double versine) const {
  const Place place(versine);
  return bound_->smooth() ? transform_smooth(place) : transform_table(place);
}

double SlipSide::by_nodes(Index first, Index count, double versine) const {
  count_work(3 * static_cast<double>(count));
  return (load_.segment(first, count) / (versine_.segment(first, count) - versine)).sum();
}

double SlipSide::transform_table(const Place& place) const {
  double integral = 0;  // the integral times root
  double sum = 0;
  for (const Piece& piece : pieces_) {
    if (place.distance(piece.from, piece.to) > piece.reach) {
      for (Index i = piece.first; i < piece.first + piece.count; ++i) {
        sum += load_[i] / (versine_[i] - place.versine);
      }
      continue;
    }
    count_work(2 * kernel_work);
    sum += piece.slope * (piece.to - piece.from);
    integral +=
        piece.at(place.versine) * (place.integral_to(piece.to) - place.integral_to(piece.from));
  }
  count_work(3 * static_cast<double>(load_.size()));
  return integral + place.root() * sum;
}

double SlipSide::transform_smooth(const Place& place) const {
  const double v = place.versine;
  const Index last = theta_.size() - edge_nodes_;
  // A divided difference over a tiny distance has no digits; the mean over two places has enough.
  constexpr double too_near = 1e-6;
  if (place.slips && (versine_ / v - 1).abs().minCoeff() < too_near) {
    return (transform_smooth(Place(v * (1 + 3 * too_near))) +
            transform_smooth(Place(v * (1 - 3 * too_near)))) /
           2;
  }
  const bool near = place.slips || (place.sticks && place.angle < near_);
  if (!near) return place.root() * by_nodes(0, theta_.size(), v);
  count_work(6 * static_cast<double>(edge_nodes_));
  const double g = (*bound_)(half_length_ * (versine_of(extent_) - v));
  double sum =
      ((load_.head(edge_nodes_) - g * weight_.head(edge_nodes_)) / (versine_.head(edge_nodes_) - v))
          .sum();
  const double integral = g * place.integral_to(edge_);
  const double length = extent_ - edge_;
  const double root = std::sqrt(std::max(0.0, (extent_ - place.angle) / length));
  if (!place.slips || root > 2) {
    return integral + place.root() * (sum + by_nodes(edge_nodes_, last, v));
  }
  // The integrand is even in r, and so is its difference to the integrand at the place. v - v(x) is
  // computed as a product, so that no digits cancel where v is close to v(x).
  double last_sum = 0;
  for (Index i = 0; i < last; ++i) {
    const Index node = edge_nodes_ + i;
    const double squares = root * root - root_[i] * root_[i];
    const double half = length * squares / 2;
    const double ratio = std::abs(half) < 1e-4 ? 1 - half * half / 6 : half / std::sinh(half);
    const double scaled = place.root() / std::sinh((theta_[node] + place.angle) / 2) * ratio;
    const double weight = weight_[node] / (length * root_[i]);
    const double value = load_[node] / weight_[node] * root_[i];
    last_sum += weight * (scaled * value - g * root) / squares;
  }
  count_work(2 * kernel_work * static_cast<double>(last));
  return integral + place.root() * sum + last_sum + g * std::log(std::abs((1 + root) / (1 - root)));
}

double SlipSide::at_near_end() const {
  const auto coth = [](double theta) { return 1 / std::tanh(theta / 2); };
  double sum = 0;
  for (const Piece& piece : pieces_) {
    const double inner = piece.from > 0 ? coth(piece.from) : 0;
    sum += piece.at(0) * (inner - coth(piece.to)) + piece.slope * (piece.to - piece.from);
  }
  return sum;
}

double SlipSide::at_far_end() const { return by_nodes(0, theta_.size(), -2); }

}  // namespace microslip
