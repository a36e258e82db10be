// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "microslip/halfspace/kernel_types.hpp"

namespace microslip {

/// A kernel of any type. It asks its type for each trait, so that no other source has to know the
/// types: a new kernel is a class with these members (concept KernelTraits), and an entry in the
/// list below.
class Kernel {
  using AnyType =
      std::variant<StripKernel, PlaneKernel, WinklerKernel, LayeredKernel, SymbolKernel>;

 public:
  template <KernelTraits K>
  Kernel(const K& kernel)  // NOLINT: every kernel is a Kernel
      : kernel_(kernel) {}

  /// Calls a function with the kernel as its own type.
  template <class Function>
  decltype(auto) visit(Function&& function) const {
    return std::visit(std::forward<Function>(function), kernel_);
  }

  /// "strip", "plane", "winkler", "symbol", or "strip with a layer", "plane with a layer"
  std::string_view name() const;

  /// K(z) without the layer, z > 0  [mm^2/N]
  double displacement(double z) const;

  /// Distance of the nearest singularity of the regular functions from the real axis; for kernels
  /// without these, the length of a panel at z = 0 on which 15 Gauss points integrate z times the
  /// decay to rounding  [mm]
  double clear_distance() const;

  /// Factor k of the logarithm at z = 0, of a half-space 2 (1 - nu) / (pi G), and 0 if there is
  /// none [mm^2/N]
  double log_factor() const;

  /// C of a Winkler layer; 0 if there is none  [mm^3/N]
  double layer_compliance() const;

  /// Whether a traction displaces other places than its own: not in a brush.
  bool spreads() const;

  /// The half-length below which the kernel is positive definite: any tractions on a shorter
  /// interval have a positive elastic energy. The limit is infinite for a strip, because the kernel
  /// falls and is convex. In plane strain the limit is 2 L0, where the logarithmic capacity of the
  /// interval, half its half-length, is L0. A layer only adds energy  [mm]
  double definite_half_length() const;

  /// The wave numbers between which a table gives the symbol; 0 where there is no table. Below the
  /// first, the symbol is constant; the decay has waves up to the second  [1/mm]
  double least_wave_number() const;
  double largest_wave_number() const;

  /// K(length z) as a function of z: the kernel with the strip's width or L0 divided by `length`;
  /// and a layer's compliance, as the kernel of a layer is a delta function.
  /// \param length  in (0, inf)  [1]
  Kernel in_units_of(double length) const;

  /// L0 of plane strain without a layer, none for other kernels. Plane strain has no other length:
  /// in other units it differs by a constant displacement  [mm]
  std::optional<double> plane_length() const;
  bool is_plane() const { return plane_length().has_value(); }

  /// Whether the kernel is of a half-space alone: a strip or plane strain.
  bool is_half_space() const;

  /// Whether the kernel is of a half-space, with or without a layer.
  bool has_material() const { return find_material() != nullptr; }

  /// \throws std::logic_error for a kernel without a half-space
  const Material& material() const;

  /// The half-space of the kernel without its layer; a kernel without a layer stays as it is.
  Kernel without_layer() const;

  /// Calls use(name, value) with each number or vector that defines the kernel, and its name.
  void each_parameter(const auto& use) const {
    visit([&use](const auto& k) { k.each_parameter(use); });
  }

 private:
  const Material* find_material() const;

  AnyType kernel_;
};

/// \param who  that takes half-spaces alone, for the message
/// \throws BadParameter for other kernels
void require_half_space(const Kernel& kernel, std::string_view who);

/// Calls a function with the strip or plane strain. \throws BadParameter for other kernels
template <class Function>
decltype(auto) visit_half_space(const Function& function, const Kernel& kernel) {
  return kernel.visit([&]<class K>(const K& of) -> std::invoke_result_t<Function, PlaneKernel> {
    if constexpr (HalfSpaceKernel<K>) {
      return function(of);
    } else {
      require_half_space(kernel, "this method");
      throw std::logic_error("a half-space");
    }
  });
}

}  // namespace microslip
