// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <variant>

#include "microslip/halfspace/material.hpp"

namespace microslip {

/// \file
/// A kernel K(z) [mm^2/N] is the displacement difference u_x [mm] at a distance z > 0 [mm] from a
/// tangential line load of 1 N per mm width; with the material lateral(), the displacement u_y due
/// to a lateral load. K is even in z, logarithmic at z = 0, and analytic elsewhere within
/// `clear_distance` of the real axis. `decay` is -dK/dz > 0 [mm/N]; all integrals of the kernel are
/// built on the decay, because it never changes sign.
///
/// The `regular` functions lack the logarithm of plane strain: they are K(z) + log_factor ln z,
/// even in z, and the decay minus log_factor / z, odd in z. Both are analytic at z = 0, too. The
/// decay takes complex z with a positive real part.
///
/// Accuracy: 1e-15 relative, for z from 1e-12 to 1e12 of the strip's width or L0; where a value
/// vanishes because of a logarithm or of terms that cancel, relative to the sum of the absolute
/// terms. tests/digits/kernel_test.cpp

/// The half-space loaded over a strip of finite width, observed on its centre line.
/// Boussinesq-Cerruti, integrated over the width \f$\Delta y=2h\f$: thesis (10.3), (10.4),
/// \f[ K(z)=\frac{2(1-\nu)}{\pi G}\,\operatorname{arsinh}\frac hz
///        +\frac{2\nu}{\pi G}\,\frac{h}{\sqrt{z^2+h^2}} \f]
class StripKernel {
 public:
  /// \param width  strip width Dy, in (0, inf)  [mm]
  /// \throws std::invalid_argument outside the ranges
  StripKernel(const Material& material, double width);

  double displacement(double z) const;
  double decay(double z) const;
  std::complex<double> decay(std::complex<double> z) const;
  double regular_displacement(double z) const;
  double regular_decay(double z) const;
  double integral(double z) const;         ///< of K, from 0; odd in z
  double double_integral(double z) const;  ///< of the integral, from 0; even in z
  double clear_distance() const { return half_width_; }
  double width() const { return 2 * half_width_; }
  const Material& material() const { return material_; }

 private:
  Material material_;
  double half_width_;
  double log_factor_;    ///< 2 (1 - nu) / (pi G)
  double plain_factor_;  ///< 2 nu / (pi G)
};

/// Plane strain: \f$ K(z) = -\frac{2(1-\nu)}{\pi G}\,\ln\frac{z}{L_0} \f$. This is the limit of a
/// strip's kernel for the width Dy -> inf and L0 = Dy exp(nu / (1 - nu)); the difference falls as
/// Dy^-2 (tests/unit/kernel_test.cpp).
class PlaneKernel {
 public:
  /// \param length  L0, the distance at which the displacement is taken as zero, in (0, inf)  [mm]
  /// \throws std::invalid_argument outside the ranges
  PlaneKernel(const Material& material, double length);

  double displacement(double z) const;
  double decay(double z) const;
  std::complex<double> decay(std::complex<double> z) const;
  double regular_displacement(double z) const;
  double regular_decay(double z) const;
  double integral(double z) const;         ///< of K, from 0; odd in z
  double double_integral(double z) const;  ///< of the integral, from 0; even in z
  double clear_distance() const;
  double length() const { return length_; }
  const Material& material() const { return material_; }

 private:
  Material material_;
  double length_;
  double factor_;  ///< 2 (1 - nu) / (pi G)
};

using Kernel = std::variant<StripKernel, PlaneKernel>;

const Material& material_of(const Kernel& kernel);

/// Factor of the logarithm at z = 0, 2 (1 - nu) / (pi G)  [mm^2/N]
double log_factor(const Kernel& kernel);

/// The half-length below which the kernel is positive definite: any tractions on a shorter interval
/// have a positive elastic energy. The limit is infinite for a strip, because the kernel falls and
/// is convex. In plane strain the limit is 2 L0, where the logarithmic capacity of the interval,
/// half its half-length, is L0  [mm]
double definite_half_length(const Kernel& kernel);

/// K(length z) as a function of z: the kernel with the strip's width or L0 divided by `length`.
/// \param length  in (0, inf)  [1]
Kernel in_units_of(const Kernel& kernel, double length);

/// Distance of the regular functions' nearest singularity from the real axis  [mm]
double clear_distance(const Kernel& kernel);

}  // namespace microslip
