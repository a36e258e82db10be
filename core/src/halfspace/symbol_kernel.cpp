// SPDX-License-Identifier: GPL-3.0-or-later
#include <gsl/gsl_sf_expint.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "microslip/halfspace/kernel_types.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Sizes relative to the symbol below which a layer or half-space behind a table is rounding.
constexpr double rounding_of_symbol = 1e-12;

/// By how much the exponent of the symbol in the last two rows may be below the exponent of a
/// half-space, or above the exponent of springs.
constexpr double steepest = 0.5;

/// Ci(x), 0 where it is below rounding of Ci(1). \param x  > 0, as GSL's default is to end the
/// program at others
double cosine_integral(double x) {
  constexpr double far = 1e16;
  if (x > far) return 0;
  if (!(x > 0)) throw std::invalid_argument("Ci: expected a number > 0");
  return gsl_sf_Ci(x);
}

}  // namespace

SymbolKernel::SymbolKernel(const VectorXd& wave_numbers, const VectorXd& symbol)
    : wave_numbers_(wave_numbers), symbol_(symbol) {
  const Index n = wave_numbers.size();
  require(n >= 2 && n <= most_rows && symbol.size() == n, "rows", static_cast<double>(n),
          "2 to 1000 wave numbers, and a symbol for each");
  for (Index i = 0; i < n; ++i) {
    require_positive("symbol", symbol[i]);
    require_positive("wave_number", wave_numbers[i]);
    require(i == 0 || wave_numbers[i] > wave_numbers[i - 1], "wave_number", wave_numbers[i],
            "more than the one before");
  }
  const VectorXd rising = wave_numbers.cwiseProduct(symbol);
  VectorXd slopes(n + 1);  // before each row and behind the last one
  slopes[0] = symbol[0];
  for (Index i = 1; i < n; ++i) {
    slopes[i] = (rising[i] - rising[i - 1]) / (wave_numbers[i] - wave_numbers[i - 1]);
  }
  const double last = symbol[n - 1];
  compliance_ = slopes[n - 1];
  require(compliance_ >= -steepest * last, "symbol", last,
          "one that falls no faster than wave_number^-1.5 in the last two rows, which say how it "
          "goes on: as of a half-space and a layer");
  require(compliance_ <= (1 + steepest) * last, "symbol", last,
          "one that rises no faster than wave_number^0.5 in the last two rows, which say how it "
          "goes on: as of a half-space and a layer");
  if (compliance_ < rounding_of_symbol * last) compliance_ = 0;
  if (compliance_ > (1 - rounding_of_symbol) * last) compliance_ = last;
  slopes[n] = compliance_;
  log_factor_ = (last - compliance_) * wave_numbers[n - 1] / std::numbers::pi;
  const VectorXd factors =
      wave_numbers.cwiseProduct(slopes.head(n) - slopes.tail(n)) / std::numbers::pi;
  const double least = std::numeric_limits<double>::epsilon() * factors.cwiseAbs().maxCoeff();
  const auto bends = (factors.array().abs() > least).eval();
  bends_.resize(bends.count());
  factors_.resize(bends.count());
  for (Index i = 0, k = 0; i < n; ++i) {
    if (!bends[i]) continue;
    bends_[k] = wave_numbers[i];
    factors_[k++] = factors[i];
  }
}

SymbolKernel SymbolKernel::in_units_of(double length) const {
  return {wave_numbers_ * length, symbol_ / length};
}

double SymbolKernel::displacement(double z) const {
  double sum = 0;
  for (Index i = 0; i < bends_.size(); ++i) {
    const double phase = bends_[i] * z;
    sum += factors_[i] * (std::sin(phase) / phase - cosine_integral(phase));
  }
  return sum;
}

double SymbolKernel::decay(double z) const {
  return (factors_ * (bends_ * z).sin() / bends_).sum() / z / z;
}

double SymbolKernel::symbol(double wave_number) const {
  if (wave_number <= wave_numbers_[0]) return symbol_[0];
  const Index n = wave_numbers_.size();
  if (wave_number >= wave_numbers_[n - 1]) {
    return std::numbers::pi * log_factor_ / wave_number + compliance_;
  }
  const Index i = std::upper_bound(wave_numbers_.begin(), wave_numbers_.end(), wave_number) -
                  wave_numbers_.begin();
  const double part =
      (wave_number - wave_numbers_[i - 1]) / (wave_numbers_[i] - wave_numbers_[i - 1]);
  return std::lerp(wave_numbers_[i - 1] * symbol_[i - 1], wave_numbers_[i] * symbol_[i], part) /
         wave_number;
}

}  // namespace microslip
