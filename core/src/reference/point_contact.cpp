// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/point_contact.hpp"

#include <algorithm>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "microslip/support/require.hpp"

namespace microslip {

using boost::math::ellint_rd;

namespace {

constexpr double largest_ratio = 1e8;  ///< of curvatures

/// k = s/l by A_s/A_l. The logarithm of the ratio of integrals is monotonic in log k.
double ratio_of_axes(double ratio_of_curvatures) {
  if (ratio_of_curvatures == 1) return 1;
  const auto error = [&](double log_k) {
    const double k2 = std::exp(2 * log_k);
    return std::log(ellint_rd(0.0, 1.0, k2) / ellint_rd(0.0, k2, 1.0) / ratio_of_curvatures);
  };
  constexpr double least = -23;  // log 1e-10
  std::uintmax_t rounds = 200;
  const auto [from, to] = boost::math::tools::toms748_solve(
      error, least, 0.0, boost::math::tools::eps_tolerance<double>(50), rounds);
  return std::exp((from + to) / 2);
}

}  // namespace

PointContact::PointContact(const Material& material, double load, double along, double across) {
  validate(material);
  require_positive("load", load);
  require_positive("along", along);
  require_positive("across", across);
  const double least = std::min(along, across), most = std::max(along, across);
  require(most <= largest_ratio * least, "across", across,
          "a curvature of 1e-8 to 1e8 of that along the rolling");
  const double k = ratio_of_axes(most / least);
  const double stiffness = material.shear_modulus / (1 - material.poisson_ratio);
  const double longer =
      std::cbrt(load * ellint_rd(0.0, k * k, 1.0) / (std::numbers::pi * stiffness * least));
  half_width_ = along <= across ? longer : k * longer;
  lateral_half_width_ = along <= across ? k * longer : longer;
  peak_ = 1.5 * load / (std::numbers::pi * half_width_ * lateral_half_width_);
}

}  // namespace microslip
