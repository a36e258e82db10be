// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/halfspace/kernel.hpp"
#include "microslip/reference/carter.hpp"

namespace microslip {

/// u_LE: displacement at the leading edge under Carter's traction, thesis (10.5) at x = a.
/// For a strip, Carter's traction is not the solution; this is the displacement it would cause.
/// \return  [mm]
/// Accuracy: 1e-12 relative, tests/unit/edge_displacement_test.cpp
/// \throws NotConverged if the quadrature fails
double edge_displacement(const Kernel& kernel, const Carter& carter);

}  // namespace microslip
