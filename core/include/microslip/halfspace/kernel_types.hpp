// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <complex>
#include <concepts>
#include <limits>
#include <optional>
#include <string_view>
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

/// Calls use(name, value) with each number of a material.
void each_parameter_of(const Material& material, const auto& use) {
  use("material.shear_modulus", material.shear_modulus);
  use("material.poisson_ratio", material.poisson_ratio);
}

/// Traits that most kernels share. A kernel replaces those in which it differs.
struct CommonKernelTraits {
  static bool spreads() { return true; }
  static double layer_compliance() { return 0; }
  static double definite_half_length() { return std::numeric_limits<double>::infinity(); }
  static double least_wave_number() { return 0; }
  static double largest_wave_number() { return 0; }
  static std::optional<double> plane_length() { return std::nullopt; }
};

/// The traits that every kernel has as members; class Kernel states their meanings.
template <class K>
concept KernelTraits = requires(const K& kernel, double z) {
  { kernel.name() } -> std::convertible_to<std::string_view>;
  { kernel.displacement(z) } -> std::same_as<double>;
  { kernel.decay(z) } -> std::same_as<double>;
  { kernel.clear_distance() } -> std::same_as<double>;
  { kernel.in_units_of(z) } -> std::same_as<K>;
  { kernel.log_factor() } -> std::same_as<double>;
  { kernel.spreads() } -> std::same_as<bool>;
  { kernel.layer_compliance() } -> std::same_as<double>;
  { kernel.definite_half_length() } -> std::same_as<double>;
  { kernel.least_wave_number() } -> std::same_as<double>;
  { kernel.largest_wave_number() } -> std::same_as<double>;
  { kernel.plane_length() } -> std::same_as<std::optional<double>>;
  kernel.each_parameter([](const char*, const auto&) {});
};

/// A kernel of a half-space alone. It has the regular functions and integrals, too, and thereby an
/// inversion.
template <class K>
concept HalfSpaceKernel = KernelTraits<K> && requires(const K& kernel, double z) {
  { kernel.regular_displacement(z) } -> std::same_as<double>;
  { kernel.regular_decay(z) } -> std::same_as<double>;
  { kernel.integral(z) } -> std::same_as<double>;
  { kernel.double_integral(z) } -> std::same_as<double>;
  { kernel.material() } -> std::same_as<const Material&>;
};

/// The half-space loaded over a strip of finite width, observed on its centre line.
/// Boussinesq-Cerruti, integrated over the width \f$\Delta y=2h\f$: thesis (10.3), (10.4),
/// \f[ K(z)=\frac{2(1-\nu)}{\pi G}\,\operatorname{arsinh}\frac hz
///        +\frac{2\nu}{\pi G}\,\frac{h}{\sqrt{z^2+h^2}} \f]
class StripKernel : public CommonKernelTraits {
 public:
  /// \param width  strip width Dy, in (0, inf)  [mm]
  /// \throws std::invalid_argument outside the ranges
  StripKernel(const Material& material, double width);

  static std::string_view name() { return "strip"; }
  double displacement(double z) const;
  double decay(double z) const;
  std::complex<double> decay(std::complex<double> z) const;
  double regular_displacement(double z) const;
  double regular_decay(double z) const;
  double integral(double z) const;         ///< of K, from 0; odd in z
  double double_integral(double z) const;  ///< of the integral, from 0; even in z
  double clear_distance() const { return half_width_; }
  double log_factor() const { return log_factor_; }
  StripKernel in_units_of(double length) const { return {material_, width() / length}; }
  double width() const { return 2 * half_width_; }
  const Material& material() const { return material_; }
  void each_parameter(const auto& use) const {
    use("kernel.width", width());
    each_parameter_of(material_, use);
  }

 private:
  Material material_;
  double half_width_;
  double log_factor_;    ///< 2 (1 - nu) / (pi G)
  double plain_factor_;  ///< 2 nu / (pi G)
};

/// Plane strain: \f$ K(z) = -\frac{2(1-\nu)}{\pi G}\,\ln\frac{z}{L_0} \f$. This is the limit of a
/// strip's kernel for the width Dy -> inf and L0 = Dy exp(nu / (1 - nu)); the difference falls as
/// Dy^-2 (tests/unit/kernel_test.cpp).
class PlaneKernel : public CommonKernelTraits {
 public:
  /// \param length  L0, the distance at which the displacement is taken as zero, in (0, inf)  [mm]
  /// \throws std::invalid_argument outside the ranges
  PlaneKernel(const Material& material, double length);

  static std::string_view name() { return "plane"; }
  double displacement(double z) const;
  double decay(double z) const;
  std::complex<double> decay(std::complex<double> z) const;
  double regular_displacement(double z) const;
  double regular_decay(double z) const;
  double integral(double z) const;         ///< of K, from 0; odd in z
  double double_integral(double z) const;  ///< of the integral, from 0; even in z
  static double clear_distance() { return std::numeric_limits<double>::infinity(); }
  double log_factor() const { return log_factor_; }
  double definite_half_length() const { return 2 * length_; }
  PlaneKernel in_units_of(double length) const { return {material_, length_ / length}; }
  double length() const { return length_; }
  std::optional<double> plane_length() const { return length_; }
  const Material& material() const { return material_; }
  void each_parameter(const auto& use) const {
    use("kernel.length", length_);
    each_parameter_of(material_, use);
  }

 private:
  Material material_;
  double length_;
  double log_factor_;  ///< 2 (1 - nu) / (pi G)
};

/// Springs beside one another, a brush or Winkler's foundation: u = C p at the same place, and
/// nothing elsewhere. FASTSIM's kernel.
class WinklerKernel : public CommonKernelTraits {
 public:
  /// \param compliance  C, in (0, inf)  [mm^3/N]
  /// \throws std::invalid_argument outside the range
  explicit WinklerKernel(double compliance);

  static std::string_view name() { return "winkler"; }
  static double displacement(double) { return 0; }
  static double decay(double) { return 0; }
  static double clear_distance() { return std::numeric_limits<double>::infinity(); }
  static double log_factor() { return 0; }
  static bool spreads() { return false; }
  double layer_compliance() const { return compliance_; }
  WinklerKernel in_units_of(double length) const { return WinklerKernel(compliance_ / length); }
  void each_parameter(const auto& use) const { use("kernel.compliance", compliance_); }

 private:
  double compliance_;
};

/// A Winkler layer in series with a half-space, such as a third body between the surfaces: the
/// displacement is the half-space's plus C p.
class LayeredKernel : public CommonKernelTraits {
 public:
  using HalfSpace = std::variant<StripKernel, PlaneKernel>;

  /// \param compliance  C, in (0, inf)  [mm^3/N]
  /// \throws std::invalid_argument outside the range
  LayeredKernel(const HalfSpace& half_space, double compliance);

  std::string_view name() const;        ///< "strip with a layer" or "plane with a layer"
  double displacement(double z) const;  ///< of the half-space, z > 0
  double decay(double z) const;
  double clear_distance() const;
  double log_factor() const;
  double definite_half_length() const;
  double layer_compliance() const { return compliance_; }
  LayeredKernel in_units_of(double length) const;
  const HalfSpace& half_space() const { return half_space_; }
  const Material& material() const;
  void each_parameter(const auto& use) const {
    std::visit([&](const auto& of) { of.each_parameter(use); }, half_space_);
    use("kernel.compliance", compliance_);
  }

 private:
  HalfSpace half_space_;
  double compliance_;
};

/// A kernel by its symbol K^, the displacement over the traction of a wave p cos(kappa x); the
/// symbol of a kernel K is \f$ \hat K(\kappa)=\int K(z)\cos(\kappa z)\,dz \f$. Plane strain has
/// \f$ \pi k/\kappa \f$ with k = 2 (1 - nu)/(pi G), and a Winkler layer adds C.
///
/// Between the rows of a table, kappa K^ is linear, so that these two and their sum are exact. From
/// the last row on, it goes on as between the last two: a half-space and a layer, pi k + C kappa;
/// as a half-space alone where kappa K^ falls there, and as a layer alone where K^ rises.
/// Before the first row K^ keeps its first value, so that K vanishes far away: the bodies are of
/// finite thickness. With \f$ \Psi(\theta)=\sin\theta/\theta-\mathrm{Ci}(\theta) \f$ and the
/// changes of slope of kappa K^ at the rows as its factors, the kernel has a closed form,
/// \f[ u=C\,p+\int K\,p\,d\xi,\quad K(z)=\sum_n k_n\,\Psi(\kappa_n z), \quad \sum_n k_n=k . \f]
/// A half-space from kappa_1 on is therefore, at distances z << 1/kappa_1, plane strain with L0 =
/// exp(1 - 0.5772)/kappa_1, except for terms of the order of (kappa_1 z)^2.
///
/// K^ > 0 is all that makes a kernel positive definite, on any interval.
class SymbolKernel : public CommonKernelTraits {
 public:
  static constexpr Eigen::Index most_rows = 1000;

  /// \param wave_numbers  kappa, > 0, rising, 2 to most_rows  [1/mm]
  /// \param symbol        K^ there, > 0; in the last two rows it falls no faster than kappa^-1.5,
  ///                      and rises no faster than kappa^0.5  [mm^3/N]
  /// \throws std::invalid_argument for others
  SymbolKernel(const Eigen::VectorXd& wave_numbers, const Eigen::VectorXd& symbol);

  static std::string_view name() { return "symbol"; }
  double displacement(double z) const;  ///< K without the layer, z > 0
  double decay(double z) const;
  static double clear_distance() { return std::numeric_limits<double>::infinity(); }
  double log_factor() const { return log_factor_; }        ///< k  [mm^2/N]
  double layer_compliance() const { return compliance_; }  ///< C  [mm^3/N]
  double least_wave_number() const { return wave_numbers_[0]; }
  double largest_wave_number() const { return bends_.size() == 0 ? 0 : bends_[bends_.size() - 1]; }
  SymbolKernel in_units_of(double length) const;
  double symbol(double wave_number) const;
  const Eigen::VectorXd& wave_numbers() const { return wave_numbers_; }
  const Eigen::VectorXd& symbols() const { return symbol_; }
  void each_parameter(const auto& use) const {
    use("wave_number", wave_numbers_);
    use("symbol", symbol_);
  }

 private:
  Eigen::VectorXd wave_numbers_, symbol_;
  Eigen::ArrayXd bends_;    ///< the wave numbers where kappa K^ changes its slope  [1/mm]
  Eigen::ArrayXd factors_;  ///< k_i of these  [mm^2/N]
  double log_factor_ = 0, compliance_ = 0;
};

static_assert(HalfSpaceKernel<StripKernel> && HalfSpaceKernel<PlaneKernel>);
static_assert(KernelTraits<WinklerKernel> && KernelTraits<LayeredKernel>);
static_assert(KernelTraits<SymbolKernel>);

}  // namespace microslip
