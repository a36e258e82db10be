// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "microslip/friction/load.hpp"
#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/kernel.hpp"

namespace microslip {

/// Two bodies that touch on a line: how they yield to tractions, and the tractions that friction
/// allows. If the bodies differ in material, the pressure displaces them along the line, too: du/dx
/// has the term pressure_strain times the bound.
struct Contact {
  // A constructor, because GCC 12 destroys an aggregate within an aggregate twice if the value of a
  // later member throws.
  Contact(Kernel of_kernel, TractionBound of_bound, double strain_by_pressure = 0,
          double order_of_coupling = 0)
      : kernel(std::move(of_kernel)),
        bound(std::move(of_bound)),
        pressure_strain(strain_by_pressure),
        coupling(order_of_coupling) {}

  Kernel kernel;
  TractionBound bound;
  double pressure_strain;  ///< microslip::pressure_strain(), for PlaneKernel  [mm^2/N]
  /// beta mu, the order of the changes of pressure that Goodman's approximation leaves out  [1]
  double coupling;

  bool has_unlike_bodies() const { return pressure_strain != 0; }
};

/// \throws std::invalid_argument for bodies of different material, if the strain by the pressure is
///         not local, as in strips
void validate(const Contact& contact);

/// A contact that rolls steadily, without a method or a grid.
struct SteadyContact : Contact {
  Load load;
};

}  // namespace microslip
