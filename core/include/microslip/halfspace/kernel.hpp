// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <complex>
#include <string_view>
#include <variant>

#include "microslip/halfspace/material.hpp"
#include "microslip/support/require.hpp"

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

/// Springs beside one another, a brush or Winkler's foundation: u = C p at the same place, and
/// nothing elsewhere. FASTSIM's kernel.
class WinklerKernel {
 public:
  /// \param compliance  C, in (0, inf)  [mm^3/N]
  /// \throws std::invalid_argument outside the range
  explicit WinklerKernel(double compliance);

  double displacement(double) const { return 0; }
  double decay(double) const { return 0; }
  double clear_distance() const;
  double compliance() const { return compliance_; }

 private:
  double compliance_;
};

/// A Winkler layer in series with a half-space, such as a third body between the surfaces: the
/// displacement is the half-space's plus C p.
class LayeredKernel {
 public:
  using HalfSpace = std::variant<StripKernel, PlaneKernel>;

  /// \param compliance  C, in (0, inf)  [mm^3/N]
  /// \throws std::invalid_argument outside the range
  LayeredKernel(const HalfSpace& half_space, double compliance);

  double displacement(double z) const;  ///< of the half-space, z > 0
  double decay(double z) const;
  double clear_distance() const;
  double compliance() const { return compliance_; }
  const HalfSpace& half_space() const { return half_space_; }

 private:
  HalfSpace half_space_;
  double compliance_;
};

/// A kernel by its symbol K^, the displacement over the traction of a wave p cos(kappa x); the symbol
/// of a kernel K is \f$ \hat K(\kappa)=\int K(z)\cos(\kappa z)\,dz \f$. Plane strain has \f$ \pi k/\kappa
/// \f$ with k = 2 (1 - nu)/(pi G), and a Winkler layer adds C.
///
/// Between the rows of a table, kappa K^ is linear, so that these two and their sum are exact. From
/// the last row on, it goes on as between the last two: a half-space and a layer, pi k + C kappa; as
/// a half-space alone where kappa K^ falls there, and as a layer alone where K^ rises.
/// Before the first row K^ keeps its first value, so that K vanishes far away: the bodies are of
/// finite thickness. With \f$ \Psi(\theta)=\sin\theta/\theta-\mathrm{Ci}(\theta) \f$ and the changes of
/// slope of kappa K^ at the rows as its factors, the kernel has a closed form,
/// \f[ u=C\,p+\int K\,p\,d\xi,\quad K(z)=\sum_n k_n\,\Psi(\kappa_n z), \quad \sum_n k_n=k . \f]
/// A half-space from kappa_1 on is therefore, at distances z << 1/kappa_1, plane strain with L0 =
/// exp(1 - 0.5772)/kappa_1, except for terms of the order of (kappa_1 z)^2.
///
/// K^ > 0 is all that makes a kernel positive definite, on any interval.
class SymbolKernel {
 public:
  static constexpr Eigen::Index most_rows = 1000;

  /// \param wave_numbers  kappa, > 0, rising, 2 to most_rows  [1/mm]
  /// \param symbol        K^ there, > 0; in the last two rows it falls no faster than kappa^-1.5, and
  ///                      rises no faster than kappa^0.5  [mm^3/N]
  /// \throws std::invalid_argument for others
  SymbolKernel(const Eigen::VectorXd& wave_numbers, const Eigen::VectorXd& symbol);

  double displacement(double z) const;  ///< K without the layer, z > 0
  double decay(double z) const;
  double clear_distance() const;

  /// Gauss points integrate a panel of this length to rounding  [mm]
  double longest_panel() const;

  double log_factor() const { return log_factor_; }  ///< k  [mm^2/N]
  double compliance() const { return compliance_; }  ///< C  [mm^3/N]
  double symbol(double wave_number) const;
  const Eigen::VectorXd& wave_numbers() const { return wave_numbers_; }
  const Eigen::VectorXd& symbols() const { return symbol_; }

 private:
  Eigen::VectorXd wave_numbers_, symbol_;
  Eigen::ArrayXd bends_;    ///< the wave numbers where kappa K^ changes its slope  [1/mm]
  Eigen::ArrayXd factors_;  ///< k_i of these  [mm^2/N]
  double log_factor_ = 0, compliance_ = 0;
};

using Kernel = std::variant<StripKernel, PlaneKernel, WinklerKernel, LayeredKernel, SymbolKernel>;

/// "strip", "plane", "winkler", "symbol", or "strip with a layer", "plane with a layer"
std::string_view name_of(const Kernel& kernel);

/// Whether the kernel is of a half-space alone: a strip or plane strain.
bool is_half_space(const Kernel& kernel);

/// \param who  that takes half-spaces alone, for the message
/// \throws BadParameter for other kernels
void require_half_space(const Kernel& kernel, std::string_view who);

/// Calls a function with the strip or plane strain. \throws BadParameter for other kernels
template <class Function>
decltype(auto) visit_half_space(const Function& function, const Kernel& kernel) {
  if (const auto* strip = std::get_if<StripKernel>(&kernel)) return function(*strip);
  require_half_space(kernel, "this method");
  return function(std::get<PlaneKernel>(kernel));
}

/// \throws std::logic_error for a kernel without a half-space
const Material& material_of(const Kernel& kernel);

/// Factor k of the logarithm at z = 0, of a half-space 2 (1 - nu) / (pi G), and 0 if there is none
/// [mm^2/N]
double log_factor(const Kernel& kernel);

/// C of a Winkler layer; 0 if there is none  [mm^3/N]
double layer_compliance(const Kernel& kernel);

/// The half-length below which the kernel is positive definite: any tractions on a shorter interval
/// have a positive elastic energy. The limit is infinite for a strip, because the kernel falls and
/// is convex. In plane strain the limit is 2 L0, where the logarithmic capacity of the interval,
/// half its half-length, is L0. A layer only adds energy  [mm]
double definite_half_length(const Kernel& kernel);

/// K(length z) as a function of z: the kernel with the strip's width or L0 divided by `length`; and
/// a layer's compliance, as the kernel of a layer is a delta function.
/// \param length  in (0, inf)  [1]
Kernel in_units_of(const Kernel& kernel, double length);

/// Distance of the regular functions' nearest singularity from the real axis  [mm]
double clear_distance(const Kernel& kernel);

}  // namespace microslip
