// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/point_contact.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "microslip/support/format.hpp"
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

void require_radius(std::string_view name, double radius) {
  constexpr double least = 1e-50, largest = 1e50;
  const double size = std::abs(radius);
  require(radius == 0 || (size >= least && size <= largest), name, radius,
          "a number from 1e-50 to 1e50 in size, or 0 of a flat body");
}

[[noreturn]] void reject_curvature(std::string_view name, double radius, std::string_view other,
                                   double of_other) {
  const std::string accepted = of_other > 0
                                   ? fmt::format(
                                         "a number > 0, or for a concave body one below -{}, as "
                                         "its radius is larger than {}",
                                         format_short(of_other), other)
                                   : fmt::format("a number > 0, as the other body is {}, by {}",
                                                 of_other < 0 ? "concave" : "flat", other);
  throw BadParameter(name,
                     fmt::format("{} = {}: expected {}", name, format_short(radius), accepted));
}

}  // namespace

double summed_curvature(std::string_view name_1, double radius_1, std::string_view name_2,
                        double radius_2) {
  require_radius(name_1, radius_1);
  require_radius(name_2, radius_2);
  const double sum = (radius_1 != 0 ? 1 / radius_1 : 0) + (radius_2 != 0 ? 1 / radius_2 : 0);
  if (sum > 0) return sum;
  // To blame is a concave body, or of two the first one.
  if (radius_1 < 0 || radius_2 >= 0) reject_curvature(name_1, radius_1, name_2, radius_2);
  reject_curvature(name_2, radius_2, name_1, radius_1);
}

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
