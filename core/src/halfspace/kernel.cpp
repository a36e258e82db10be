// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/kernel.hpp"

#include <fmt/core.h>

#include "microslip/support/require.hpp"

namespace microslip {

std::string_view Kernel::name() const {
  return visit([](const auto& k) -> std::string_view { return k.name(); });
}

double Kernel::displacement(double z) const {
  return visit([z](const auto& k) { return k.displacement(z); });
}

double Kernel::clear_distance() const {
  return visit([](const auto& k) { return k.clear_distance(); });
}

double Kernel::log_factor() const {
  return visit([](const auto& k) { return k.log_factor(); });
}

double Kernel::layer_compliance() const {
  return visit([](const auto& k) { return k.layer_compliance(); });
}

bool Kernel::spreads() const {
  return visit([](const auto& k) { return k.spreads(); });
}

double Kernel::definite_half_length() const {
  return visit([](const auto& k) { return k.definite_half_length(); });
}

double Kernel::least_wave_number() const {
  return visit([](const auto& k) { return k.least_wave_number(); });
}

double Kernel::largest_wave_number() const {
  return visit([](const auto& k) { return k.largest_wave_number(); });
}

Kernel Kernel::in_units_of(double length) const {
  return visit([length](const auto& k) { return Kernel(k.in_units_of(length)); });
}

std::optional<double> Kernel::plane_length() const {
  return visit([](const auto& k) -> std::optional<double> { return k.plane_length(); });
}

bool Kernel::is_half_space() const {
  return visit([]<class K>(const K&) { return HalfSpaceKernel<K>; });
}

const Material* Kernel::find_material() const {
  return visit([](const auto& k) -> const Material* {
    if constexpr (requires { k.material(); }) {
      return &k.material();
    } else {
      return nullptr;
    }
  });
}

const Material& Kernel::material() const {
  if (const Material* found = find_material()) return *found;
  throw std::logic_error("a kernel without a half-space has no material");
}

Kernel Kernel::without_layer() const {
  return visit([this](const auto& k) -> Kernel {
    if constexpr (requires { k.half_space(); }) {
      return std::visit([](const auto& half_space) { return Kernel(half_space); }, k.half_space());
    } else {
      return *this;
    }
  });
}

void require_half_space(const Kernel& kernel, std::string_view who) {
  if (kernel.is_half_space()) return;
  reject("kernel", kernel.name(), fmt::format("strip or plane without a layer for {}", who));
}

}  // namespace microslip
