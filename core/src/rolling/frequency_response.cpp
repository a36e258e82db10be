// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/frequency_response.hpp"

#include <fmt/core.h>
#include <gsl/gsl_sf_bessel.h>

#include <boost/math/special_functions/sinc.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "microslip/linalg/matrix_product.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::numbers::pi;
using Complex = std::complex<double>;

namespace {

constexpr double most_terms_in_all = 700;
constexpr double most_terms_of_strip = 500;
constexpr double largest_kappa = 1e6;

constexpr double terms_of_wave = 1.2;  // number of terms for a wave, over kappa

/// Number of terms that resolves the effect of a strip's regular kernel to 1e-14, without the terms
/// for the wave.
double terms_of_strip(double clear, double half_length) {
  return 42 + 22 / std::asinh(clear / half_length);
}

}  // namespace

Complex adhesion_ratio(double kappa) {
  const double j0 = gsl_sf_bessel_J0(kappa);
  const double j1 = gsl_sf_bessel_J1(kappa);
  return j0 / Complex(j0, j1);
}

/// The kernel over k is split into -ln|z/half_length| and a regular part. After rows are divided by
/// the eigenvalues of the logarithm, pi ln 2 and pi/n, the matrix is the identity plus a smooth
/// part.
FrequencyResponse::Series::Series(const Kernel& kernel, double half_length, Index terms)
    : points(terms), to_coefficients(terms, terms) {
  const double n = static_cast<double>(terms);
  const double step = pi / n;
  MatrixXd polynomials(terms, terms);  // T_j at the points, one column for each degree
  for (Index i = 0; i < terms; ++i) {
    const double angle = step * (static_cast<double>(i) + 0.5);
    points[i] = std::cos(angle);
    for (Index j = 0; j < terms; ++j) {
      polynomials(i, j) = std::cos(angle * static_cast<double>(j));
    }
  }
  to_coefficients = polynomials.transpose() * (2 / n);
  to_coefficients.row(0) /= 2;
  for (Index j = 0; j < terms; ++j) {
    to_coefficients.row(j) /= j == 0 ? pi * std::log(2) : pi / static_cast<double>(j);
  }
  const double k = kernel.log_factor();
  const double shift = std::log(half_length);
  MatrixXd regular(terms, terms);
  visit_half_space(
      [&](const auto& of) {
        for (Index i = 0; i < terms; ++i) {
          for (Index j = 0; j < terms; ++j) {
            const double z = half_length * (points[i] - points[j]);
            regular(i, j) = step * (of.regular_displacement(z) / k - shift);
          }
        }
      },
      kernel);
  count_work(n * n * (kernel_work + 5 * n));
  factors.compute(MatrixXd::Identity(terms, terms) +
                  matrix_product(matrix_product(to_coefficients, regular), polynomials));
}

/// With the creepage 1 and the position x from the middle of the zone, the displacement is
/// (e1 exp(i kappa x) - 1)/(i kappa). The strain e1 is chosen so that the singularity at the
/// leading end, the sum of the alpha_n, vanishes.
/// \return dF/dw times k over the half-length
Complex FrequencyResponse::Series::slope(double half_length, double wave_number) const {
  const ArrayXd half_phases = wave_number * half_length / 2 * points;
  VectorXcd driven(points.size()), free(points.size());
  for (Index i = 0; i < points.size(); ++i) {
    const Complex half = std::polar(1.0, half_phases[i]);
    free[i] = half * half;
    driven[i] = points[i] * boost::math::sinc_pi(half_phases[i]) * half;
  }
  const auto coefficients = [this](const VectorXcd& displacement) {
    VectorXcd solved(points.size());
    solved.real() = factors.solve(to_coefficients * VectorXd(displacement.real()));
    solved.imag() = factors.solve(to_coefficients * VectorXd(displacement.imag()));
    return solved;
  };
  const VectorXcd of_driven = coefficients(driven);
  const VectorXcd of_free = coefficients(free);
  return pi * (of_driven[0] - of_driven.sum() / of_free.sum() * of_free[0]);
}

FrequencyResponse::FrequencyResponse(const Kernel& kernel, double begin, double end,
                                     double shortest)
    : kernel_(kernel), half_length_((end - begin) / 2), shortest_(shortest) {
  require_half_space(kernel, "the frequency response");
  require_positive("length of the stick zone", end - begin);
  require_positive("shortest", shortest);
  const double most = kernel.definite_half_length();
  if (kernel.is_plane()) {
    require(half_length_ < most, "length", *kernel.plane_length(), [&] {
      return fmt::format(
          "more than {}, a quarter of the stick zone: with less, the bodies yield against their "
          "load",
          format_short(half_length_ / 2));
    });
    require(2 * pi * half_length_ <= largest_kappa * shortest, "shortest", shortest, [&] {
      return fmt::format("at least {} with this stick zone",
                         format_short(2 * pi * half_length_ / largest_kappa));
    });
    return;
  }
  const double clear = kernel.clear_distance();
  const double of_strip = terms_of_strip(clear, half_length_);
  require(of_strip <= most_terms_of_strip, "width", 2 * clear, [&] {
    return fmt::format("at least {} with this stick zone",
                       format_short(2 * half_length_ * std::sinh(22 / (most_terms_of_strip - 42))));
  });
  const double of_wave = terms_of_wave * 2 * pi * half_length_ / shortest;
  require(of_strip + of_wave <= most_terms_in_all, "shortest", shortest, [&] {
    return fmt::format("at least {} with this strip and stick zone",
                       format_short(of_wave * shortest / (most_terms_in_all - of_strip)));
  });
  const double terms = of_strip + of_wave;
  series_.emplace_back(kernel, half_length_, static_cast<Index>(terms));
  series_.emplace_back(kernel, half_length_, static_cast<Index>(1.25 * terms));
}

Index FrequencyResponse::terms() const {
  return series_.empty() ? 0 : series_.back().points.size();
}

Complex FrequencyResponse::slope_of_wave(double wave_number) const {
  const double scale = half_length_ / kernel_.log_factor();
  if (!series_.empty()) return scale * series_.back().slope(half_length_, wave_number);
  const double kappa = wave_number * half_length_;
  const double lambda = std::log(2 * *kernel_.plane_length() / half_length_);
  return -scale / (adhesion_ratio(kappa) + Complex(0, kappa * lambda));
}

Complex FrequencyResponse::slope(double wavelength) const {
  require(wavelength >= shortest_, "wavelength", wavelength,
          [&] { return "a number >= " + format_short(shortest_); });
  return slope_of_wave(2 * pi / wavelength);
}

double FrequencyResponse::steady_slope() const { return slope_of_wave(0).real(); }

double FrequencyResponse::estimated_error(double wavelength) const {
  const Complex exact = slope(wavelength);
  const double wave_number = 2 * pi / wavelength;
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  if (series_.empty()) return rounding * std::fmax(1, wave_number * half_length_);
  const Complex scaled = exact * kernel_.log_factor() / half_length_;
  return std::abs(series_.front().slope(half_length_, wave_number) / scaled - 1.0);
}

}  // namespace microslip
