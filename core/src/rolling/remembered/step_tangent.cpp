// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_tangent.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

RowStep derivative(const RowResponse& response) {
  return {response, VectorXd::Zero(response.pressed().size())};
}

}  // namespace

StepTangent::StepTangent(const RowResponse& response)
    : slopes_{derivative(response), derivative(response)} {}

void StepTangent::begin(const RowMemory& from, bool asked) {
  asked_ = asked;
  for (RowStep& slope : slopes()) {
    slope.begin(from);
    RowMemory& memory = slope.memory;
    memory.points.set_zero();
    memory.nodes.set_zero();
    memory.traction.setZero();
    memory.stored = 0;
    memory.entry = 0;
    memory.shifts.reset();
    memory.relief.resize(0);
    memory.lead = 0;
    slope.conditions.bound.setZero();
  }
}

void StepTangent::replace(const Way& way, double mean_force) {
  if (!asked_) return;
  slopes_[1].mean_force = mean_force;
  const auto* shift = std::get_if<PrescribedShift>(&way.load);
  if (shift == nullptr) return;
  slopes_[0].shift = way.length;
  slopes_[1].shift = shift->value / way.length;
  for (RowStep& slope : slopes_) slope.work = mean_force * slope.shift;
}

void StepTangent::admit_slip() {
  for (RowStep& slope : slopes()) slope.memory.admit_slip();
}

void StepTangent::fade(const RowMemory& memory, double by_length) {
  if (!asked_) return;
  slopes_[1].entry = by_length * memory.entry;
  if (memory.relief.size() > 0) slopes_[1].conditions.bound = -by_length * memory.relief;
}

void StepTangent::end_fading() {
  end_entry();
  slopes_[1].conditions.bound.setZero();
}

/// The material comes to a node from farther ahead if the last substep is longer.
void StepTangent::solve(RowResponse& response, const RowStep& step, const Substep& substep) {
  for (std::size_t k = 0; k < count(); ++k) {
    RowStep& slope = slopes_[k];
    slope.recall(response, substep);
    if (k == 1 && substep.is_last) {
      for (Index i = 0; i < step.memory.row.size; ++i) {
        slope.conditions.offset[i] -= step.memory.slope_at_node(i, substep);
      }
    }
    response.active_set().solve_partition(slope.conditions,
                                          slope.of_partition(substep.load_slopes[k]),
                                          step.contact.zones, slope.contact);
  }
}

void StepTangent::displace(const RowResponse& response) {
  for (RowStep& slope : slopes()) slope.displace(response);
}

/// The sums of a step are
///   mean_force = sum F l,  work = sum (F S - P l),  stored = dx p . u / 2
/// over substeps of length l with the mean force F, the shift S and the work P of the pressure. The
/// length of the last substep alone depends on the length of the step.
void StepTangent::finish(const RowResponse& response, const RowStep& step, const Substep& substep,
                         bool stuck_again) {
  for (std::size_t k = 0; k < count(); ++k) {
    RowStep& slope = slopes_[k];
    slope.finish(response, substep, stuck_again);
    if (step.entry != 0) slope.displacement = response.displaced_by(slope.memory.traction);
    slope.memory.stored = step.memory.row.spacing *
                          (slope.memory.traction.dot(step.displacement) +
                           step.memory.traction.dot(slope.displacement)) /
                          2;
    slope.mean_force += slope.force * substep.length;
    if (k == 1 && substep.is_last) slope.mean_force += step.force;
    slope.work +=
        slope.force * step.creepage + step.force * slope.creepage - slope.pressed * substep.length;
    if (k == 1 && substep.is_last) slope.work -= step.pressed;
  }
}

StepSlopes StepTangent::slopes_of(const RowStep& slope, const TransientState& after, double length,
                                  double by_length) {
  const auto per_length = [&](double of_sum, double value) {
    return (of_sum - value * by_length) / length;
  };
  return {.force = slope.memory.row.spacing * slope.memory.traction.sum(),
          .mean_force = per_length(slope.mean_force, after.mean_force),
          .creepage = per_length(slope.shift, after.creepage),
          .dissipation = per_length(-slope.work - slope.memory.stored, after.dissipation)};
}

}  // namespace microslip
