// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <variant>

#include "microslip/friction/active_set.hpp"
#include "microslip/halfspace/basis.hpp"
#include "microslip/halfspace/kernel.hpp"
#include "microslip/linalg/linear_operator.hpp"
#include "microslip/linalg/solver.hpp"
#include "microslip/rolling/fractional_shift.hpp"

namespace microslip {

/// \file
/// How u' = A' p', the previous displacement at the place where the material was one step earlier,
/// is taken from the previous tractions p'.

/// A' at the nodes moved upstream by c dx: thesis (3.13).
struct Direct {};

/// A' = (1 - c/c*) A + (c/c*) A'(c*): thesis (7.1), under-relaxation of the influence coefficients.
struct Relaxed {
  double step_ratio;  ///< c*, >= c
};

/// p = (1 - c/c*) p' + (c/c*) p*, where p* follows from a direct step of c*: thesis (7.10),
/// under-relaxation of the tractions. A prescribed force is the force of p*.
struct RelaxedTraction {
  double step_ratio;  ///< c*, >= c
};

/// A' = A (A^-1 A'(1))^c: thesis (8.4). For equal functions on an odd number of nodes.
struct Fractional {};

/// u' is the displacement that the material remembers since it entered the contact. Steps within
/// an element leave no trace, and the stick-slip point lies anywhere within an element.
/// docs/theory.md. For constant functions that fill the contact.
struct Remembered {};

using AdvectionScheme = std::variant<Direct, Relaxed, RelaxedTraction, Fractional, Remembered>;

/// Makes the offsets of a step's slip conditions from the previous tractions, by a scheme.
class Advection {
 public:
  /// \param spacing   dx, in (0, inf)  [mm]
  /// \param elements  n
  /// \throws std::invalid_argument if the scheme does not go with the basis or the grid
  Advection(Kernel kernel, Basis basis, double spacing, Eigen::Index elements,
            AdvectionScheme scheme, const Solver& solver = {});

  /// A p - A' p' as offset + A (p - reference), without cancellation for small steps.
  /// \param previous    p'  [N/mm^2]
  /// \param step_ratio  c, >= min_step_ratio; for `Relaxed` and `RelaxedTraction` at most c*
  /// \param conditions  out: its offset [mm] and reference [N/mm^2]
  /// \throws std::invalid_argument outside the range
  /// Cost: a product, and new coefficients when c changes in the direct scheme; `Fractional` see
  /// there. Where c stays nothing is allocated, except by `Fractional`.
  void advect(const Eigen::VectorXd& previous, double step_ratio, SlipConditions& conditions);

  /// The part of a step of `solved_step_ratio` that a step of c takes: c/c* for `RelaxedTraction`,
  /// 1 for others.
  double fraction(double step_ratio) const;

  /// The step for which tractions are to be solved: c* for `RelaxedTraction`, c for others.
  double solved_step_ratio(double step_ratio) const;

 private:
  void advect_directly(const Eigen::VectorXd& previous, double step_ratio, double part,
                       SlipConditions& conditions);

  Kernel kernel_;
  Basis basis_;
  double spacing_;
  Eigen::Index elements_;
  AdvectionScheme scheme_;
  Solver solver_;
  std::optional<FractionalShift> shift_;
  double difference_step_ratio_ = 0;
  std::optional<LinearOperator> difference_;  ///< A - A' at that step ratio
};

}  // namespace microslip
