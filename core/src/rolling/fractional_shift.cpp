// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/fractional_shift.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The solution of T q = (t_1, ..., t_n), T_ij = t_|i-j|: Durbin's recursion for the predictor.
VectorXd linear_predictor(const VectorXd& t) {
  const Index n = t.size() - 1;
  VectorXd q(n);
  double power = t[0];
  count_work(2 * static_cast<double>(n * n));
  for (Index k = 0; k < n; ++k) {
    const double reflection = (t[k + 1] - q.head(k).dot(t.segment(1, k).reverse())) / power;
    q.head(k) -= (reflection * q.head(k).reverse()).eval();
    q[k] = reflection;
    power *= (1 - reflection) * (1 + reflection);
    if (!(power > 0)) {
      throw NotConverged("fractional powers: influence coefficients are not positive definite",
                         static_cast<int>(k), std::abs(reflection));
    }
  }
  return q;
}

/// det(t + M), for an odd number of elements; the determinant is zero if -t is an eigenvalue.
double determinant(const VectorXd& outflow, double t) {
  const Index last = outflow.size() - 1;
  double homogeneous = 1;
  for (Index i = 0; i < last; ++i) homogeneous = -outflow[i] - t * homogeneous;
  return outflow[last] + t * homogeneous;
}

/// Whether an eigenvalue inside the unit circle is negative. The samples miss a pair of negative
/// eigenvalues that is closer together than two samples.
bool has_negative_eigenvalue(const VectorXd& outflow) {
  constexpr int samples = 500;
  for (int k = 0; k <= samples; ++k) {
    if (determinant(outflow, static_cast<double>(k) / samples) <= 0) return true;
  }
  return false;
}

/// M p
VectorXd shifted(const VectorXd& outflow, const VectorXd& p) {
  const Index n = p.size();
  VectorXd moved = p[0] * outflow;
  moved.head(n - 1) += p.tail(n - 1);
  return moved;
}

/// The integrand of (M^c - I) b at t = exp(-y), for r = (M - I) b.
class PowerIntegrand {
 public:
  PowerIntegrand(const VectorXd& outflow, const VectorXd& r, double power)
      : outflow_(outflow), r_(r), power_(power), inner_(r.size()), homogeneous_(r.size()) {}

  int solves() const { return solves_; }
  const VectorXd& right_hand_side() const { return r_; }

  /// total += weight * integrand(y)
  void add(double y, double weight, VectorXd& total) {
    count_work(24 * static_cast<double>(r_.size()));
    const double t = std::exp(-y);
    solve_low(t);
    total += weight * t * std::pow(t, power_) / (1 + t) * inner_;
    solve_high(t);
    total += weight * t * std::pow(t, -power_) * (inner_ / (1 + t) - r_);
  }

 private:
  /// (t + M) x = r: from the first unknown up, which is stable for t <= 1.
  void solve_low(double t) {
    const Index last = r_.size() - 1;
    inner_[0] = 0;
    homogeneous_[0] = 1;
    for (Index i = 0; i < last; ++i) {
      inner_[i + 1] = r_[i] - t * inner_[i];
      homogeneous_[i + 1] = -outflow_[i] - t * homogeneous_[i];
    }
    const double first = (r_[last] - t * inner_[last]) / (outflow_[last] + t * homogeneous_[last]);
    inner_ += first * homogeneous_;
    ++solves_;
  }

  /// (1 + t M) x = r: from the last unknown down, stable for t <= 1.
  void solve_high(double t) {
    const Index last = r_.size() - 1;
    inner_[last] = r_[last];
    homogeneous_[last] = t * outflow_[last];
    for (Index i = last; i > 0; --i) {
      inner_[i - 1] = r_[i - 1] - t * inner_[i];
      homogeneous_[i - 1] = t * (outflow_[i - 1] - homogeneous_[i]);
    }
    inner_ -= inner_[0] / (1 + homogeneous_[0]) * homogeneous_;
    ++solves_;
  }

  const VectorXd& outflow_;
  const VectorXd& r_;
  double power_;
  VectorXd inner_;
  VectorXd homogeneous_;
  int solves_ = 0;
};

/// Adaptive Gauss-Kronrod quadrature of a vector; adds the integral over [begin, end] to `total`.
void integrate(PowerIntegrand& integrand, double begin, double end, int depth, VectorXd& total) {
  using Kronrod = boost::math::quadrature::gauss_kronrod<double, 15>;
  using Gauss = boost::math::quadrature::gauss<double, 7>;
  constexpr double accepted = 1e-9;  // error of Gauss; the Kronrod sum then has all digits
  constexpr int deepest = 40;
  const double middle = (begin + end) / 2;
  const double half = (end - begin) / 2;
  VectorXd kronrod = VectorXd::Zero(total.size());
  VectorXd difference = VectorXd::Zero(total.size());
  VectorXd value(total.size());
  for (std::size_t k = 0; k < Kronrod::abscissa().size(); ++k) {
    const double weight = Kronrod::weights()[k];
    const double gauss_weight = k % 2 == 0 ? Gauss::weights()[k / 2] : 0;
    value.setZero();
    integrand.add(middle - half * Kronrod::abscissa()[k], half, value);
    if (k > 0) integrand.add(middle + half * Kronrod::abscissa()[k], half, value);
    kronrod += weight * value;
    difference += (weight - gauss_weight) * value;
  }
  const double error = difference.lpNorm<Eigen::Infinity>();
  if (error <= accepted * integrand.right_hand_side().lpNorm<Eigen::Infinity>()) {
    total += kronrod;
    return;
  }
  if (depth == deepest || !std::isfinite(error)) {
    throw NotConverged("fractional powers: the quadrature fails", integrand.solves(), error);
  }
  integrate(integrand, begin, middle, depth + 1, total);
  integrate(integrand, middle, end, depth + 1, total);
}

}  // namespace

FractionalShift::FractionalShift(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                                 Index elements) {
  require(elements % 2 == 1, "elements", static_cast<double>(elements),
          "an odd number for fractional powers, which are complex otherwise");
  outflow_ = linear_predictor(VectorXd::NullaryExpr(elements + 1, [&](Index k) {
    return influence(kernel, shape, spacing, static_cast<double>(k));
  }));
  if (has_negative_eigenvalue(outflow_)) {
    reject("scheme", "fractional",
           "another scheme, or in plane strain a length of at least 3.8 half-widths: the "
           "displacement is negative far from a load here, and so is an eigenvalue of the shift by "
           "an element, the fractional powers of which are complex");
  }
}

FractionalShift::Moved FractionalShift::move(const VectorXd& traction, double step_ratio) const {
  require(step_ratio >= 0, "step_ratio", step_ratio, "a number >= 0");
  constexpr double rounding = 1e-12;  // error of a quotient of lengths
  const double nearest = std::round(step_ratio);
  const bool is_whole = nearest > 0 && std::abs(step_ratio - nearest) <= rounding * nearest;
  const double whole = is_whole ? nearest : std::floor(step_ratio);
  const double power = is_whole ? 0 : step_ratio - whole;
  VectorXd moved = traction;
  for (double k = 0; k < whole; ++k) moved = shifted(outflow_, moved);
  if (power == 0) return {moved, 0};

  // M^c - I = sin(pi c)/pi (M - I) times the integral over t > 0 of t^c/(1 + t) (t + M)^-1. For t >
  // 1 the variable is 1/t, and the integral's value for M = 0, 1/(1 - c), is subtracted. On both
  // intervals t = exp(-y).
  const VectorXd r = shifted(outflow_, moved) - moved;
  if (r.isZero(0)) return {moved, 0};
  PowerIntegrand integrand(outflow_, r, power);
  constexpr double far = 42;  // exp(-far) is below rounding
  VectorXd sum = r / (1 - power);
  double end = far;
  for (; end * static_cast<double>(size()) > 1; end /= 2) {
    integrate(integrand, end / 2, end, 0, sum);
  }
  integrate(integrand, 0, end, 0, sum);
  moved += std::sin(std::numbers::pi * power) / std::numbers::pi * sum;
  return {moved, integrand.solves()};
}

Eigen::MatrixXd shift_matrix(const FractionalShift& shift) {
  const Index n = shift.size();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  matrix.diagonal(1).setOnes();
  matrix.col(0) = shift.outflow();
  return matrix;
}

}  // namespace microslip
