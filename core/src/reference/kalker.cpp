// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/kalker.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "microslip/linalg/lu_factors.hpp"
#include "microslip/support/gauss_points.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

// The point at the angle theta on the edge is (a cos, b sin). A chord is parallel to the tangent
// there; a b = 1, G = 1.

/// The displacement by unit tractions along and across, over the integral along a chord.
struct ChordCompliance {
  double along, across, mixed;
};

ChordCompliance compliance_of_chord(double a, double nu, double theta) {
  const double x = a * std::sin(theta), y = std::cos(theta) / a, length2 = x * x + y * y;
  const double scale = 1 / std::sqrt(length2);
  return {scale * (1 - nu * y * y / length2), scale * (1 - nu * x * x / length2),
          -scale * nu * x * y / length2};
}

/// The Fourier coefficients of the compliance, of even frequencies: means of the parts along and
/// across times cos(m theta), and of the mixed part times sin(m theta).
class CompliancesOfChords {
 public:
  CompliancesOfChords(double a, double nu, Index most)
      : along_(VectorXd::Zero(most / 2 + 1)), across_(along_), mixed_(along_) {
    // The compliance is analytic up to this distance from real angles, so that equal weights have
    // an exponential accuracy. A quarter of the edge has all values.
    const double width = std::atanh(std::min({a * a, 1 / (a * a), 0.99}));
    const Index points = most / 2 + static_cast<Index>(10 / width) + 1;
    for (Index k = 0; k < points; ++k) {
      const double theta = (static_cast<double>(k) + 0.5) * pi / static_cast<double>(2 * points);
      const ChordCompliance chord = compliance_of_chord(a, nu, theta);
      for (Index i = 0; i < along_.size(); ++i) {
        const double angle = static_cast<double>(2 * i) * theta;
        along_[i] += chord.along * std::cos(angle) / static_cast<double>(points);
        across_[i] += chord.across * std::cos(angle) / static_cast<double>(points);
        mixed_[i] += chord.mixed * std::sin(angle) / static_cast<double>(points);
      }
    }
  }

  double along(Index m) const { return along_[std::abs(m) / 2]; }
  double across(Index m) const { return across_[std::abs(m) / 2]; }
  double mixed(Index m) const { return m < 0 ? -mixed_[-m / 2] : mixed_[m / 2]; }

 private:
  VectorXd along_, across_, mixed_;
};

/// A trigonometric polynomial for each component: the coefficients of cos(m theta) in the component
/// that is even in y, and of sin(m theta) in the odd one, m = 0 ... order.
struct EdgeValues {
  VectorXd even, odd;
};

/// Motions that make one component of the traction even in y and the other odd.
class MirroredRolling {
 public:
  /// \param is_along  The tractions along are even.
  MirroredRolling(double a, double nu, bool is_along, Index order)
      : a_(a), nu_(nu), is_along_(is_along), order_(order), chords_(a, nu, 2 * order) {
    const Index sizes = order + 1;
    even_ = odd_ = MatrixXd::Zero(sizes, sizes);
    for (Index degree = 0; degree <= order; ++degree) {
      const EdgeValues free = values(degree, free_displacement(degree));
      even_.col(degree) = free.even;
      odd_.col(degree) = free.odd;
    }
    make_tests();
    free_.compute(tested(even_, odd_));
  }

  /// Integrals of N over sqrt(1 - r^2), in the ellipse with a b = 1.
  struct Integrals {
    double force;   ///< of the even component
    double x_even;  ///< the first moment in x of the even component
    double y_odd;   ///< that in y of the odd component
  };

  /// \param displacement  by a motion, of this degree
  Integrals resultants(Index degree, const EdgeValues& displacement) const {
    const EdgeValues imposed = values(degree, displacement);
    const VectorXd amplitudes = free_.solve(-tested(imposed.even, imposed.odd));
    const double is_first = degree == 1 ? 1 : 0;
    return {2 * pi * amplitudes[0] * even_(0, 0),
            2 * pi / 3 * a_ * (amplitudes[1] * even_(1, 1) + is_first * imposed.even[1]),
            2 * pi / 3 / a_ * (amplitudes[1] * odd_(1, 1) + is_first * imposed.odd[1])};
  }

 private:
  static Index first_even(Index degree) { return degree % 2; }
  static Index first_odd(Index degree) { return 2 - degree % 2; }

  /// The displacement P_l(y/b), which material keeps on its way through the contact: the even
  /// component of an even degree, the odd one of an odd degree.
  EdgeValues free_displacement(Index degree) const {
    EdgeValues found{VectorXd::Zero(order_ + 1), VectorXd::Zero(order_ + 1)};
    for (Index m = degree % 2; m <= degree; m += 2) {
      const double sign = m / 2 % 2 == 0 ? 1 : -1;
      (degree % 2 == 0 ? found.even : found.odd)[m] = sign * (m == 0 ? 1 : 2) / pi;
    }
    return found;
  }

  /// N on the edge by a displacement of this degree: the compliance times N has the coefficients of
  /// the displacement up to the degree.
  EdgeValues values(Index degree, const EdgeValues& displacement) const {
    const Index e = first_even(degree), o = first_odd(degree);
    const Index evens = degree / 2 + 1, odds = (degree + 1) / 2;
    MatrixXd matrix(evens + odds, evens + odds);
    const auto own = [&](bool along, Index m) {
      return along ? chords_.along(m) : chords_.across(m);
    };
    for (Index i = 0; i < evens + odds; ++i) {
      const bool to_even = i < evens;
      const Index k = to_even ? e + 2 * i : o + 2 * (i - evens);
      for (Index j = 0; j < evens + odds; ++j) {
        const bool of_even = j < evens;
        const Index m = of_even ? e + 2 * j : o + 2 * (j - evens);
        const double value = to_even && of_even ? own(is_along_, k - m) + own(is_along_, k + m)
                             : to_even          ? chords_.mixed(m + k) + chords_.mixed(m - k)
                             : of_even          ? chords_.mixed(k + m) + chords_.mixed(k - m)
                                                : own(!is_along_, k - m) - own(!is_along_, k + m);
        matrix(i, j) = k == 0 ? value / 2 : value;
      }
    }
    VectorXd right(evens + odds);
    for (Index i = 0; i < evens; ++i) right[i] = displacement.even[e + 2 * i];
    for (Index i = 0; i < odds; ++i) right[evens + i] = displacement.odd[o + 2 * i];
    const VectorXd solved = LuFactors(matrix).solve(right);
    EdgeValues found{VectorXd::Zero(order_ + 1), VectorXd::Zero(order_ + 1)};
    for (Index i = 0; i < evens; ++i) found.even[e + 2 * i] = solved[i];
    for (Index i = 0; i < odds; ++i) found.odd[o + 2 * i] = solved[evens + i];
    return found;
  }

  /// Points of a quarter of the edge, from the x axis to the y axis: half of the leading edge.
  void make_tests() {
    std::vector<std::pair<double, double>> points;
    const auto take = [&](double begin, double end) {
      for_gauss_points<50>(begin, end, [&](double theta, double weight) {
        points.emplace_back(theta, weight);
        points.emplace_back(pi / 2 - theta, weight);
      });
    };
    // The compliance varies fast at the ends of the longer axis.
    const double least = std::min(a_ * a_, 1 / (a_ * a_));
    double end = pi / 4;
    for (; end > least; end /= 4) take(end / 4, end);
    take(0, end);

    const Index size = static_cast<Index>(points.size());
    cosines_.resize(size, order_ + 1);
    sines_.resize(size, order_ + 1);
    even_tests_.resize((order_ + 2) / 2, size);
    odd_tests_.resize((order_ + 1) / 2, size);
    along_.resize(size);
    across_.resize(size);
    mixed_.resize(size);
    for (Index p = 0; p < size; ++p) {
      const auto& point = points[static_cast<std::size_t>(p)];
      const double theta = point.first, weight = point.second;
      const ChordCompliance chord = compliance_of_chord(a_, nu_, theta);
      along_[p] = chord.along;
      across_[p] = chord.across;
      mixed_[p] = chord.mixed;
      const auto angle = [&](Index m) { return static_cast<double>(m) * theta; };
      for (Index m = 0; m <= order_; ++m) {
        cosines_(p, m) = std::cos(angle(m));
        sines_(p, m) = std::sin(angle(m));
      }
      const double scale = weight * std::cos(theta);
      for (Index i = 0; i < even_tests_.rows(); ++i) {
        even_tests_(i, p) = scale * std::cos(angle(2 * i + 1));
      }
      for (Index i = 0; i < odd_tests_.rows(); ++i) {
        odd_tests_(i, p) = scale * std::sin(angle(2 * i + 2));
      }
    }
  }

  /// Integrals over the leading edge of the compliance times N, with as many weights as there are
  /// free displacements.
  MatrixXd tested(const MatrixXd& even, const MatrixXd& odd) const {
    const MatrixXd N_even = cosines_ * even, N_odd = sines_ * odd;
    const VectorXd& of_even = is_along_ ? along_ : across_;
    const VectorXd& of_odd = is_along_ ? across_ : along_;
    MatrixXd found(order_ + 1, even.cols());
    found << even_tests_ * (of_even.asDiagonal() * N_even + mixed_.asDiagonal() * N_odd),
        odd_tests_ * (mixed_.asDiagonal() * N_even + of_odd.asDiagonal() * N_odd);
    return found;
  }

  double a_, nu_;
  bool is_along_;
  Index order_;
  CompliancesOfChords chords_;
  MatrixXd even_, odd_;  ///< N on the edge by the free displacements, a column for each degree
  MatrixXd cosines_, sines_, even_tests_, odd_tests_;
  VectorXd along_, across_, mixed_;
  LuFactors free_;
};

CreepCoefficients coefficients_of_order(double ratio, double nu, Index order) {
  const double a = std::sqrt(ratio);
  const auto none = [&] {
    return EdgeValues{VectorXd::Zero(order + 1), VectorXd::Zero(order + 1)};
  };
  EdgeValues creepage = none(), spin = none();
  // x = a X; -x y = -X Y; x^2/2 = a^2 (X^2 - Y^2)/2 and what is constant along a row.
  creepage.even[1] = 2 * a / pi;
  spin.even[2] = 4 * a * a / (3 * pi);
  spin.odd[2] = -4 / (3 * pi);

  const MirroredRolling along(a, nu, true, order), across(a, nu, false, order);
  const auto by_xi = along.resultants(1, creepage);
  const auto by_eta = across.resultants(1, creepage);
  const auto by_phi = across.resultants(2, spin);
  return {.c11 = -by_xi.force,
          .c22 = -by_eta.force,
          .c23 = -by_phi.force,
          .c32 = by_eta.x_even - by_eta.y_odd,
          .c33 = by_phi.y_odd - by_phi.x_even};
}

}  // namespace

EstimatedCreepCoefficients creep_coefficients(double ratio, double poisson_ratio, Index order) {
  require(ratio >= least_kalker_ratio && ratio <= largest_kalker_ratio, "ratio", ratio,
          "a number 0.01 ... 100");
  require(poisson_ratio >= 0 && poisson_ratio <= 0.5, "poisson_ratio", poisson_ratio,
          "a number 0 ... 0.5");
  require(order >= 12 && order <= 96, "order", static_cast<double>(order),
          "a whole number 12 ... 96");
  const CreepCoefficients found = coefficients_of_order(ratio, poisson_ratio, order);
  const double difference = std::abs(found.c23 - found.c32);
  CreepCoefficients error{.c11 = 0, .c22 = 0, .c23 = difference, .c32 = difference, .c33 = 0};
  // Errors of odd and even orders may have different signs. So one change may be small by chance.
  for (const Index coarse : {order * 2 / 3, order * 2 / 3 + 1}) {
    const CreepCoefficients other = coefficients_of_order(ratio, poisson_ratio, coarse);
    const auto take = [&](double CreepCoefficients::*of) {
      error.*of = std::max(error.*of, std::abs(found.*of - other.*of));
    };
    take(&CreepCoefficients::c11);
    take(&CreepCoefficients::c22);
    take(&CreepCoefficients::c23);
    take(&CreepCoefficients::c32);
    take(&CreepCoefficients::c33);
  }
  return {.value = found, .error = error};
}

}  // namespace microslip
