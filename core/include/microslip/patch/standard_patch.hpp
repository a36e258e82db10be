// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "microslip/friction/elliptic_bound.hpp"
#include "microslip/halfspace/material.hpp"
#include "microslip/patch/patch_load.hpp"
#include "microslip/patch/rectangles.hpp"

namespace microslip {

/// Half-spaces of one material touch in an ellipse, which is cut into equal rectangles.
struct StandardPatch {
  /// How the traction bound of an element follows from Hertz's.
  enum class Pressure {
    computed,  ///< by the pressure of rectangles, which also decides which of them touch
    hertz      ///< Hertz's at the centres; the rectangles with centres in the ellipse touch
  };

  Material material;  ///< poisson_ratio in [0, 0.5]
  EllipticBound bound;
  Eigen::Index elements;  ///< N, in the width 2 a along the rolling, >= 1
  Eigen::Index rows;      ///< M, in the width 2 b across, >= 1
  Pressure pressure = Pressure::computed;
  double relaxation = 0;  ///< c*, at least dq/dx of each step; 0 without under-relaxation

  static constexpr double largest_relaxation = 1e6;
};

/// The standard scheme of rolling in three dimensions, which is CONTACT's: tractions are constant
/// in equal rectangles, and slip is at their centres. In a step over dq
///   s = w + [u(x) - u'(x + dq)]/dq,  w = (xi - phi y, eta + phi (x + dq/6)),
/// with the displacements u' of the tractions before it; steady rolling is a step over an element
/// with u' = u. With under-relaxation, thesis (7.1), the place of u'(x + dq) is taken by
///   (1 - dq/(c* dx)) u'(x) + dq/(c* dx) u'(x + c* dx).
/// In a shift without rolling, s = w + u(x) - u'(x), with the lengths w = (xi - phi y,
/// eta + phi x). An element sticks or slips by Coulomb's law, each by this slip of its own.
///
/// Motions and resultants are 0, or 1e-100 to 1e100 times those by the bound's strain. Tractions have
/// errors of 1e-9 of the bound's peak, and of 1e-3 of themselves where they are smaller.
///
/// With Pressure::computed, forces are those of CONTACT v25.2 to nine digits, and the same elements
/// slip: tests/unit/standard_patch_test.cpp. The scheme is of first order in the element.
///
/// A step that throws leaves all as it was before. One object serves one thread.
class RectangleRolling {
 public:
  using Index = Eigen::Index;

  /// Begins without tractions.
  /// \throws std::invalid_argument if a number is out of its range; NotConverged if the pressure is
  ///         not found
  explicit RectangleRolling(const StandardPatch& problem);
  ~RectangleRolling();
  RectangleRolling(RectangleRolling&&) noexcept;
  RectangleRolling& operator=(RectangleRolling&&) noexcept;

  /// Begins anew under tractions.
  /// \param tractions  along and across, at the centres; above the bound by rounding at most [N/mm^2]
  /// \throws std::invalid_argument for another number of elements, and above the bound
  void start_from(const Eigen::MatrixX2d& tractions);

  /// Shifts the bodies without rolling.
  /// \param load  shifts of the first body [mm] and its rotation [rad] in the place of motions, or
  ///              resultants
  /// \throws std::invalid_argument as validate(SteadyPatch); NotConverged
  void shift(const PatchLoad& load);

  /// Rolls over a step.
  /// \param dq  [mm], in [1e-50, 1e50]; at most c* dx with under-relaxation
  /// \throws std::invalid_argument if a number is out of its range; NotConverged
  void roll(double dq, const PatchLoad& load);

  /// Rolls until the state is steady, whatever it was before.
  /// \throws std::invalid_argument as validate(SteadyPatch); NotConverged
  void roll_steadily(const PatchLoad& load);

  Index size() const;                  ///< number of elements
  Eigen::VectorXd x() const;           ///< of their centres  [mm]
  Eigen::VectorXd y() const;           ///< [mm]
  double area() const;                 ///< of an element  [mm^2]
  double element() const;              ///< dx, the length of an element along the rolling  [mm]
  Eigen::VectorXd bound() const;       ///< [N/mm^2]
  Eigen::MatrixX2d tractions() const;  ///< along and across  [N/mm^2]
  Eigen::MatrixX2d slip() const;       ///< [1]; by a shift [mm]; 0 where an element sticks
  const std::vector<bool>& slips() const;
  Eigen::Vector3d resultants() const;  ///< Fx, Fy [N], Mz about the centre [N mm]
  /// xi, eta [1] and phi [1/mm], as means over the step; of a shift in [mm] and [rad]
  Eigen::Vector3d motion() const;
  /// Energy that friction dissipates by the tractions at the end of the step, over the distance
  /// rolled [N]; in a shift, the energy [N mm]
  double dissipation() const;

  int iterations() const;   ///< systems that the last step took
  double residual() const;  ///< largest error of the slip conditions, over mu p0  [1]

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Resultants by the motion where all sticks in steady rolling, by the same scheme: -C11, -C22,
/// -C23, C32 and -C33 of Kalker, as PatchResponse::linear().
/// \param poisson_ratio  nu, in [0, 0.5]
/// Accuracy: 1e-10, over the size of the ellipse with a b = 1.
Eigen::Matrix3d linear_response(const Rectangles& rectangles, double poisson_ratio);

}  // namespace microslip
