// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem.hpp"

#include <fmt/core.h>

#include <numbers>
#include <stdexcept>
#include <string>

#include "microslip/halfspace/material_doubts.hpp"
#include "microslip/rolling/large_creepage.hpp"
#include "microslip/support/require.hpp"
#include "status.hpp"

namespace microslip::capi {

namespace {

using Eigen::VectorXd;

TractionBound make_bound(const microslip_contact& contact) {
  const auto rows = static_cast<double>(contact.bound_rows);
  if (contact.bound_x == nullptr && contact.bound_value == nullptr) {
    require(contact.bound_rows == 0, "bound_rows", rows, "0 without a table of the bound");
    return HertzBound(contact.half_width, contact.peak_traction);
  }
  require_pointer(contact.bound_x, "bound_x");
  require_pointer(contact.bound_value, "bound_value");
  require(contact.bound_rows > 0, "bound_rows", rows, "at least one row of the table");
  require(contact.peak_traction == 0, "peak_traction", contact.peak_traction,
          "0 with a table of the bound");
  const auto column = [&](const double* values) -> VectorXd {
    return Eigen::Map<const VectorXd>(values, static_cast<Eigen::Index>(contact.bound_rows));
  };
  try {
    return TabulatedBound(contact.half_width, column(contact.bound_x), column(contact.bound_value));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("contact, table of the bound: {}", error.what()));
  }
}

Kernel make_kernel(const Material& given, const microslip_kernel& kernel) {
  require(kernel.type >= MICROSLIP_STRIP && kernel.type <= MICROSLIP_PLANE_LATERAL, "kernel type",
          kernel.type,
          "0 for a strip, 1 for plane strain, 2 or 3 for these with loads across the rolling");
  require_positive("length", kernel.length);
  validate(given);
  const bool is_lateral =
      kernel.type == MICROSLIP_STRIP_LATERAL || kernel.type == MICROSLIP_PLANE_LATERAL;
  const Material material = is_lateral ? lateral(given) : given;
  if (kernel.type == MICROSLIP_STRIP || kernel.type == MICROSLIP_STRIP_LATERAL) {
    return StripKernel(material, kernel.length);
  }
  return PlaneKernel(material, kernel.length);
}

AdvectionScheme make_scheme(int scheme) {
  require(scheme == MICROSLIP_REMEMBERED || scheme == MICROSLIP_DIRECT, "scheme", scheme,
          "0 for remembered or 1 for direct");
  if (scheme == MICROSLIP_DIRECT) return Direct{};
  return Remembered{};
}

}  // namespace

TransientProblem make_problem(const microslip_material& material, const microslip_contact& contact,
                              const microslip_kernel& kernel, const microslip_grid& grid) {
  const TractionBound bound = make_bound(contact);
  return {.contact = {make_kernel({.shear_modulus = material.shear_modulus,
                                   .poisson_ratio = material.poisson_ratio},
                                  kernel),
                      bound},
          .grid = Grid({.half_width = contact.half_width, .elements = grid.elements}),
          .basis = constant_basis(),
          .scheme = make_scheme(grid.scheme)};
}

TransientProblem make_problem(const microslip_material& material, const microslip_unlike& unlike,
                              const microslip_contact& contact, const microslip_kernel& kernel,
                              const microslip_grid& grid) {
  const auto [beta, friction] = unlike;
  require(beta >= -0.5 && beta <= 0.5, "dundurs_beta", beta, "a number in [-0.5, 0.5]");
  require(friction > 0 && friction <= 10, "friction", friction, "a number above 0, at most 10");
  require(beta == 0 || kernel.type == MICROSLIP_PLANE, "kernel type", kernel.type,
          "1, plane strain, for bodies of different material");
  TransientProblem problem = make_problem(material, contact, kernel, grid);
  problem.contact.pressure_strain =
      pressure_strain({problem.contact.kernel.material(), beta}, friction);
  problem.contact.coupling = beta * friction;
  return problem;
}

SteadyProblem make_steady_problem(const microslip_material& material,
                                  const microslip_contact& contact, const microslip_kernel& kernel,
                                  int elements) {
  const TractionBound bound = make_bound(contact);
  return {.contact = {make_kernel({.shear_modulus = material.shear_modulus,
                                   .poisson_ratio = material.poisson_ratio},
                                  kernel),
                      bound},
          .grid = Grid({.half_width = contact.half_width, .elements = elements}),
          .load = PrescribedCreepage{0}};
}

std::string doubt_of_units(const microslip_material& material, double peak) {
  const double modulus = material.shear_modulus;
  std::string doubt = doubt_of_modulus(modulus, peak);
  if (doubt.empty()) doubt = doubt_of_strain(peak, modulus);
  return doubt.empty() ? doubt : doubt + "; numbers are in N, mm and N/mm^2";
}

std::string doubt_of_units(const microslip_material& material, const TractionBound& bound) {
  return doubt_of_units(material, 4 / std::numbers::pi * bound_strain(bound, 1));  // as Hertz's
}

}  // namespace microslip::capi
