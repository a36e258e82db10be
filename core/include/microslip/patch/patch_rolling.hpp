// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "microslip/patch/patch_load.hpp"
#include "microslip/patch/steady_patch.hpp"
#include "microslip/rolling/contact_scale.hpp"
#include "microslip/rolling/transient_problem.hpp"

namespace microslip {

/// Accepted steps and contacts of PatchRolling.
struct PatchStepRanges {
  /// dq over the size of the patch. Records that are closer have no digits of a slope between them.
  static constexpr double least_step = 1e-6, longest_step = 1e6;

  /// Motions over the strain mu p0/G, beside which displacements keep their digits.
  static constexpr double largest_motion = 1e8;

  /// Half-widths and bound of a contact over the problem's, if they are not 0.
  static constexpr double least_size = 1e-4, largest_size = 100;
  static constexpr double least_bound = 1e-6, largest_bound = 1e6;
};

/// The largest forces along and across, and the largest moment about x = y = 0, that friction
/// carries, each on its own  [N, N, N mm]
/// \param contact  over the problem's; of both half-widths, and of the bound
Eigen::Vector3d largest_resultants(const PatchBound& bound, const ContactScale& contact);

/// \throws std::invalid_argument unless friction carries the resultants of a load, which are 0 in a
///         contact that carries nothing, and for motions that are not finite
void require_carried(const PatchLoad& load, const PatchBound& bound, const ContactScale& contact);

/// A patch rolls by steps of any length. The material of each row remembers the sum of its
/// displacement and of all rigid slip so far, which does not change while it sticks. So tractions
/// that travel are not smeared, and short steps make no wiggles.
///
/// In a step over dq, the material at the centre of a cell comes from x + dq, or has entered on the
/// way. With m, its displacement before the step, its own slip is
///   t = w + [u(x) - m]/length,
/// w the mean rigid slip over the length that it rolled, which is dq or the distance to the leading
/// edge. It sticks by t = 0. It slips in the direction of the same slip of the material that passes
/// the centre in the middle of the step. As dq tends to 0, that is the slip at the centre of steady
/// rolling. Equations: docs/ellipse.md.
///
/// Bodies roll back by a step dq < 0, and turn as often as they like. The frame stays: x,
/// tractions, resultants and shifts keep their directions, and distance() goes back. Motions and
/// slip are derivatives by the distance, as w is: a positive creepage of a step back gives a
/// positive force. Energies are over |dq|. A turn keeps the tractions. The first turn of a patch
/// that is no ellipse, or has a bound of its own, prepares it from the other side, which costs what
/// the patch did.
/// tests/unit/turning_patch_test.cpp
///
/// Contact or friction may be lost at the end of a step or a shift, and return at that of another. In
/// between there are no tractions, resultants are 0, and the material forgets. What follows from a
/// resultant does not move in a step that ends so. A contact that returns in a step begins at its
/// start, from nothing; one that returns in a shift begins at its end, with the resultants.
/// tests/unit/lost_patch_test.cpp
///
/// Motions are at most 1e8 times the strain mu p0/G, beside which displacements keep their digits.
///
/// A copy continues with the same bits as the original, and independently of it; it shares the
/// matrices. So a step is tried on a copy. A step that throws leaves the state as it was before;
/// later ones differ by rounding at most. One object serves one thread.
/// Order: 2 in dq; tests/unit/patch_rolling_test.cpp
/// Cost of a step: that of steady rolling; plus that of a response if its length is another one
/// than before, or if the contact changes its size.
class PatchRolling {
 public:
  using Index = Eigen::Index;

  /// Begins at rest, without tractions.
  /// \param problem  its load is not used
  /// \param contact  as set_contact()
  /// \throws std::invalid_argument if a number is out of its range
  explicit PatchRolling(const SteadyPatch& problem, const ContactScale& contact = {});
  ~PatchRolling();
  PatchRolling(const PatchRolling& other);
  PatchRolling(PatchRolling&&) noexcept;
  /// Allocates nothing if one is a copy of the other and both have made a step.
  PatchRolling& operator=(const PatchRolling& other);
  PatchRolling& operator=(PatchRolling&&) noexcept;

  /// Sets the contact at the end of the next step, and of those after it. In that step its lengths
  /// change linearly; in a shift they cannot, but to and from 0. Only an ellipse changes its lengths.
  /// \param scale  half_width on both half-widths; 1e-4 ... 100, and the bound 1e-6 ... 1e6; or 0
  /// \throws std::invalid_argument outside the ranges, and for another shape
  void set_contact(const ContactScale& scale);

  /// Sets the speed of the next steps, by which friction falls that depends on slip.
  /// \param speed  V, > 0  [mm/s]
  /// \throws std::invalid_argument outside the range
  void set_speed(double speed);

  /// Whether the last step has a second solution, with other slip. Its search is that of
  /// SlipFriction::branch.
  bool has_second() const;

  /// The contact that was set last.
  const ContactScale& contact() const;

  /// Begins anew under tractions, in the contact that was set last. Its material has not slipped, and
  /// remembers the displacements by these tractions.
  /// \param tractions  along and across, at the centres; above the bound by rounding at most [N/mm^2]
  /// \throws std::invalid_argument for another number of cells, and above the bound
  void start_from(const Eigen::MatrixX2d& tractions);

  /// Shifts the bodies without rolling.
  /// \param load  shifts of the first body [mm] and its rotation [rad] in the place of motions, or
  ///              resultants
  /// \throws std::invalid_argument as validate(SteadyPatch), and of bodies that rolled, where friction
  ///         depends on slip: a shift has no speed; NotConverged
  void shift(const PatchLoad& load);

  /// Rolls over a step. A step in which stick and slip are not found is divided into halves, up to
  /// six times, on the way of which resultants over the largest go linearly to those prescribed.
  /// \param dq  from 1e-6 to 1e6 of the size, or less than 0 by as much to roll back  [mm]
  /// \throws std::invalid_argument if a number is out of its range, and for a step back where friction
  ///         depends on slip; NotConverged
  void roll(double dq, const PatchLoad& load);

  double distance() const;             ///< rolled so far, less what was rolled back  [mm]
  Eigen::VectorXd x() const;           ///< of the centres of cells  [mm]
  Eigen::VectorXd y() const;           ///< [mm]
  Eigen::VectorXd areas() const;       ///< of the cells  [mm^2]
  Eigen::VectorXd bound() const;       ///< at the centres  [N/mm^2]
  Eigen::MatrixX2d tractions() const;  ///< along and across, at the centres  [N/mm^2]
  Eigen::MatrixX2d slip() const;       ///< over dq [1]; by a shift [mm]; 0 where a cell sticks
  std::vector<bool> slips() const;
  double full_sliding() const;         ///< the force that the bound allows  [N]
  Eigen::Vector3d resultants() const;  ///< Fx, Fy [N], Mz about the centre [N mm]
  /// xi, eta [1] and phi [1/mm], as means over the step; of a shift in [mm] and [rad]
  Eigen::Vector3d motion() const;

  /// Half of the integral of tractions times displacements  [N mm]
  double elastic_energy() const;

  /// The energy that the last step lost, over |dq| [N]; in a shift, the energy [N mm]. In a step it is
  /// what the balance leaves, with the mean of the resultants at its ends,
  ///   -mean(Fx, Fy, Mz) (xi, eta, phi) dq/|dq| - (change of elastic energy)/|dq|,
  /// which includes what material takes along that leaves the contact with tractions. In a shift
  /// it is the work of friction by the tractions at the end, which is exact where slip keeps its
  /// direction.
  double dissipation() const;

  /// The derivatives of Fx, Fy [N] and Mz [N mm] at the end of the last step by its motions xi, eta
  /// [1] and phi [1/mm], or shifts [mm] and rotation [rad]. They are exact where no cell changes
  /// between stick and slip, and one-sided elsewhere. Of a divided step they are those of its last
  /// part. Cost: that of a system.
  /// \throws std::logic_error before the first step
  /// \throws std::invalid_argument where friction depends on slip
  Eigen::Matrix3d jacobian() const;

  int iterations() const;     ///< systems that the last step took
  Evidence evidence() const;  ///< of the last step; powers are energies per mm rolled  [N]
  double residual() const;   ///< largest error of the slip conditions, over the bound, <= 1e-7  [1]
  double condition() const;  ///< of the equations of the last step in adhesion; 0 before it

  /// A text of all that the next steps depend on. A PatchRolling of the same problem that restores
  /// it continues with the same bits, on the same machine in the same build.
  std::string save() const;

  /// \throws std::invalid_argument for a text that is not a saved state, is damaged, or belongs to
  ///         another version or problem; all stays as it was
  void restore(const SavedState& saved);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The distance rolled in a saved state  [mm].
/// \throws std::invalid_argument as PatchRolling::restore
double distance_of(const SavedState& saved, const SteadyPatch& problem);

}  // namespace microslip
