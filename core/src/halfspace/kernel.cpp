// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/kernel.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "microslip/support/require.hpp"

namespace microslip {

StripKernel::StripKernel(const Material& material, double width)
    : material_(material), half_width_(width / 2) {
  validate(material);
  require_positive("kernel.width", width);
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

PlaneKernel::PlaneKernel(const Material& material, double length)
    : material_(material), length_(length) {
  validate(material);
  require_positive("kernel.length", length);
  factor_ = compliance(material) / std::numbers::pi;
}

double PlaneKernel::displacement(double z) const { return -factor_ * std::log(z / length_); }

double PlaneKernel::decay(double z) const { return factor_ / z; }

double PlaneKernel::clear_distance() const { return std::numeric_limits<double>::infinity(); }

const Material& material_of(const Kernel& kernel) {
  return std::visit([](const auto& k) -> const Material& { return k.material(); }, kernel);
}

}  // namespace microslip
