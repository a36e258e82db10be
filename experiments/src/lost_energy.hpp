// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "microslip/rolling/transient_problem.hpp"

namespace microslip::experiments {

/// The energy that a run loses, and how uncertain it is. Friction never gives energy back, so that
/// a negative loss is an error of the energies of elements; the sum of negative ones is of the size
/// of the error of the whole loss. A force that changes much in a step is in truth no linear
/// function of the shift, as the work of the step has it; there, the loss by the tractions at the
/// end of the step is another estimate.
class LostEnergy {
 public:
  /// The loss of a step. Units are those of a contact of lines.
  struct Step {
    double length;       ///< [mm]
    double rate;         ///< per mm rolled  [N/mm]
    double power;        ///< of the resultants, in size  [N/mm]
    double sudden_rate;  ///< another estimate of the rate, where the force changes much  [N/mm]
  };

  /// \param patch  whether energies are those of a whole patch, in N mm and N
  explicit LostEnergy(bool patch = false)
      : energy_unit_(patch ? "N mm" : "N"), rate_unit_(patch ? "N" : "N/mm") {}

  void add(const Step& step);

  /// Adds a step.
  /// \param state         at its end
  /// \param length        [mm]
  /// \param force_before  at its begin  [N/mm]
  /// \param full_sliding  the largest force of the contact  [N/mm]
  void add(const TransientState& state, double length, double force_before, double full_sliding);

  /// Adds the loss of a shift without rolling  [N]
  void add_shift(double energy) { (energy < 0 ? gained_ : lost_) += std::abs(energy); }

  double sum() const { return lost_ - gained_; }  ///< per mm width  [N]

  /// A sentence if more than a twentieth is uncertain, of the sum or of the largest rate.
  std::optional<std::string> doubt() const;

 private:
  std::string energy_unit_, rate_unit_;
  double lost_ = 0, gained_ = 0;  ///< sums of the positive and negative losses  [N]
  double sudden_ = 0;            ///< differences of the estimates where the force changes much  [N]
  double most_ = 0, least_ = 0;  ///< of the losses per length  [N/mm]
  double power_ = 0;             ///< the largest one of the force  [N/mm]
};

}  // namespace microslip::experiments
