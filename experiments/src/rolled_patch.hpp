// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <variant>

#include "microslip/patch/patch_rolling.hpp"
#include "microslip/patch/standard_patch.hpp"
#include "microslip/patch/traction_table.hpp"
#include "microslip/rolling/patch_history.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip::experiments {

/// The end of a step or a shift.
struct PatchStepEnd {
  Eigen::Vector3d resultants = Eigen::Vector3d::Zero();
  Eigen::Vector3d motion = Eigen::Vector3d::Zero();
  double slip_share = 0;   ///< [1]
  double dissipation = 0;  ///< energy lost per mm rolled [N]; in a shift [N mm]
  int iterations = 0;
  ContactScale contact = {};  ///< over the problem's
  bool has_second = false;    ///< of a friction that depends on slip
  Evidence evidence = {};
};

/// A patch that rolls or is shifted by one of the schemes, with evidence for each step.
class RolledPatch {
 public:
  /// Begins without tractions.
  /// \param patch    its load is not used
  /// \param contact  over the problem's, which it is by all but Remembered
  RolledPatch(const SteadyPatch& patch, const AdvectionScheme& scheme, const ContactScale& contact);

  /// Begins with tractions, in the contact that was given.
  PatchStepEnd start_from(const TractionTable& tractions);

  /// Continues from a saved state, with Remembered.
  /// \param load  with which the next step begins
  PatchStepEnd restore(const SavedState& state, const PatchLoad& load);

  /// \param contact  at the end of the shift, of the same size, or lost or begun; none if it stays
  PatchStepEnd shift(const PatchLoad& load, const std::optional<ContactScale>& contact = {});

  /// Rolls over a step of a run.
  /// \param from, to  its ends along the way  [mm]
  /// \param length    between them, free of their rounding  [mm]
  PatchStepEnd roll(const PatchHistory& loads, double from, double to, double length);

  /// The contact itself with Remembered; nullptr otherwise.
  const PatchRolling* remembered() const { return std::get_if<PatchRolling>(&rolling_); }

  double full_sliding() const;  ///< of the present contact  [N]
  Table tractions() const;
  Table edges() const;

  /// Of the equations of the last step, with Remembered.
  std::optional<double> condition() const;

 private:
  using AnyRolling = std::variant<PatchRolling, RectangleRolling>;

  static AnyRolling rolling_of(const SteadyPatch& patch, const AdvectionScheme& scheme,
                               const ContactScale& contact);
  PatchStepEnd end() const;
  PatchStepEnd end(const PatchLoad& load) const;

  SteadyPatch patch_;
  AnyRolling rolling_;
};

/// The worst evidence of all steps.
struct WorstOfPatch {
  Evidence evidence;
  int iterations = 0;

  void include(const PatchStepEnd& end) {
    evidence = worst_of(evidence, end.evidence);
    iterations = std::max(iterations, end.iterations);
  }
};

/// The largest change of a motion, by its kind, over the largest motion of that kind.
struct MotionChange {
  double size;  ///< of the patch  [mm]
  Eigen::Vector3d changes = Eigen::Vector3d::Zero(), largest = Eigen::Vector3d::Zero();

  void include(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
  double relative() const;
};

/// The same contact on rows and elements that are a third fewer, as long as it is solved there. The
/// change is the largest one of resultants after each step, over the largest resultants; of the
/// shifts, and of the way that is crept, over the largest; and of motions in the last step.
class CoarsePatch {
 public:
  /// As RolledPatch.
  CoarsePatch(const SteadyPatch& patch, const AdvectionScheme& scheme, const ContactScale& contact);

  void start_from(const TractionTable& tractions) {
    if (rolled_) rolled_->start_from(tractions);
  }

  /// \param length  of the step; 1 for a shift  [mm]
  /// \param step    of RolledPatch
  template <class Step>
  void follow(const PatchStepEnd& fine, double length, const Step& step) {
    if (!rolled_) return;
    try {
      compare(fine, step(*rolled_), length);
    } catch (const NotConverged&) {
      rolled_.reset();
    }
  }

  double change() const;

 private:
  void compare(const PatchStepEnd& fine, const PatchStepEnd& coarse, double length);

  PatchBound bound_;
  std::optional<RolledPatch> rolled_;
  double of_resultants_ = 0;
  Eigen::Vector3d path_ = Eigen::Vector3d::Zero(), coarse_path_ = Eigen::Vector3d::Zero();
  MotionChange of_path_{bound_.size()}, of_last_{bound_.size()};
};

}  // namespace microslip::experiments
