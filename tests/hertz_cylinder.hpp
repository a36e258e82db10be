// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "microslip/dynamics/cylinder.hpp"

namespace microslip {

/// A cylinder on Hertz's bound with a = 1 and the peak 1, plane strain with L0 = 10.
inline RollingCylinder hertz_cylinder(const Material& material, Eigen::Index elements,
                                      const AdvectionScheme& scheme, const Cylinder& body,
                                      Integrator integrator, double step_ratio,
                                      std::optional<double> tolerance) {
  return {{.contact = {PlaneKernel(material, 10), HertzBound(1, 1)},
           .grid = Grid({.half_width = 1, .elements = elements}),
           .basis = constant_basis(),
           .scheme = scheme},
          body,
          integrator,
          step_ratio,
          tolerance};
}

}  // namespace microslip
