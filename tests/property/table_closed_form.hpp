// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/kernel.hpp"

namespace microslip {

/// Steady rolling in plane strain with one stick zone [b, a] on a bound that is a table, in closed
/// form: the inversion of the finite Hilbert transform on the stick zone, which knows the bound
/// where the bodies slip, and nowhere else. It shares nothing with the solvers. With t = b - (a -
/// b) sinh(eta)^2 in the slip zone,
///   w = 2 k int g d eta,   |F| = 2 (a - b) int g (sinh(eta)^2 + 1/2) d eta.
class TableClosedForm {
 public:
  struct Solution {
    double stick_edge;
    double creepage;  ///< absolute value  [1]
  };

  TableClosedForm(const PlaneKernel& kernel, const TabulatedBound& bound)
      : k_(kernel.log_factor()),
        a_(bound.half_width()),
        t_(bound.x().array() + a_),
        g_(bound.values()) {}

  /// \param force  its absolute value, below full sliding
  /// \return none if the contact conditions do not hold: there is more than one zone of stick or
  /// slip
  std::optional<Solution> solve(double force) {
    double least = 1e-15 * a_, most = 2 * a_;
    while (most / least > 1 + 1e-15) {
      const double middle = most > 2 * least ? std::sqrt(least * most) : (least + most) / 2;
      if (middle <= least || middle >= most) break;
      place(middle);
      (this->force() < force ? least : most) = middle;
    }
    place(most);
    if (!holds()) return std::nullopt;
    return Solution{slip_ - a_, creepage()};
  }

 private:
  struct Piece {          // from its outer end to its inner one, of the bound as a line
    double from, to;      // eta
    double value, slope;  // at the outer end, over t
    double start;         // t at the outer end, from the trailing edge
  };

  double stick() const { return 2 * a_ - slip_; }

  /// Lays the stick-slip point this far from the trailing edge.
  void place(double slip) {
    slip_ = slip;
    pieces_.clear();
    const auto eta = [&](double t) { return std::asinh(std::sqrt((slip_ - t) / stick())); };
    for (Eigen::Index i = 0; i + 1 < t_.size() && t_[i] < slip_; ++i) {
      if (t_[i + 1] == t_[i]) continue;
      const double slope = (g_[i + 1] - g_[i]) / (t_[i + 1] - t_[i]);
      pieces_.push_back({eta(t_[i]), eta(std::min(t_[i + 1], slip_)), g_[i], slope, t_[i]});
    }
  }

  template <class Weight>
  double integral(const Weight& weight) const {
    double sum = 0;
    for (const Piece& piece : pieces_) {
      const auto integrand = [&](double eta) {
        const double inward = stick() * std::sinh(piece.from - eta) * std::sinh(piece.from + eta);
        return (piece.value + piece.slope * inward) * weight(eta);
      };
      sum += boost::math::quadrature::gauss<double, 30>::integrate(integrand, piece.to, piece.from);
    }
    return sum;
  }

  double creepage() const {
    return 2 * k_ * integral([](double) { return 1.0; });
  }

  double force() const {
    return 2 * stick() * integral([](double eta) { return std::pow(std::sinh(eta), 2) + 0.5; });
  }

  /// Returns the value of a piece's line, continued to a distance from the trailing edge.
  static double continued(const Piece& piece, double t) {
    return piece.value + piece.slope * (t - piece.start);
  }

  double slopes() const {
    double sum = 0;
    for (const Piece& piece : pieces_) sum += piece.slope * (piece.from - piece.to);
    return 2 * stick() * sum;
  }

  /// At x = b + (a - b) sin(phi)^2.
  double traction(double phi) const {
    const double t = slip_ + stick() * std::pow(std::sin(phi), 2);
    const auto angle = [&](double eta) { return std::atan(std::tanh(eta) / std::tan(phi)); };
    double sum = -slopes() * std::sin(phi) * std::cos(phi) / 2;
    for (const Piece& piece : pieces_) {
      sum += continued(piece, t) * (angle(piece.from) - angle(piece.to));
    }
    return 2 / std::numbers::pi * sum;
  }

  /// At x = b - (a - b) sinh(xi)^2, not where a piece ends.
  double slip(double xi) const {
    const double t = slip_ - stick() * std::pow(std::sinh(xi), 2);
    const auto log = [&](double eta) {
      return std::log(std::abs(std::sinh(eta - xi) / std::sinh(eta + xi)));
    };
    double sum = -slopes() * std::sinh(xi) * std::cosh(xi);
    for (const Piece& piece : pieces_) {
      sum += continued(piece, t) * (log(piece.from) - log(piece.to));
    }
    return -k_ * sum;
  }

  /// Tractions below the bound in adhesion and slip in the direction of the creepage, at many
  /// points.
  bool holds() const {
    constexpr int points = 2000;
    const double tolerance = 1e-9;
    const double far = pieces_.front().from;
    for (int i = 0; i < points; ++i) {
      const double part = (i + 0.5 + 1e-4 * std::numbers::pi) / points;
      const double phi = std::numbers::pi / 2 * part;
      const double t = slip_ + stick() * std::pow(std::sin(phi), 2);
      if (!(traction(phi) <= bound(t) + tolerance * g_.maxCoeff())) return false;
      if (!(slip(far * part) >= -tolerance * creepage())) return false;
    }
    return true;
  }

  double bound(double t) const {
    const auto next = std::upper_bound(t_.begin(), t_.end(), t);
    if (next == t_.end()) return g_[g_.size() - 1];
    const Eigen::Index i = std::max<Eigen::Index>(1, next - t_.begin());
    return g_[i - 1] + (g_[i] - g_[i - 1]) * (t - t_[i - 1]) / (t_[i] - t_[i - 1]);
  }

  double k_, a_;
  Eigen::VectorXd t_, g_;  // places from the trailing edge, and values
  double slip_ = 0;        // length of the slip zone
  std::vector<Piece> pieces_;
};

}  // namespace microslip
