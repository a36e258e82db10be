// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "microslip/rolling/step_jacobian.hpp"
#include "microslip/rolling/transient_problem.hpp"
#include "row_step.hpp"

namespace microslip {

/// The derivatives of a step by its load and by its length, for the partitions that the step has
/// found. Without a step that asks for them, no function solves anything.
class StepTangent {
 public:
  explicit StepTangent(const RowResponse& response);

  /// \param asked  whether the step asks for derivatives
  void begin(const RowMemory& from, bool asked);

  /// Begins with a contact that is lost on the way, or returns under a force. The mean force does not
  /// depend on the load, and a prescribed shift is made all the same.
  /// \param mean_force  over the step  [N/mm]
  void replace(const Way& way, double mean_force);

  /// As RowMemory::admit_slip.
  void admit_slip();

  /// Lets what the last shift left at the leading edge fade with the length of the step.
  /// \param by_length  derivative of the fraction that is left  [1/mm]
  /// \param memory     of the step when the substep began
  void fade(const RowMemory& memory, double by_length);

  /// Holds the traction at the entry at 0.
  void end_entry() { slopes_[1].entry = 0; }

  /// Holds at 0 what the last shift left.
  void end_fading();

  /// Solves for the derivatives of the contact that a step has solved.
  void solve(RowResponse& response, const RowStep& step, const Substep& substep);

  /// The derivatives of that contact, for the mean over partitions.
  std::array<RolledContact*, 2> contacts() { return {&slopes_[0], &slopes_[1]}; }

  /// The number of derivatives: none or two.
  std::size_t count() const { return asked_ ? slopes_.size() : 0; }

  /// Computes the displacements by the partition's solution.
  void displace(const RowResponse& response);

  /// Moves to the end of a substep, whither the step has moved.
  void finish(const RowResponse& response, const RowStep& step, const Substep& substep,
              bool stuck_again);

  /// Derivatives of the results of a step, which are sums over its length.
  /// \param length  of the step  [mm]
  StepSlopes by_load(const TransientState& after, double length) const {
    return slopes_of(slopes_[0], after, length, 0);
  }
  StepSlopes by_length(const TransientState& after, double length) const {
    return slopes_of(slopes_[1], after, length, 1);
  }

 private:
  static StepSlopes slopes_of(const RowStep& slope, const TransientState& after, double length,
                              double by_length);

  std::span<RowStep> slopes() { return std::span(slopes_).first(count()); }

  bool asked_ = false;
  std::array<RowStep, 2> slopes_;  ///< by load and by length
};

}  // namespace microslip
