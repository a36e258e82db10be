// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/kernel.hpp"

#include <fmt/core.h>
#include <gsl/gsl_sf_expint.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "../support/gsl.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

StripKernel::StripKernel(const Material& material, double width)
    : material_(material), half_width_(width / 2) {
  validate_also_lateral(material);
  require_positive("width", width);
  log_factor_ = compliance(material) / std::numbers::pi;
  plain_factor_ = 2 * material.poisson_ratio / (std::numbers::pi * material.shear_modulus);
}

double StripKernel::displacement(double z) const {
  return log_factor_ * std::asinh(half_width_ / z) +
         plain_factor_ * half_width_ / std::hypot(z, half_width_);
}

double StripKernel::decay(double z) const {
  const double radius = std::sqrt(z * z + half_width_ * half_width_);
  return half_width_ / radius * (log_factor_ / z + plain_factor_ * z / (radius * radius));
}

std::complex<double> StripKernel::decay(std::complex<double> z) const {
  // As a product, the radius keeps its digits next to its singularities at +-i half_width_.
  const std::complex<double> radius =
      std::sqrt(z + std::complex(0.0, half_width_)) * std::sqrt(z - std::complex(0.0, half_width_));
  return half_width_ / radius * (log_factor_ / z + plain_factor_ * z / (radius * radius));
}

double StripKernel::regular_displacement(double z) const {
  const double radius = std::sqrt(z * z + half_width_ * half_width_);
  return log_factor_ * std::log(half_width_ + radius) + plain_factor_ * half_width_ / radius;
}

double StripKernel::regular_decay(double z) const {
  const double radius = std::sqrt(z * z + half_width_ * half_width_);
  return z / radius *
         (plain_factor_ * half_width_ / (radius * radius) - log_factor_ / (half_width_ + radius));
}

double StripKernel::integral(double z) const {
  if (z == 0) return 0;
  const double along = half_width_ * std::asinh(z / half_width_);
  return log_factor_ * (z * std::asinh(half_width_ / std::abs(z)) + along) + plain_factor_ * along;
}

double StripKernel::double_integral(double z) const {
  const double rise = z * z / (half_width_ + std::hypot(z, half_width_));
  const double along = z * std::asinh(z / half_width_);
  const double across = z == 0 ? 0 : z * z / 2 * std::asinh(half_width_ / std::abs(z));
  return log_factor_ * (across + half_width_ * (along - rise / 2)) +
         plain_factor_ * half_width_ * (along - rise);
}

PlaneKernel::PlaneKernel(const Material& material, double length)
    : material_(material), length_(length) {
  validate_also_lateral(material);
  require_positive("length", length);
  factor_ = compliance(material) / std::numbers::pi;
}

double PlaneKernel::displacement(double z) const { return -factor_ * std::log(z / length_); }

double PlaneKernel::decay(double z) const { return factor_ / z; }

std::complex<double> PlaneKernel::decay(std::complex<double> z) const { return factor_ / z; }

double PlaneKernel::regular_displacement(double) const { return factor_ * std::log(length_); }

double PlaneKernel::regular_decay(double) const { return 0; }

double PlaneKernel::integral(double z) const {
  return z == 0 ? 0 : -factor_ * z * (std::log(std::abs(z) / length_) - 1);
}

double PlaneKernel::double_integral(double z) const {
  return z == 0 ? 0 : -factor_ * z * z / 2 * (std::log(std::abs(z) / length_) - 1.5);
}

double PlaneKernel::clear_distance() const { return std::numeric_limits<double>::infinity(); }

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Sizes relative to the symbol below which a layer or half-space behind a table is rounding.
constexpr double rounding_of_symbol = 1e-12;

/// By how much the exponent of the symbol in the last two rows may be below the exponent of a half-space, or above
/// the exponent of springs.
constexpr double steepest = 0.5;

/// The longest phase, in radians, of a sine that 15 Gauss points integrate to rounding.
constexpr double longest_phase = 5;

/// Ci(x), 0 where it is below rounding of Ci(1). \param x  > 0
double cosine_integral(double x) {
  constexpr double far = 1e16;
  if (x > far) return 0;
  gsl_sf_result found{};
  gsl::require_success(gsl::quietly([&] { return gsl_sf_Ci_e(x, &found); }), "Ci");
  return found.val;
}

/// The half-space of a kernel.
/// \return null if there is none
template <class HalfSpace>
const HalfSpace* half_space_in(const Kernel& kernel) {
  const auto* layered = std::get_if<LayeredKernel>(&kernel);
  return layered != nullptr ? std::get_if<HalfSpace>(&layered->half_space())
                            : std::get_if<HalfSpace>(&kernel);
}

}  // namespace

WinklerKernel::WinklerKernel(double compliance) : compliance_(compliance) {
  require_positive("compliance", compliance);
}

double WinklerKernel::clear_distance() const { return infinite; }

LayeredKernel::LayeredKernel(const HalfSpace& half_space, double compliance)
    : half_space_(half_space), compliance_(compliance) {
  require_positive("compliance", compliance);
}

double LayeredKernel::displacement(double z) const {
  return std::visit([&](const auto& k) { return k.displacement(z); }, half_space_);
}

double LayeredKernel::decay(double z) const {
  return std::visit([&](const auto& k) { return k.decay(z); }, half_space_);
}

double LayeredKernel::clear_distance() const {
  return std::visit([](const auto& k) { return k.clear_distance(); }, half_space_);
}

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

double SymbolKernel::clear_distance() const { return infinite; }

double SymbolKernel::longest_panel() const {
  return bends_.size() == 0 ? infinite : longest_phase / bends_[bends_.size() - 1];
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

std::string_view name_of(const Kernel& kernel) {
  if (std::holds_alternative<WinklerKernel>(kernel)) return "winkler";
  if (std::holds_alternative<SymbolKernel>(kernel)) return "symbol";
  const bool strip = half_space_in<StripKernel>(kernel) != nullptr;
  if (is_half_space(kernel)) return strip ? "strip" : "plane";
  return strip ? "strip with a layer" : "plane with a layer";
}

bool is_half_space(const Kernel& kernel) {
  return std::holds_alternative<StripKernel>(kernel) || std::holds_alternative<PlaneKernel>(kernel);
}

void require_half_space(const Kernel& kernel, std::string_view who) {
  if (is_half_space(kernel)) return;
  reject("kernel", name_of(kernel), fmt::format("strip or plane without a layer for {}", who));
}

const Material& material_of(const Kernel& kernel) {
  if (const auto* strip = half_space_in<StripKernel>(kernel)) return strip->material();
  if (const auto* plane = half_space_in<PlaneKernel>(kernel)) return plane->material();
  throw std::logic_error("a kernel without a half-space has no material");
}

double log_factor(const Kernel& kernel) {
  if (std::holds_alternative<WinklerKernel>(kernel)) return 0;
  if (const auto* symbol = std::get_if<SymbolKernel>(&kernel)) return symbol->log_factor();
  return compliance(material_of(kernel)) / std::numbers::pi;
}

double layer_compliance(const Kernel& kernel) {
  if (const auto* winkler = std::get_if<WinklerKernel>(&kernel)) return winkler->compliance();
  if (const auto* layered = std::get_if<LayeredKernel>(&kernel)) return layered->compliance();
  if (const auto* symbol = std::get_if<SymbolKernel>(&kernel)) return symbol->compliance();
  return 0;
}

double definite_half_length(const Kernel& kernel) {
  const auto* plane = half_space_in<PlaneKernel>(kernel);
  return plane != nullptr ? 2 * plane->length() : infinite;
}

namespace {

struct InUnits {
  double length;

  StripKernel operator()(const StripKernel& strip) const {
    return {strip.material(), strip.width() / length};
  }
  PlaneKernel operator()(const PlaneKernel& plane) const {
    return {plane.material(), plane.length() / length};
  }
  WinklerKernel operator()(const WinklerKernel& winkler) const {
    return WinklerKernel(winkler.compliance() / length);
  }
  LayeredKernel operator()(const LayeredKernel& layered) const {
    const auto half_space = [&](const auto& of) { return LayeredKernel::HalfSpace((*this)(of)); };
    return {std::visit(half_space, layered.half_space()), layered.compliance() / length};
  }
  SymbolKernel operator()(const SymbolKernel& symbol) const {
    return {symbol.wave_numbers() * length, symbol.symbols() / length};
  }
};

}  // namespace

Kernel in_units_of(const Kernel& kernel, double length) {
  return std::visit([&](const auto& of) { return Kernel(InUnits{length}(of)); }, kernel);
}

double clear_distance(const Kernel& kernel) {
  return std::visit([](const auto& k) { return k.clear_distance(); }, kernel);
}

}  // namespace microslip
