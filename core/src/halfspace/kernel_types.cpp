// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/kernel_types.hpp"

#include <cmath>
#include <numbers>

#include "microslip/support/require.hpp"

namespace microslip {

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
  log_factor_ = compliance(material) / std::numbers::pi;
}

double PlaneKernel::displacement(double z) const { return -log_factor_ * std::log(z / length_); }

double PlaneKernel::decay(double z) const { return log_factor_ / z; }

std::complex<double> PlaneKernel::decay(std::complex<double> z) const { return log_factor_ / z; }

double PlaneKernel::regular_displacement(double) const { return log_factor_ * std::log(length_); }

double PlaneKernel::regular_decay(double) const { return 0; }

double PlaneKernel::integral(double z) const {
  return z == 0 ? 0 : -log_factor_ * z * (std::log(std::abs(z) / length_) - 1);
}

double PlaneKernel::double_integral(double z) const {
  return z == 0 ? 0 : -log_factor_ * z * z / 2 * (std::log(std::abs(z) / length_) - 1.5);
}

WinklerKernel::WinklerKernel(double compliance) : compliance_(compliance) {
  require_positive("compliance", compliance);
}

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

std::string_view LayeredKernel::name() const {
  const bool strip = std::holds_alternative<StripKernel>(half_space_);
  return strip ? "strip with a layer" : "plane with a layer";
}

double LayeredKernel::log_factor() const {
  return std::visit([](const auto& k) { return k.log_factor(); }, half_space_);
}

double LayeredKernel::definite_half_length() const {
  return std::visit([](const auto& k) { return k.definite_half_length(); }, half_space_);
}

const Material& LayeredKernel::material() const {
  return std::visit([](const auto& k) -> const Material& { return k.material(); }, half_space_);
}

LayeredKernel LayeredKernel::in_units_of(double length) const {
  const auto half_space = [&](const auto& k) { return HalfSpace(k.in_units_of(length)); };
  return {std::visit(half_space, half_space_), compliance_ / length};
}

}  // namespace microslip
