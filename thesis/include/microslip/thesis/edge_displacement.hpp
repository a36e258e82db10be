// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/halfspace/kernel.hpp"
#include "microslip/reference/carter.hpp"

namespace microslip {

/// u_LE: displacement at the leading edge under Carter's traction, thesis (10.5) at x = a.
/// For a strip, Carter's traction is not the solution; this is the displacement it would cause.
/// Accuracy: 1e-14 relative, for a stick zone of 1e-9 of the contact to 1e-12 less than all of it
/// and strips from 0.01 a. In plane strain the error is relative to 2 (1 - nu)/G peak a (1 - a'),
/// times the logarithm of 2 L0/a where that is more than 1. tests/digits/closed_form_test.cpp
/// \return  u_LE  [mm]
/// \throws NotConverged if the quadrature fails
double edge_displacement(const Kernel& kernel, const Carter& carter);

}  // namespace microslip
