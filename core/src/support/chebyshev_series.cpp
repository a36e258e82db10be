// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/chebyshev_series.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/support/require.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Points whose recurrences run side by side: each waits for its own last product.
constexpr Index abreast = 8;

/// Returns cos(pi m / (2 n)) for m = 0 ... 4 n - 1, a whole turn.
VectorXd cosines(Index n) {
  const double step = std::numbers::pi / (2 * static_cast<double>(n));
  return VectorXd::NullaryExpr(4 * n,
                               [&](Index m) { return std::cos(static_cast<double>(m) * step); });
}

/// Clenshaw's recurrence at a number, or at an array of them.
template <class Value>
Value clenshaw(const VectorXd& coefficients, const Value& t, const Value& zero) {
  Value next = zero, after = zero;
  for (Index k = coefficients.size() - 1; k > 0; --k) {
    const Value sum = 2 * t * next - after + coefficients[k];
    after = next;
    next = sum;
  }
  return t * next - after + coefficients[0] / 2;
}

}  // namespace

VectorXd chebyshev_points(double half_length, Index n) {
  const auto count = static_cast<double>(n);
  const ArrayXd places = ArrayXd::LinSpaced(n, 0, count - 1) + 0.5;
  return half_length * (std::numbers::pi / count * places).cos();
}

ChebyshevSeries::ChebyshevSeries(const VectorXd& values, double half_length)
    : half_length_(half_length) {
  require_positive("half_length", half_length);
  const Index n = values.size();
  require(n > 0, "values", 0, "at least one");
  const VectorXd cosine = cosines(n);
  coefficients_ = VectorXd::NullaryExpr(n, [&](Index k) {
    // The angles are k (2 j + 1) pi/(2 n).
    double sum = 0;
    for (Index j = 0, m = k; j < n; ++j, m = (m + 2 * k) % (4 * n)) sum += values[j] * cosine[m];
    return 2 * sum / static_cast<double>(n);
  });
}

VectorXd ChebyshevSeries::operator()(const Eigen::Ref<const VectorXd>& x) const {
  using Points = Eigen::Array<double, abreast, 1>;
  VectorXd values(x.size());
  for (Index first = 0; first < x.size(); first += abreast) {
    const Index count = std::min(abreast, x.size() - first);
    Points t = Points::Zero();
    t.head(count) = x.segment(first, count).array() / half_length_;
    const Points found = clenshaw<Points>(coefficients_, t, Points::Zero());
    values.segment(first, count) = found.head(count);
  }
  count_work(3 * static_cast<double>(x.size() * (coefficients_.size() - 1)));
  return values;
}

double ChebyshevSeries::operator()(double x) const {
  count_work(3 * static_cast<double>(coefficients_.size() - 1));
  return clenshaw(coefficients_, x / half_length_, 0.0);
}

}  // namespace microslip
