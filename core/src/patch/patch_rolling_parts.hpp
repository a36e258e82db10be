// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "friction_rows.hpp"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/support/archive.hpp"
#include "patch_material.hpp"
#include "patch_scale.hpp"
#include "point_displacements.hpp"
#include "step_follower.hpp"
#include "step_ways.hpp"

namespace microslip {

/// All that stays the same. Lengths, tractions and energies are in units by which the size of the
/// problem's patch, the bound's peak and the shear modulus are 1.
struct PatchConstants {
  SteadyPatch problem;
  PatchUnits units;
  JoinedRows rows;
  PatchResponse::Matrix displacement;  ///< by tractions, at points
  Eigen::VectorXd limits;
  Eigen::Matrix3Xd resultants;

  explicit PatchConstants(const SteadyPatch& given);

  /// The factors of resultants in a contact of a size.
  static Eigen::Vector3d by_size(double size) { return size * size * Eigen::Vector3d(1, 1, size); }
};

/// The response in steps of one kind.
struct StepResponse {
  PatchStep step;
  PatchResponse of;
};

/// The limits by a bound, over the problem's.
struct StepLimits {
  double bound;
  Eigen::VectorXd values;
};

/// \throws std::invalid_argument outside the ranges of PatchRolling::set_contact()
void require_contact(const ContactScale& scale, const PatchShape& shape);

/// The state of a patch. If it rolls backward, all is that of the turned patch, which rolls
/// forward: x' = -x with
///   p' = (-px, py), (Fx, Fy, Mz)' = (-Fx, Fy, -Mz), and shifts likewise,
///   (xi, eta, phi)' = (xi, -eta, phi) and (sx, -sy) of the slip, over dq' = -dq.
struct PatchRolling::Parts {
  std::shared_ptr<const PatchConstants> constants;
  /// The constants of the turned patch, made at the first turn; an ellipse with Hertz's bound has its
  /// own.
  std::shared_ptr<const PatchConstants> turned_constants;
  bool backward = false;
  PatchMaterial material;
  std::optional<FrictionRows> friction = std::nullopt;  ///< if it depends on slip
  bool has_second = false;                ///< whether the last step has a second solution
  ContactScale now, next;                 ///< at the end of the last step, and of the next one
  PatchState state, before;               ///< at the end of the last step, and before it
  PatchStep step = {0};                   ///< the last one
  bool moved = false;                     ///< whether there was one
  std::optional<double> dissipation = 0;  ///< of the last step; computed when it is asked for

  Parts(std::shared_ptr<const PatchConstants> given, const ContactScale& contact);

  const PatchUnits& units() const { return constants->units; }
  const Eigen::Vector3d& motion_unit() const {
    return step.dq > 0 ? units().motion : units().shift;
  }

  /// The size of the present contact  [mm]
  double size() const { return now.half_width * units().size; }

  /// At the centres, over the problem's peak.
  Eigen::VectorXd bound() const;

  /// Integrals of tractions by the unknowns, over the size of the problem's patch.
  Eigen::VectorXd shares() const;
  Eigen::Vector3d resultants() const { return resultants_of(state, now.half_width); }
  double elastic_energy() const { return elastic_energy_of(state, now.half_width); }
  double lost();

  /// The response and the limits of the last step.
  const PatchResponse& last_response() { return response_of(step); }
  const Eigen::VectorXd& last_limits() { return friction ? slipping_limits : limits_at_rest(); }

  /// Those of the present contact, by the friction at rest.
  const Eigen::VectorXd& limits_at_rest() { return limits_of_bound(now.bound); }
  double condition() const { return response && now.carries() ? response->of.condition() : 0; }

  /// The constants of the patch that rolls forward.
  const PatchConstants& forward() const { return backward ? *turned_constants : *constants; }

  /// The same bodies at rest, without tractions, in the contact that was set last.
  Parts at_rest() const;

  /// Sets tractions before the first step, over the bound's peak.
  void start_from(const Eigen::MatrixX2d& tractions);

  /// The same bodies as they roll the other way. Their material remembers the displacements by the
  /// present tractions.
  Parts turned() const;

  // These convert between the contact's frame and this one, either way.
  PatchLoad in_frame(const PatchLoad& load, bool rolls) const;
  Eigen::Vector3d resultant_signs() const;
  Eigen::Vector3d motion_signs() const;  ///< of the last step
  Eigen::VectorXd cells_in_frame(const Eigen::VectorXd& of_cells) const;
  Eigen::MatrixX2d vectors_in_frame(const Eigen::MatrixX2d& of_cells,
                                    const Eigen::Vector3d& signs) const;

  /// \param load  in the contact's frame
  /// \throws std::invalid_argument if a number is out of its range
  void require_load(const PatchLoad& load, bool rolls) const { scaled(load, rolls); }

  /// \param dq     0 for a shift
  /// \param discs  where friction does not depend on slip
  void take(double dq, const PatchLoad& load, Discs discs = Discs::of_solution);

  /// Takes a step; one that is not solved is divided into halves, and these again. The last ones
  /// may keep their discs: where several cells about a pole begin to slip at once, tractions fall,
  /// and there may be no solution near with discs that shrink, however short the step.
  void roll(double dq, const PatchLoad& load, int divisions);

  /// Shifts the bodies without rolling. Those that touch anew are at rest then, or carry resultants.
  void shift(const PatchLoad& load);

  void archive(Archive& archive);

 private:
  void begin(const Eigen::VectorXd& unknowns, double distance);
  Eigen::Vector3d resultants_of(const PatchState& of, double size) const;
  double elastic_energy_of(const PatchState& of, double size) const;
  const PatchResponse& response_of(const PatchStep& wanted);
  const Eigen::VectorXd& limits_of_bound(double bound);
  PatchLoad scaled(const PatchLoad& load, bool rolls) const;
  void lose(double dq, const PatchLoad& load);
  PatchLoad middle_of(const PatchLoad& load, const ContactScale& middle) const;
  void solve(const PatchResponse& of, const Eigen::VectorXd& limits, const PatchLoad& load,
             Discs discs);
  void solve_slipping(const PatchStep& taken, const PatchResponse& of, const PatchLoad& load,
                      FrictionRows& rows);
  void begin_friction();
  void archive_follower(Archive& archive);
  void prepare_follower(const PatchResponse& of, const Eigen::VectorXd& limits_now,
                        const PatchState& with, const PatchLoad& load);

  std::shared_ptr<const StepResponse> response = nullptr;
  std::shared_ptr<const StepLimits> limits = nullptr;
  /// The follower of this response and these limits; one that has lost them stays, so that an
  /// assignment has its room.
  std::optional<StepFollower> follower = std::nullopt;
  bool follows = false;  ///< whether the follower may be used
  PointDisplacements displacements;
  ImposedSlip imposed;
  PatchState trial;                 ///< of a step until it is solved
  Eigen::VectorXd slipping_limits;  ///< of the last step, if friction depends on slip
};

}  // namespace microslip
