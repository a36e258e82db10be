// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/safe_ranges.hpp"

#include <algorithm>
#include <limits>
#include <variant>

namespace microslip {

namespace {

constexpr double any = std::numeric_limits<double>::infinity();

}  // namespace

SafeRange safe_elements(const Basis& basis) {
  if (basis.name() == "constant") return {11, any};
  return {basis.name() == "quadratic" ? 51.0 : 21.0, any};
}

SafeRange safe_steps(const AdvectionScheme& scheme) {
  struct Steps {
    SafeRange operator()(const MaterialFixed&) const { return {0, any}; }
    SafeRange operator()(const Direct&) const { return {0.5, 1.3}; }
    SafeRange operator()(const Relaxed&) const { return {0.01, 1.3}; }
    SafeRange operator()(const RelaxedTraction&) const { return {0.01, 1.3}; }
    SafeRange operator()(const Fractional&) const { return {1, 1}; }
  };
  return std::visit(Steps{}, scheme);
}

double least_step_under_force(const AdvectionScheme& scheme, Eigen::Index elements) {
  const auto n = static_cast<double>(elements);
  return std::holds_alternative<MaterialFixed>(scheme) ? std::max(1e-12 * n, 1e-9) : 1e-13 * n;
}

}  // namespace microslip
