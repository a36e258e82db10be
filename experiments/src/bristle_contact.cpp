// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/bristle_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip::experiments {

using std::numbers::pi;

/// Derivation: a bristle that sticks at x entered the contact a distance a - x ago, at the former
/// position of the edge, and has been stretched since then according to the compliance at each
/// moment. Bristles stick from b on: with r = w a / (compliance mu p0), b/a = (r^2 - 1)/(r^2 + 1).
std::complex<double> Bristles::force_by_normal_load(double wavelength) const {
  const double a = bound.half_width();
  const double rate = creepage / compliance;
  const double ratio = std::abs(rate) * a / bound.peak();
  const double begin = (ratio * ratio - 1) / (ratio * ratio + 1);
  const double kappa = 2 * pi * a / wavelength;
  const double stuck = 1 - begin;
  const std::complex<double> ik(0, kappa);
  const std::complex<double> of_edge = (1.0 - std::polar(1.0, -kappa * stuck)) / ik;
  const std::complex<double> of_compliance = (stuck - of_edge) / ik;
  return -std::copysign(1.0, creepage) *
         ((std::asin(begin) + pi / 2) / pi + ratio / pi * (of_edge - of_compliance));
}

BristleContact::BristleContact(const Bristles& bristles, int number)
    : bristles_(bristles),
      step_(bristles.bound.half_width() / number),
      traction_(4 * static_cast<std::size_t>(number), 0.0) {}

void BristleContact::roll(double size) {
  const double a = bristles_.bound.half_width();
  std::shift_left(traction_.begin(), traction_.end(), 1);
  traction_.back() = 0;
  force_ = 0;
  const double stretch =
      size > 0 ? bristles_.creepage * step_ / (size * bristles_.compliance) : 0;  // [N/mm^2]
  for (std::size_t i = 0; i < traction_.size(); ++i) {
    const double x = (static_cast<double>(i) + 0.5) * step_ - 2 * a;
    const double most = std::abs(x) < size * a ? size * bristles_.bound(x / size) : 0;
    double& p = traction_[i];
    p = std::clamp(p - stretch, -most, most);
    force_ += p * step_;
  }
}

}  // namespace microslip::experiments
