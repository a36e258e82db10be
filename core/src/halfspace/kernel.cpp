// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/kernel.hpp"

#include <fmt/core.h>

#include "microslip/support/require.hpp"

namespace microslip {

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
