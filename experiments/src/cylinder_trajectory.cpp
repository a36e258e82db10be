// SPDX-License-Identifier: GPL-3.0-or-later
#include "cylinder_trajectory.hpp"

namespace microslip::experiments {

using Eigen::Index;

namespace {

Eigen::Array3d values_of(const CylinderState& s) {
  return {s.position, s.velocity, s.angular_velocity};
}

}  // namespace

Trajectory trajectory(RollingCylinder body, const Cylinder& cylinder,
                      const Eigen::VectorXd& times) {
  const auto rates = [&](const CylinderState& s) {
    return Eigen::Array3d(s.velocity, (cylinder.slope_force + s.force) / cylinder.mass,
                          -cylinder.radius * s.force / cylinder.inertia);
  };
  Trajectory result{Eigen::ArrayX3d(times.size(), 3), 0, 0};
  CylinderState before = body.state();
  for (Index i = 0; i < times.size(); ++i) {
    for (; body.state().time < times[i]; ++result.steps) {
      before = body.state();
      body.step();
    }
    const CylinderState& after = body.state();
    const double step = after.time - before.time;
    const double s = (times[i] - before.time) / step;
    const double r = 1 - s;
    result.values.row(i) = r * r * (1 + 2 * s) * values_of(before) +
                           s * s * (1 + 2 * r) * values_of(after) +
                           step * s * r * (r * rates(before) - s * rates(after));
  }
  result.contact_steps = static_cast<double>(body.contact_steps());
  return result;
}

Eigen::Array3d errors_of(const Trajectory& coarse, const Trajectory& fine) {
  const Eigen::Array3d scale = fine.values.row(fine.values.rows() - 1);
  return (coarse.values - fine.values).square().colwise().mean().sqrt().transpose() / scale;
}

}  // namespace microslip::experiments
